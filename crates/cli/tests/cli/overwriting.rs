//! What was read is never written, whatever command reads and writes it.

use crate::{Capwalk, assert_has};

/// A box with a texture and a sky, each a file of its own, and a material from another one.
const SCENE: &str = r#"<scene version="3.0.0"><integrator type="path"/>
<sensor type="perspective"><transform name="to_world"><translate z="-6"/></transform>
<film type="hdrfilm"><integer name="width" value="8"/><integer name="height" value="6"/></film>
</sensor><emitter type="envmap"><string name="filename" value="sky.exr"/></emitter>
<include filename="part.xml"/></scene>"#;

const PART: &str = r#"<scene version="3.0.0"><shape type="cube" id="box"><bsdf type="diffuse">
<texture name="reflectance" type="bitmap"><string name="filename" value="texture.png"/></texture>
</bsdf></shape></scene>"#;

/// A folder with the scene and its files, and images of its size.
fn folder(name: &str) -> Capwalk {
    let capwalk = Capwalk::new(name);
    capwalk.run("render leaf --size 8x6 --spp 2 -o sky.exr,texture.png,t.npz,a.npz");
    capwalk.run("render leaf --size 8x6 --spp 2 --seed 3 -o b.exr");
    capwalk.write("scene.xml", SCENE);
    capwalk.write("part.xml", PART);
    capwalk
}

#[test]
fn inputs_are_never_overwritten() {
    let capwalk = folder("overwriting");
    capwalk.write("motion.txt", &"0 0 1\n".repeat(8));
    std::fs::copy(capwalk.path("motion.txt"), capwalk.path("motion.npz")).expect("a copy");
    std::fs::copy(capwalk.path("texture.png"), capwalk.path("default.png")).expect("a copy");
    let own = SCENE.replace("part.xml", "own.xml");
    capwalk.write("default.xml", &own);
    capwalk.write("own.xml", &PART.replace("texture.png", "default.png"));
    let parameter = "-p box.bsdf.reflectance.value";
    for (command, file) in [
        ("render scene.xml --spp 2 -o texture.png", "texture.png"),
        ("render scene.xml --spp 2 -o ./out.exr,sky.exr", "sky.exr"),
        // The files that are written if none are named.
        ("render default.xml --spp 2", "default.png"),
        (
            "check scene.xml -p box.translate.x --spp 2 -o texture.png",
            "texture.png",
        ),
        (
            "gradient scene.xml --motion box=motion.npz --spp 2 -o motion.npz",
            "motion.npz",
        ),
        (
            "backward scene.xml --spp 2 --loss l2 --target t.npz -o t.npz",
            "t.npz",
        ),
        (
            "backward scene.xml --spp 2 --adjoint a.npz --layer value -o a.npz",
            "a.npz",
        ),
        ("compare a.npz b.exr -o b.exr", "b.exr"),
        ("compare a.npz b.exr -o c.png,a.npz", "a.npz"),
    ] {
        let command = match command.starts_with("backward") {
            true => format!("{command} {parameter}"),
            false => command.to_owned(),
        };
        let before = capwalk.bytes(file);
        let message = capwalk.error(&command);
        let expected = [
            "would overwrite",
            file,
            "what is read is never written",
            "(-o)",
        ];
        assert_has(&message, &expected);
        assert_eq!(capwalk.bytes(file), before, "{command}");
    }
    // Other files are replaced as ever.
    for _ in 0..2 {
        capwalk.json("render scene.xml --spp 2 -o new.png --json");
    }
}

/// Folders that were made for files go with them where one of these is refused.
#[test]
fn refused_outputs_leave_no_folder() {
    let capwalk = folder("overwriting_folders");
    for files in [
        "new/inside/a.png,texture.png",
        "new/a.png,new/a.png",
        "new/a.npz,new/a.txt",
    ] {
        capwalk.error(&format!("render scene.xml --spp 2 -o {files}"));
        assert!(!capwalk.path("new").exists(), "{files}");
    }
}

/// A link to a file is that file.
#[cfg(unix)]
#[test]
fn links_are_what_they_lead_to() {
    let capwalk = folder("overwriting_links");
    std::os::unix::fs::symlink("texture.png", capwalk.path("link.png")).expect("linkable");
    std::fs::hard_link(capwalk.path("texture.png"), capwalk.path("hard.png")).expect("linkable");
    for file in ["link.png", "hard.png"] {
        let message = capwalk.error(&format!("render scene.xml --spp 2 -o {file}"));
        assert_has(&message, &["would overwrite", "texture.png"]);
    }
}

/// Also what a scene of a job reads, before anything is rendered.
#[test]
fn jobs_do_not_overwrite_what_their_scenes_read() {
    let capwalk = folder("overwriting_jobs");
    std::fs::create_dir_all(capwalk.path("run/scene_textures")).expect("a folder");
    let texture = "run/scene_textures/texture.png";
    std::fs::rename(capwalk.path("texture.png"), capwalk.path(texture)).expect("movable");
    capwalk.write("part.xml", &PART.replace("texture.png", texture));
    capwalk.write(
        "job.toml",
        "scene = \"scene.xml\"\niterations = 1\nspp = 2\noutput = \"run\"\n\
         target = { set = { \"box.translate.x\" = 0.1 }, spp = 100000000 }\n\
         parameter = [{ name = \"box.translate.x\" }]\noptimizer = { lr = 0.1 }\n",
    );
    let message = capwalk.error("optimize job.toml");
    assert_has(
        &message,
        &["run/scene_textures would overwrite", "texture.png", "-o"],
    );
    assert!(!capwalk.path("run/checkpoint.npz").exists());
}

/// A scene that somebody has changed is not replaced by the one that is built in.
#[test]
fn exports_replace_nothing() {
    let capwalk = Capwalk::new("overwriting_exports");
    for _ in 0..2 {
        // Equal files are no loss.
        capwalk.json("scenes --export . --json leaf");
    }
    let edited = String::from_utf8(capwalk.bytes("leaf.xml")).expect("text") + "<!-- mine -->";
    capwalk.write("leaf.xml", &edited);
    let message = capwalk.error("scenes --export . leaf");
    assert_has(
        &message,
        &[
            "leaf.xml",
            "already exists with other contents",
            "another folder",
        ],
    );
    assert_eq!(capwalk.bytes("leaf.xml"), edited.as_bytes());
}
