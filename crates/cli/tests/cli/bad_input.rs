//! One test for each sort of bad input: the message names what, where, what
//! was expected, and what to do.

use crate::{Capwalk, assert_has};

#[test]
fn unknown_scene() {
    let message = Capwalk::new("unknown_scene").error("render teapot");
    assert_has(&message, &["no file teapot", "leaf", "lattice-shadow"]);
}

#[test]
fn unknown_parameter_lists_near_names() {
    let capwalk = Capwalk::new("unknown_parameter");
    let message = capwalk.error("gradient ball -p bal.translate.x");
    assert_has(
        &message,
        &["bal.translate.x", "did you mean", "ball.translate.x"],
    );
}

#[test]
fn names_of_other_renderers_are_explained() {
    let capwalk = Capwalk::new("foreign_names");
    let message = capwalk.error("gradient ball -p ball.vertex_positions");
    assert_has(&message, &["is an array", "reverse mode gives"]);
    let message = capwalk.error("gradient ball -p ball.vertexPositions");
    assert_has(&message, &["did you mean `ball.vertex_positions`?"]);
}

#[test]
fn image_size() {
    let capwalk = Capwalk::new("image_size");
    let none = capwalk.error("render leaf --size 0x4");
    assert_has(&none, &["0 x 4 pixels", "at least 1 x 1"]);
    let billion = capwalk.error("render leaf --size 100000x10000");
    assert_has(&billion, &["100000 x 10000 pixels", "at most"]);
    assert_has(&capwalk.error("render leaf --size 12"), &["640x480"]);
}

