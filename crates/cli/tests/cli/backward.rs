//! `capwalk backward`: arrays, scalars, losses and what is refused.

use capwalk_math::{Moments, Rgb, Vec3};
use capwalk_scene::{Image, Tangent, builtin, params};
use capwalk_scene_io::arrays::{self, Array, Arrays};
use capwalk_scene_io::image::{self, LayeredImage, Preview};

use crate::{Capwalk, assert_has};

const SIZE: &str = "--size 16x12";

/// Writes an image of numbers that look random, as `name` and as a layer.
fn write_adjoint(capwalk: &Capwalk, name: &str, layer: &str, change: impl Fn(&mut Image)) {
    let mut image = Image::new(16, 12);
    for (i, pixel) in image.pixels.iter_mut().enumerate() {
        *pixel = [0, 1, 2].map(|c| ((7 * i + 3 * c) as f64).sin()).into();
    }
    change(&mut image);
    let mut layered = LayeredImage::default();
    layered.push(layer, image);
    image::write(&capwalk.path(name), &layered, &Preview::default()).expect("writable");
}

fn read(capwalk: &Capwalk, name: &str) -> Arrays {
    arrays::read(&capwalk.path(name)).expect("readable")
}

fn array<'a>(arrays: &'a Arrays, name: &str) -> &'a Array {
    arrays
        .get(name)
        .unwrap_or_else(|| panic!("no array {name}"))
}