/// In a scene that is a hundred million times as wide, light leaks around a shape.
#[test]
fn shapes_too_small_for_their_scene_are_refused() {
    let capwalk = Capwalk::new("too_small");
    let far = |distance: f64| {
        format!("render leaf --spp 1 --size 8x6 -o a.npz --set floor.translate.y=-{distance}")
    };
    let message = capwalk.error(&far(3e9));
    assert_has(
        &message,
        &["is only", "nearer than 0.3,", "light would leak"],
    );
    let finished = capwalk.run(&far(3e6));
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    // A strip is as narrow as it is.
    let scene = |width: f64| {
        let place = format!(r#"<transform name="to_world"><scale y="{width}"/></transform>"#);
        format!(
            r#"<scene version="3.0.0"><integrator type="path"/><sensor type="perspective"/>
<shape type="rectangle" id="strip">{place}</shape></scene>"#
        )
    };
    capwalk.write("narrow.xml", &scene(1e-9));
    capwalk.write("wider.xml", &scene(1e-6));
    let render = |name: &str| format!("render {name}.xml --spp 1 --size 8x6 -o b.npz");
    let message = capwalk.error(&render("narrow"));
    assert_has(&message, &["\"strip\" is only", "narrow.xml:2:1"]);
    let finished = capwalk.run(&render("wider"));
    assert_eq!(finished.status, 0, "{}", finished.stderr);
}

/// A step that rounding swallows is no reference.
#[test]
fn a_step_that_changes_nothing_is_refused() {
    let capwalk = Capwalk::new("no_step");
    let message = capwalk.error("check leaf -p leaf.translate.x --step 1e-300 --spp 2 -o a.npz");
    assert_has(
        &message,
        &["1e-300 changes nothing", "Choose a larger step"],
    );
}

/// Of what changes that little or that much, errors are no numbers: nobody has given a step.
#[test]
fn factors_without_measure_are_refused() {
    let capwalk = Capwalk::new("no_measure");
    for expression in [
        "1e-300*leaf.translate.x",
        "1e300*leaf.bsdf.reflectance.value",
    ] {
        for command in ["check", "gradient", "backward --loss l2 --target a.npz"] {
            let typed = match command.starts_with("backward") {
                true => {
                    capwalk.run("render leaf --size 4x3 --spp 1 -o a.npz");
                    format!("{command} leaf --size 4x3 --spp 2 -p {expression}")
                }
                false => format!("{command} leaf --size 4x3 --spp 2 -p {expression}"),
            };
            let message = capwalk.error(&typed);
            assert_has(
                &message,
                &[expression, "for one unit", "use another factor"],
            );
            assert!(!message.contains("`step`"), "{message}");
        }
    }
}

/// A negative number is a value, and no option that nobody knows.
#[test]
fn negative_numbers_are_values() {
    let capwalk = Capwalk::new("negative_numbers");
    for (typed, expected) in [
        ("render leaf --spp -1", "-1 is not in 1.."),
        ("render leaf --seed -1", "expected a whole number from 0"),
        ("render leaf --size -1x3", "expected WIDTHxHEIGHT"),
        ("render leaf -t -1", "expected a number from 1 to 4096"),
        (
            "optimize job.toml --pause-after -1",
            "expected a whole number from 1",
        ),
    ] {
        let message = capwalk.error(typed);
        assert!(
            message.contains(expected) && !message.contains("-- -1"),
            "{message}"
        );
    }
}

/// Refused before its memory is taken, where the system says how much there is.
#[test]
#[cfg(target_os = "linux")]
fn images_beyond_memory() {
    let capwalk = Capwalk::new("images_beyond_memory");
    let free = std::fs::read_to_string("/proc/meminfo").expect("readable");
    let line = free.lines().find(|line| line.starts_with("MemAvailable:"));
    let kib = line.and_then(|line| line.split_whitespace().nth(1));
    let kib: u64 = kib.expect("a number").parse().expect("a number");
    let largest = 1 << 26; // Pixels that films may have.
    let width = largest / 2000;
    if kib << 10 > largest * 500 {
        return; // There is memory for the largest image.
    }
    let size = format!("--size {width}x2000 --spp 1");
    for command in [
        "render leaf",
        "gradient leaf -p leaf.translate.x",
        "check leaf -p leaf.translate.x",
    ] {
        let message = capwalk.error(&format!("{command} {size}"));
        assert_has(
            &message,
            &["x 2000 pixels need up to", "MiB are free", "crop windows"],
        );
    }
    // Before the target is read, or rendered.
    let backward = format!("backward leaf --loss l2 --target none.exr {size}");
    let job = format!(
        "scene = \"leaf\"\nsize = [{width}, 2000]\niterations = 2\nspp = 4\n[target]\nspp = 4\n\
         [target.set]\n\"leaf.translate.x\" = 0.2\n[[parameter]]\nname = \"leaf.translate.x\"\n\
         [optimizer]\nlr = 0.02\n"
    );
    capwalk.write("job.toml", &job);
    for command in [&*backward, "optimize job.toml"] {
        let message = capwalk.error(command);
        assert_has(&message, &["x 2000 pixels need up to", "MiB are free"]);
    }
}

/// Also under two names of one place.
#[test]
fn outputs_named_twice() {
    let capwalk = Capwalk::new("outputs_named_twice");
    for names in ["a.npz,a.npz", "a.npz,./a.npz", "b.exr,a.npz,new/../b.exr"] {
        let message = capwalk.error(&format!("render leaf --size 4x4 --spp 1 -o {names}"));
        assert_has(&message, &["is to be written twice", "name each file once"]);
    }
}

/// Nothing waits for a pipe, or reads a device to its end.
#[test]
#[cfg(unix)]
fn what_is_no_file() {
    let capwalk = Capwalk::new("what_is_no_file");
    let pipe = capwalk.path("pipe.npz");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.expect("there is mkfifo").success());
    let options = "-p leaf.translate.x --size 4x4 --spp 1";
    for (name, command) in [
        ("pipe.npz", "render pipe.npz".to_owned()),
        ("/dev/zero", "info /dev/zero".into()),
        ("/dev/zero", "optimize /dev/zero".into()),
        ("pipe.npz", "compare pipe.npz pipe.npz".into()),
        (
            "pipe.npz",
            format!("backward leaf {options} --adjoint pipe.npz"),
        ),
        (
            "pipe.npz",
            format!("backward leaf {options} --loss l2 --target pipe.npz"),
        ),
        ("/dev/zero", "gradient leaf --motion leaf=/dev/zero".into()),
        ("pipe.npz", "gradient leaf --motion leaf=pipe.npz".into()),
    ] {
        let message = capwalk.error(&command);
        assert_has(&message, &[name, "write its contents into a file"]);
    }
    // Named by a scene file.
    for object in [
        r#"<include filename="pipe.npz"/>"#,
        r#"<shape type="ply"><string name="filename" value="pipe.npz"/></shape>"#,
        r#"<bsdf type="diffuse"><texture type="bitmap" name="reflectance"><string name="filename" value="pipe.npz"/></texture></bsdf>"#,
    ] {
        let scene = format!(
            r#"<scene version="3.0.0"><integrator type="path"/><sensor type="perspective"/>{object}</scene>"#
        );
        capwalk.write("scene.xml", &scene);
        let message = capwalk.error("info scene.xml");
        let expected = ["scene.xml:1:", "pipe.npz", "write its contents into a file"];
        assert_has(&message, &expected);
    }
}

#[test]
fn unknown_sensors() {
    let message = Capwalk::new("unknown_sensors").error("render leaf --sensor 1");
    assert_has(&message, &["the scene has no sensor 1", "it has 1"]);
}

/// Found before any work is done.
#[test]
fn unwritable_outputs() {
    let capwalk = Capwalk::new("unwritable");
    capwalk.write("file", "");
    let long = "render leaf --size 2000x2000 --spp 100000 -o";
    let message = capwalk.error(&format!("{long} file/image.exr"));
    assert_has(&message, &["cannot write file/image.exr", "because"]);
    let message = capwalk.error(&format!("{long} /proc/image.exr"));
    assert_has(&message, &["cannot write /proc/image.exr"]);
    std::fs::create_dir(capwalk.path("folder.png")).expect("writable");
    let message = capwalk.error(&format!("{long} folder.png"));
    assert_has(&message, &["cannot write folder.png", "folder"]);
}

#[test]
fn unknown_image_format() {
    let message = Capwalk::new("format").error("render leaf -o image.bmp");
    assert_has(&message, &["image.bmp", ".exr, .npz, .png, .svg"]);
}

#[test]
fn broken_scene_files_show_the_place() {
    let capwalk = Capwalk::new("broken_file");
    capwalk.write(
        "broken.xml",
        "<scene version=\"3.0.0\"><integrator type=\"path\"/><sensor type=\"perspective\"/>\n  <shape type=\"teapot\"/>\n</scene>\n",
    );
    let message = capwalk.error("info broken.xml");
    assert_has(
        &message,
        &["--> broken.xml:2:", "2 |   <shape type=\"teapot\"/>", "^"],
    );
    let message = capwalk.error("info broken.xml -D nothing");
    assert_has(&message, &["NAME=VALUE"]);
}

#[test]
fn definitions_need_a_file() {
    let message = Capwalk::new("define").error("info leaf -D spp=4");
    assert_has(&message, &["leaf", "nothing to define", "--export"]);
}

#[test]
fn velocities_that_do_not_fit() {
    let capwalk = Capwalk::new("velocities");
    capwalk.write("two.txt", "0 0 0\n1 0 0\n");
    capwalk.write("words.txt", "0 0 0\n1 zero 0\n");
    let message = capwalk.error("gradient leaf --motion leaf=two.txt");
    assert_has(&message, &["two.txt", "2 velocities", "3 vertices"]);
    let message = capwalk.error("gradient leaf --motion leaf=words.txt");
    assert_has(&message, &["words.txt", "line 2", "three numbers"]);
    capwalk.write("endless.txt", "0 0 0\n1 inf 0\n0 0 0\n");
    let message = capwalk.error("gradient leaf --motion leaf=endless.txt");
    assert_has(&message, &["endless.txt", "vertex 1", "finite numbers"]);
    let message = capwalk.error("gradient leaf --motion leaf=missing.npy");
    assert_has(&message, &["missing.npy"]);
    let message = capwalk.error("gradient leaf --motion loaf=two.txt");
    assert_has(&message, &["loaf", "did you mean", "leaf"]);
}

#[test]
fn motions_that_cancel() {
    let mut command = Capwalk::new("cancel").command("gradient leaf -p");
    let output = command.arg("leaf.translate.x - leaf.translate.x").output();
    let output = output.expect("it starts");
    assert_eq!(output.status.code(), Some(3));
    let message = String::from_utf8(output.stderr).expect("text");
    assert_has(&message, &["nothing changes"]);
}

/// Headers are read before pixels: the size is wrong, whatever else is.
#[test]
fn images_of_another_size_are_not_unpacked() {
    let capwalk = Capwalk::new("damaged_images");
    capwalk.run("render leaf --size 9x9 --spp 2 -o wrong.npz");
    capwalk.run("render leaf --size 8x6 --spp 2 -o other.npz");
    let mut bytes = capwalk.bytes("wrong.npz");
    // Among the numbers of the first layer.
    bytes[300..308].fill(0xff);
    std::fs::write(capwalk.path("wrong.npz"), &bytes).expect("writable");
    let backward = "backward leaf --size 8x6 --spp 2 -p leaf.translate.x";
    for command in [
        format!("{backward} --adjoint wrong.npz"),
        format!("{backward} --loss l2 --target wrong.npz"),
    ] {
        let message = capwalk.error(&command);
        assert_has(&message, &["wrong.npz", "9 x 9 pixels; expected 8 x 6"]);
    }
    let message = capwalk.error("compare wrong.npz other.npz");
    assert_has(&message, &["9 x 9 and 8 x 6"]);
    // Where it would be used, the damage is found.
    let message = capwalk.error("compare wrong.npz wrong.npz");
    assert_has(&message, &["wrong.npz", "\"value\" is damaged"]);
}