fn scalar(arrays: &Arrays, name: &str) -> f64 {
    let array = array(arrays, name);
    assert_eq!(array.shape, [0; 0], "{name}");
    array.numbers[0]
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Scalars are inner products of arrays with the velocities that they mean.
#[test]
fn arrays_and_scalars_belong_together() {
    let capwalk = Capwalk::new("backward_arrays");
    write_adjoint(&capwalk, "a.npz", "adjoint", |_| {});
    let scalars = [
        "ball.translate.x",
        "ball.translate.y+ball.rotate.y",
        "ball.translate.x-0.5*ball.scale",
        "lamp.emitter.radiance.value.g",
        "1*lamp.emitter.radiance.value",
        "sensor.rotate.z",
    ];
    let names = scalars.join(" ");
    let json = capwalk.json(&format!(
        "backward ball {SIZE} --spp 32 --adjoint a.npz -o g.npz --errors --json --param {names} \
         ball.positions ball.normals ball.translate lamp.emitter.radiance.value sensor.rotate"
    ));
    let file = read(&capwalk, "g.npz");
    let scene = builtin::scene("ball").expect("built in");
    let tangent = |name: &str| {
        params::Registry::new(&scene)
            .tangent(&scene, name)
            .expect("known")
    };
    let ball = scene.shapes.iter().position(|s| s.id == "ball");
    let velocities = |tangent: &Tangent| -> Vec<f64> {
        let ball = tangent.shapes[ball.expect("a ball")].as_ref();
        let ball = ball.expect("moves");
        let still = vec![Vec3::zero(); ball.vertices.len()];
        let normals = ball.normals.as_ref().unwrap_or(&still);
        let both = ball.vertices.iter().chain(normals);
        both.flat_map(|v| v.to_array()).collect()
    };
    let positions = array(&file, "ball.positions");
    let count = scene.shapes[ball.expect("a ball")].mesh.positions.len();
    assert_eq!(positions.shape, [count, 3]);
    let normals = array(&file, "ball.normals");
    assert_eq!(normals.shape, [count, 3], "the ball has normals");
    let both = [&positions.numbers[..], &normals.numbers].concat();
    for name in &scalars[..3] {
        let (value, expected) = (scalar(&file, name), dot(&both, &velocities(&tangent(name))));
        let difference = (value - expected).abs();
        assert!(value.abs() > 1e-3, "{name}: nothing to compare");
        assert!(
            difference <= 1e-9 * value.abs(),
            "{name}: {value} {expected}"
        );
    }
    let translate = array(&file, "ball.translate");
    assert_eq!(translate.shape, [3]);
    let x = scalar(&file, "ball.translate.x");
    assert!((translate.numbers[0] - x).abs() <= 1e-9 * x.abs(), "{x}");
    let radiance = array(&file, "lamp.emitter.radiance.value");
    assert_eq!(radiance.shape, [3]);
    let green = scalar(&file, "lamp.emitter.radiance.value.g");
    assert_eq!(radiance.numbers[1], green);
    let all = scalar(&file, "1*lamp.emitter.radiance.value");
    assert!((radiance.numbers.iter().sum::<f64>() - all).abs() <= 1e-9 * all.abs());
    assert_eq!(
        array(&file, "sensor.rotate").numbers[2],
        scalar(&file, "sensor.rotate.z")
    );

    // Every array has its errors, and nothing else is in the file.
    let named = |json: &serde_json::Value| json["name"].as_str().expect("a name").to_owned();
    let listed = json["parameters"].as_array().expect("a list");
    let mut expected: Vec<String> = Vec::new();
    for parameter in listed {
        let name = named(parameter);
        expected.extend([name.clone(), format!("{name}.stderr")]);
        let array = array(&file, &name);
        let errors = self::array(&file, &format!("{name}.stderr"));
        assert_eq!(parameter["shape"], serde_json::json!(array.shape), "{name}");
        assert_eq!(errors.shape, array.shape, "{name}");
        assert!(errors.numbers.iter().all(|&e| e >= 0.0), "{name}");
        let norm = dot(&array.numbers, &array.numbers).sqrt();
        match array.shape[..] {
            [] => {
                for (key, expected) in [("value", array), ("standard_error", errors)] {
                    let expected = expected.numbers[0];
                    let said = parameter[key].as_f64().expect("a number");
                    assert!((said - expected).abs() <= 1e-14 * expected.abs(), "{name}");
                }
            }
            _ => {
                let said = parameter["norm"].as_f64().expect("a number");
                assert!((said - norm).abs() <= 1e-12 * norm, "{name}");
                let error = parameter["standard_error"].as_f64().expect("a number");
                let noise = parameter["noise"].as_f64().expect("a number");
                assert!(0.0 < error && error <= noise, "{name}: {error} {noise}");
            }
        }
    }
    let names: Vec<String> = file.arrays.iter().map(|a| a.name.clone()).collect();
    assert_eq!(names, expected);
    assert_eq!(listed.len(), 11);
    assert!(file.metadata.contains(&("complete".into(), "true".into())));
    assert!(file.metadata.contains(&("adjoint".into(), "a.npz".into())));
}

/// The same number from the image of derivatives, with other random numbers:
/// apart by five standard errors of the difference once in 10^6 runs.
#[test]
fn forward_and_reverse_agree_within_their_errors() {
    let capwalk = Capwalk::new("backward_forward");
    // Brighter to the right: the two sides of the shadow do not cancel.
    write_adjoint(&capwalk, "a.exr", "value", |image| {
        for (i, pixel) in image.pixels.iter_mut().enumerate() {
            *pixel = Rgb::new(1.0, 0.5, -0.2) * ((i % 16) as f64 - 7.5);
        }
    });
    let name = "leaf.translate.x-0.3*lamp.translate.y";
    let json = capwalk.json(&format!(
        "backward leaf {SIZE} --spp 256 --seed 8 --adjoint a.exr -o g.npz --json -p {name}"
    ));
    let parameter = &json["parameters"][0];
    let number = |key: &str| parameter[key].as_f64().expect("a number");
    let (value, error) = (number("value"), number("standard_error"));
    capwalk.json(&format!(
        "gradient leaf {SIZE} --spp 256 --seed 9 --json -o f.npz -p {name}"
    ));
    let layer = |file: &str, layer: &str| {
        let layered = image::read(&capwalk.path(file)).expect("readable");
        let image = layered.layer(layer).expect("a layer");
        let channels = image.pixels.iter().flat_map(|p| p.to_array());
        channels.collect::<Vec<f64>>()
    };
    let adjoint = layer("a.exr", "value");
    let forward = dot(&adjoint, &layer("f.npz", "gradient"));
    let errors = layer("f.npz", "stderr");
    // Channels of a pixel share their noise.
    let pixels = adjoint.chunks(3).zip(errors.chunks(3));
    let variance: f64 = pixels
        .map(|(a, e)| a.iter().zip(e).map(|(a, e)| (a * e).abs()).sum::<f64>())
        .map(|deviation| deviation * deviation)
        .sum();
    println!(
        "reverse {value} ± {error}, forward {forward} ± {}",
        variance.sqrt()
    );
    let limit = 5.0 * (error * error + variance).sqrt();
    let difference = (value - forward).abs();
    assert!(difference < limit, "{value} ± {error}, {forward}");
    assert!(
        limit < 0.1 * value.abs(),
        "{value} ± {error}: too noisy to tell"
    );
}

/// An image is the best one for itself: the derivative of the square is zero
/// on average over seeds. It would not be if image and gradient shared their
/// random numbers: by 12 of its standard errors, for the emitter.
#[test]
fn an_image_is_the_best_one_for_itself() {
    let capwalk = Capwalk::new("backward_minimum");
    capwalk.json(&format!(
        "render leaf {SIZE} --spp 4096 --seed 77 --json -o target.npz"
    ));
    let mut gradients = [Moments::default(); 2];
    let mut of_noise = Moments::default();
    for seed in 0..12 {
        let json = capwalk.json(&format!(
            "backward leaf {SIZE} --spp 8 --seed {seed} --loss l2 --target target.npz --json \
             -o g.npz -p 1*lamp.emitter.radiance.value leaf.translate.x"
        ));
        for (gradient, parameter) in gradients.iter_mut().zip([0, 1]) {
            let value = &json["parameters"][parameter]["value"];
            gradient.add(value.as_f64().expect("a number"));
        }
        let loss = &json["loss"];
        let number = |key: &str| loss[key].as_f64().expect("a number");
        of_noise.add(number("value") - number("noise"));
        assert_ne!(loss["seed"], seed, "the seed of the gradient");
    }
    // All of the loss is noise.
    let z = |moments: &Moments| moments.mean / moments.standard_error();
    for (name, moments) in [
        ("lamp", &gradients[0]),
        ("leaf", &gradients[1]),
        ("loss", &of_noise),
    ] {
        println!("{name}: {} ± {}", moments.mean, moments.standard_error());
        // Student's t of 11 degrees of freedom: once in 3000.
        assert!(z(moments).abs() < 5.0, "{name}: {}", z(moments));
    }
}

/// Against a brighter emitter the loss and its gradient are known: images are
/// linear in radiance.
#[test]
fn losses_and_their_gradients() {
    let capwalk = Capwalk::new("backward_loss");
    capwalk.json(&format!(
        "render leaf {SIZE} --spp 4096 --seed 77 --json -o target.npz"
    ));
    let run = |loss: &str| {
        let json = capwalk.json(&format!(
            "backward bright.xml {SIZE} --spp 64 --loss {loss} --target target.npz --json \
             -o g.npz -p 1*lamp.emitter.radiance.value"
        ));
        let gradient = json["parameters"][0]["value"].as_f64();
        (gradient.expect("a number"), json["loss"].clone())
    };
    capwalk.json("scenes --export . --json leaf");
    let xml = String::from_utf8(capwalk.bytes("leaf.xml")).expect("text");
    capwalk.write("bright.xml", &xml.replace("70", "105"));
    let layered = image::read(&capwalk.path("target.npz")).expect("readable");
    let target = layered.layer("value").expect("a layer");
    let channels = target.pixels.iter().flat_map(|p| p.to_array());
    let values: Vec<f64> = channels.collect();
    let mean = |f: fn(f64) -> f64| values.iter().map(|&x| f(x)).sum::<f64>() / values.len() as f64;
    // With the image I = 1.5 T and dI/dradiance = T / 70:
    // l1: |I - T| = T / 2, and T / 70; l2: (I - T)² = T² / 4, and T² / 70.
    for (loss, value, derivative) in [
        ("l1", mean(|t| t / 2.0), mean(|t| t / 70.0)),
        ("l2", mean(|t| t * t / 4.0), mean(|t| t * t / 70.0)),
    ] {
        let (gradient, said) = run(loss);
        let noise = said["noise"].as_f64().unwrap_or(0.0);
        let ratio = (said["value"].as_f64().expect("a number") - noise) / value;
        println!("{loss}: {ratio} {}", gradient / derivative);
        assert!((ratio - 1.0).abs() < 0.05, "{loss}: {ratio}");
        assert!(
            (gradient / derivative - 1.0).abs() < 0.05,
            "{loss}: {gradient} {derivative}"
        );
    }
}

/// A bitmap has a number for every texel, row by row as in its file; their sum
/// is the scalar.
#[test]
fn texels_of_a_bitmap() {
    let capwalk = Capwalk::new("backward_bitmap");
    write_adjoint(&capwalk, "a.npz", "adjoint", |image| {
        image.pixels.fill(Rgb::new(1.0, 2.0, 3.0));
    });
    let mut bitmap = LayeredImage::default();
    let pixels = (1..=6).map(|i| Rgb::splat(0.1 * f64::from(i)));
    let image = Image {
        width: 3,
        height: 2,
        pixels: pixels.collect(),
    };
    bitmap.push("value", image);
    image::write(&capwalk.path("wall.exr"), &bitmap, &Preview::default()).expect("writable");
    capwalk.write(
        "wall.xml",
        r#"<scene version="3.0.0"><integrator type="direct"/><emitter type="constant"/>
<sensor type="perspective"><float name="fov" value="40"/></sensor>
<shape type="rectangle" id="wall">
<transform name="to_world"><rotate y="1" angle="180"/><translate z="2.2"/></transform>
<bsdf type="diffuse"><texture name="reflectance" type="bitmap">
<string name="filename" value="wall.exr"/></texture></bsdf></shape></scene>"#,
    );
    capwalk.json(&format!(
        "backward wall.xml {SIZE} --spp 16 --adjoint a.npz -o g.npz --json \
         -p wall.bsdf.reflectance.data 1*wall.bsdf.reflectance.data"
    ));
    let file = read(&capwalk, "g.npz");
    let data = array(&file, "wall.bsdf.reflectance.data");
    assert_eq!(data.shape, [2, 3, 3]);
    let sum: f64 = data.numbers.iter().sum();
    let scalar = scalar(&file, "1*wall.bsdf.reflectance.data");
    assert!((sum - scalar).abs() <= 1e-9 * scalar, "{sum} {scalar}");
    for texel in data.numbers.chunks(3) {
        assert!(texel[0] > 1.0, "every texel is seen: {texel:?}");
        let [double, triple] = [texel[1] / texel[0], texel[2] / texel[0]];
        assert!(
            (double - 2.0).abs() < 1e-9 && (triple - 3.0).abs() < 1e-9,
            "{texel:?}"
        );
    }
}

/// Without names: all arrays of `info`, and nothing else.
#[test]
fn all_arrays_are_the_default() {
    let capwalk = Capwalk::new("backward_default");
    write_adjoint(&capwalk, "a.npz", "anything", |_| {});
    let finished = capwalk.run(&format!(
        "backward leaf {SIZE} --spp 4 --adjoint a.npz --layer anything"
    ));
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert_has(
        &finished.stdout,
        &[
            "norm or value",
            "leaf.positions",
            "(3, 3)",
            "wrote leaf-backward.npz",
        ],
    );
    let info = capwalk.json("info leaf --json");
    let listed = info["arrays"].as_array().expect("a list").iter();
    let expected: Vec<(String, Vec<usize>)> = listed
        .filter(|array| array["alias_of"].is_null())
        .map(|array| {
            let shape = serde_json::from_value(array["shape"].clone());
            (
                array["name"].as_str().expect("a name").into(),
                shape.expect("sides"),
            )
        })
        .collect();
    let written = read(&capwalk, "leaf-backward.npz").arrays.into_iter();
    let written: Vec<_> = written.map(|array| (array.name, array.shape)).collect();
    assert_eq!(written, expected);
    assert!(written.iter().any(|(name, _)| name == "sensor.translate"));
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let capwalk = Capwalk::new("backward_threads");
    write_adjoint(&capwalk, "a.npz", "adjoint", |_| {});
    for threads in [1, 3] {
        capwalk.json(&format!(
            "backward leaf {SIZE} --spp 37 --adjoint a.npz --errors --json -t {threads} \
             -o {threads}.npz"
        ));
    }
    assert!(capwalk.bytes("1.npz") == capwalk.bytes("3.npz"));
}

#[test]
fn a_time_limit_keeps_what_is_done() {
    let capwalk = Capwalk::new("backward_time_limit");
    write_adjoint(&capwalk, "a.npz", "adjoint", |_| {});
    let finished = capwalk.run(&format!(
        "backward leaf {SIZE} --spp 100000000 --adjoint a.npz --time-limit 2s --json -o g.npz"
    ));
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert_has(&finished.stderr, &["gradient is partial"]);
    let metadata = read(&capwalk, "g.npz").metadata;
    assert!(metadata.contains(&("complete".into(), "false".into())));
}

#[test]
fn adjoints_that_do_not_fit() {
    let capwalk = Capwalk::new("backward_adjoints");
    write_adjoint(&capwalk, "a.npz", "adjoint", |_| {});
    write_adjoint(&capwalk, "nan.npz", "adjoint", |image| {
        image.pixels[16 * 2 + 7].g = f64::NAN
    });
    write_adjoint(&capwalk, "layer.npz", "gradient", |_| {});
    let leaf = |rest: &str| capwalk.error(&format!("backward leaf --spp 4 {rest}"));
    let message = leaf("--size 12x16 --adjoint a.npz");
    assert_has(&message, &["a.npz", "16 x 12", "12 x 16"]);
    let message = leaf(&format!("{SIZE} --adjoint nan.npz"));
    assert_has(&message, &["nan.npz", "NaN", "column 7, row 2"]);
    let message = leaf(&format!(
        "{SIZE} --loss l1 --target nan.npz --layer adjoint"
    ));
    assert_has(&message, &["nan.npz", "NaN", "column 7, row 2"]);
    let message = leaf(&format!("{SIZE} --adjoint layer.npz"));
    assert_has(
        &message,
        &[
            "layer.npz",
            "\"adjoint\" or \"value\"",
            "--layer",
            "gradient",
        ],
    );
    let message = leaf(&format!("{SIZE} --adjoint a.npz --layer derivative"));
    assert_has(&message, &["a.npz", "no layer \"derivative\"", "adjoint"]);
    assert_has(
        &leaf(&format!("{SIZE} --adjoint missing.npz")),
        &["missing.npz"],
    );
    assert!(!capwalk.path("leaf-backward.npz").exists());
}

#[test]
fn bad_names_and_files() {
    let capwalk = Capwalk::new("backward_names");
    write_adjoint(&capwalk, "a.npz", "adjoint", |_| {});
    let leaf = |rest: &str| {
        capwalk.error(&format!(
            "backward leaf {SIZE} --spp 4 --adjoint a.npz {rest}"
        ))
    };
    let message = leaf("-p leaf.position");
    assert_has(
        &message,
        &["leaf.position", "did you mean", "leaf.positions"],
    );
    let message = leaf("-p leaf.positions leaf.translat.x");
    assert_has(&message, &["leaf.translat.x", "leaf.translate.x"]);
    assert_has(
        &leaf("-p 2*leaf.positions"),
        &["leaf.positions", "is an array"],
    );
    assert_has(
        &leaf("-p leaf.scale -p leaf.scale"),
        &["leaf.scale", "once"],
    );
    assert_has(
        &leaf("-p leaf.scale-leaf.scale"),
        &["leaf.scale-leaf.scale", "nothing changes"],
    );
    let message = leaf("-o new/gradient.exr");
    assert_has(&message, &["gradient.exr", "known endings: .npz"]);
    assert!(!capwalk.path("new").exists());
    let message = capwalk.error("gradient leaf -p leaf.positions");
    assert_has(
        &message,
        &["leaf.positions", "is an array", "capwalk backward"],
    );
}

#[test]
fn wrong_usage() {
    let capwalk = Capwalk::new("backward_usage");
    for arguments in [
        "backward leaf",
        "backward leaf --loss l2",
        "backward leaf --target a.npz",
        "backward leaf --adjoint a.npz --loss l2 --target a.npz",
        "backward leaf --loss l3 --target a.npz",
    ] {
        let finished = capwalk.run(arguments);
        assert_eq!(finished.status, 3, "{arguments}");
        assert_has(&finished.stderr, &["--help"]);
    }
}

/// Brushed metal that does not say how it is brushed: everything that moves nothing is
/// differentiated, and one warning names the rest. By name it is refused.
#[test]
fn what_cannot_be_differentiated_is_left_out() {
    let capwalk = Capwalk::new("backward_left_out");
    write_adjoint(&capwalk, "a.npz", "adjoint", |_| {});
    let sheet = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvn 0 0 1\nvn 0.6 0 0.8\nf 1//1 2//2 3//1\n";
    capwalk.write("sheet.obj", sheet);
    capwalk.write(
        "bulb.xml",
        r#"<scene version="3.0.0"><integrator type="direct"/>
<sensor type="perspective"><transform name="to_world">
<lookat origin="0, 0, 5" target="0, 0, 0" up="0, 1, 0"/></transform></sensor>
<shape type="obj" id="sheet"><string name="filename" value="sheet.obj"/>
<bsdf type="roughconductor"><float name="alpha_u" value="0.1"/><float name="alpha_v" value="0.4"/></bsdf></shape>
<emitter type="point" id="bulb"><point name="position" value="0, 1, 3"/></emitter></scene>"#,
    );
    let command = format!("backward bulb.xml {SIZE} --spp 4 --adjoint a.npz -o g.npz");
    let finished = capwalk.run(&command);
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert_has(
        &finished.stderr,
        &["warning: ", "sheet.positions", "are left out: "],
    );
    let gradient = read(&capwalk, "g.npz");
    assert!(gradient.get("bulb.intensity.value").is_some());
    assert!(gradient.get("sheet.positions").is_none());
    let message = capwalk.error(&format!("{command} -p sheet.positions"));
    assert!(!message.contains("left out"), "{message}");
}