/// Coefficients that are finite add up to what is not.
#[test]
fn infinite_coefficients_are_refused() {
    let capwalk = Capwalk::new("infinite_coefficients");
    capwalk.run("render leaf --size 8x6 --spp 2 -o a.npz");
    let sum = "1e308*leaf.translate.x+1e308*leaf.translate.x";
    let product = "1e200*1e200*leaf.translate.x";
    let options = "--size 8x6 --spp 2";
    for expression in [sum, product] {
        for command in [
            format!("gradient leaf {options} -p {expression}"),
            format!("check leaf {options} -p {expression}"),
            format!("backward leaf {options} --adjoint a.npz -p {expression}"),
            format!("render leaf {options} --set {expression}=0.1"),
        ] {
            let message = capwalk.error(&command);
            assert_has(&message, &[expression, "add up to an infinite velocity"]);
        }
        capwalk.write(
            "job.toml",
            &format!(
                "scene = \"leaf\"\nsize = [8, 6]\niterations = 1\nspp = 2\n\
                 target = {{ set = {{ \"leaf.translate.x\" = 0.1 }}, spp = 2 }}\n\
                 parameter = [{{ name = \"{expression}\" }}]\noptimizer = {{ lr = 0.1 }}\n"
            ),
        );
        let message = capwalk.error("optimize job.toml");
        assert_has(&message, &["job.toml:6:", "add up to an infinite velocity"]);
    }
}

/// One sample with these numbers would never end.
#[test]
fn endless_samples_are_refused() {
    let capwalk = Capwalk::new("endless_samples");
    let scene = |integrator: &str| {
        format!(
            "<scene version=\"3.0.0\">\n{integrator}</integrator><sensor type=\"perspective\"/>\
             <emitter type=\"constant\"/><shape type=\"cube\"/></scene>"
        )
    };
    let integer = |name: &str, value: u32| format!("<integer name=\"{name}\" value=\"{value}\"/>");
    for name in ["emitter_samples", "bsdf_samples", "shading_samples"] {
        let count = integer(name, 2_000_000_000);
        capwalk.write(
            "direct.xml",
            &scene(&format!("<integrator type=\"direct\">{count}")),
        );
        let message = capwalk.error("render direct.xml --size 8x6 --spp 1");
        assert_has(&message, &["direct.xml:2:", name, "from 0 to 4096"]);
    }
    let depth = integer("rr_depth", 1_000_000);
    capwalk.write(
        "path.xml",
        &scene(&format!("<integrator type=\"path\">{depth}")),
    );
    let message = capwalk.error("render path.xml --size 8x6 --spp 1");
    assert_has(
        &message,
        &["path.xml:2:", "\"rr_depth\" is 1000000", "max_depth"],
    );
    let ended = format!("{depth}{}", integer("max_depth", 3));
    capwalk.write(
        "path.xml",
        &scene(&format!("<integrator type=\"path\">{ended}")),
    );
    capwalk.json("render path.xml --size 8x6 --spp 1 --json");
}

/// Names that are too long for a table.
#[test]
fn long_names_are_refused_or_cut() {
    let capwalk = Capwalk::new("long_names");
    let scene = |id: &str| {
        format!(
            "<scene version=\"3.0.0\"><integrator type=\"path\"/><sensor type=\"perspective\"/>\
             <emitter type=\"constant\"/>\n<shape type=\"cube\" id=\"{id}\"/></scene>"
        )
    };
    capwalk.write("long.xml", &scene(&"x".repeat(70_000)));
    let message = capwalk.error("info long.xml");
    assert_has(
        &message,
        &["long.xml:2:", "has 70000 characters", "at most 1000"],
    );
    assert!(message.len() < 2000, "{message}");
    // Names of other files are as long as these have them.
    let ply = format!(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
         property float z\nproperty float {}_r\nelement face 1\n\
         property list uchar int vertex_indices\nend_header\n\
         0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n",
        "y".repeat(900)
    );
    capwalk.write("mesh.ply", &ply);
    let file = "<string name=\"filename\" value=\"mesh.ply\"/></shape></scene>";
    let mesh = scene("mesh").replace("type=\"cube\"", "type=\"ply\"");
    capwalk.write("mesh.xml", &mesh.replace("/></scene>", &format!(">{file}")));
    let finished = capwalk.run("info mesh.xml --all");
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert_has(&finished.stdout, &["yyyy…"]);
}
