//! What a derivative may leave out instead of being refused (`--allow-missing`).

use capwalk_scene_io::image::{LayeredImage, read};

use crate::{Capwalk, assert_has};

/// A box moves in a room with a ball of glass, in which it is seen.
const ROOM: &str = r#"<scene version="3.0.0"><integrator type="path"><integer name="max_depth" value="4"/></integrator>
<sensor type="perspective"><float name="fov" value="40"/>
<transform name="to_world"><lookat origin="0.1, -3.4, 1.3" target="0, 0, 0.75" up="0.05, 0, 1"/></transform>
<film type="hdrfilm"><integer name="width" value="24"/><integer name="height" value="18"/><rfilter type="tent"/></film>
<sampler type="independent"><integer name="sample_count" value="64"/></sampler></sensor>
<bsdf type="twosided" id="wall"><bsdf type="diffuse"><rgb name="reflectance" value="0.7, 0.6, 0.5"/></bsdf></bsdf>
<shape type="cube" id="room"><transform name="to_world"><scale x="1.5" y="4" z="1"/><translate z="1"/></transform><ref id="wall"/></shape>
<shape type="sphere" id="ball"><point name="center" x="0.6" y="0.1" z="0.45"/><float name="radius" value="0.4"/><bsdf type="dielectric"/></shape>
<shape type="cube" id="box"><transform name="to_world"><scale x="0.2" y="0.25" z="0.3"/><rotate z="1" angle="25"/><translate x="-0.6" y="-0.2" z="0.5"/></transform>
<bsdf type="diffuse"><rgb name="reflectance" value="0.2, 0.4, 0.7"/></bsdf></shape>
<shape type="rectangle" id="lamp"><transform name="to_world"><scale value="0.4"/><rotate x="1" angle="180"/><translate x="0.1" z="1.9"/></transform>
<emitter type="area"><rgb name="radiance" value="8"/></emitter></shape></scene>"#;

fn with_room(test: &str) -> Capwalk {
    let capwalk = Capwalk::new(test);
    capwalk.write("room.xml", ROOM);
    capwalk
}

fn layers(capwalk: &Capwalk, file: &str) -> LayeredImage {
    read(&capwalk.path(file)).expect("readable")
}

/// Refused without; with it, everything says what is left out and how much that concerns. The
/// rest is right: in pixels that see no glass the gradient is that of differences, and reverse
/// mode agrees with forward mode.
#[test]
fn motion_seen_through_glass_is_left_out() {
    let capwalk = with_room("missing_specular");
    let message = capwalk.error("gradient room.xml -p box.translate.x --spp 4");
    assert_has(
        &message,
        &[
            "refracting glass",
            "--allow-missing specular",
            "--method fd",
        ],
    );
    let command = "gradient room.xml -p box.translate.x --allow-missing specular";
    let finished = capwalk.run(&format!("{command} -o g.npz,g.png"));
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert_has(
        &finished.stderr,
        &["incomplete", "refracting glass", "% of the radiance"],
    );
    let json = capwalk.json(&format!("{command} --spp 16 --json"));
    let missing = &json["statistics"]["missing"];
    let [share, error] = ["share", "standard_error"].map(|key| missing[key].as_f64());
    let (share, error) = (share.expect("a number"), error.expect("a number"));
    assert!(share > 0.02 && share < 0.3, "{share}");
    assert!(error > 0.0 && error < 0.5 * share, "{error}");
    let layered = layers(&capwalk, "g.npz");
    let said = |key: &str| layered.metadata.iter().any(|(own, _)| own == key);
    assert!(said("missing") && said("missing_share") && said("missing_share_stderr"));

    // The share is that of the layer.
    let sum = |layer: &str| {
        let pixels = &layered.layer(layer).expect("a layer").pixels;
        pixels.iter().map(|p| p.r + p.g + p.b).sum::<f64>()
    };
    let whole = sum("missing") / sum("value");
    assert!(
        (whole - share).abs() < 6.0 * error,
        "{whole} {share} ± {error}"
    );

    // A check knows it: the rest alone is compared, and the whole not called right.
    let check = capwalk.run(
        "check room.xml -p box.translate.x --allow-missing specular --spp 256 --json -o c.npz,c.png",
    );
    assert_eq!(check.status, 6, "{}{}", check.stderr, check.stdout);
    let json: serde_json::Value = serde_json::from_str(&check.stdout).expect("JSON");
    let comparison = &json["comparison"];
    assert_eq!(comparison["verdict"], "partial");
    assert_ne!(comparison["verdict_of_rest"], "wrong", "{comparison}");
    let factor = comparison["scale_factor"].as_f64().expect("a number");
    assert!((factor - 1.0).abs() < 0.2, "{comparison}");

    // Nothing is left out where nothing that moves is seen through glass.
    let colour = capwalk.json(
        "gradient room.xml -p box.bsdf.reflectance.value --allow-missing specular --spp 4 --json",
    );
    assert!(colour["statistics"]["missing"].is_null());
}

/// The same samples, one after the other.
#[test]
fn both_modes_leave_out_the_same() {
    let capwalk = with_room("missing_both_modes");
    let options = "--method edges --allow-missing specular --spp 16";
    // Reverse mode with ones: the sum of all pixels of the gradient.
    capwalk.run("render room.xml --spp 1 -o ones.npz");
    let mut ones = layers(&capwalk, "ones.npz");
    ones.layers.retain(|layer| layer.name == "value");
    ones.layers[0]
        .image
        .pixels
        .fill(capwalk_math::Rgb::splat(1.0));
    let preview = capwalk_scene_io::image::Preview::default();
    capwalk_scene_io::image::write(&capwalk.path("ones.npz"), &ones, &preview).expect("writable");
    let back = capwalk.json(&format!(
        "backward room.xml --adjoint ones.npz --layer value -p box.translate.x {options} --seed 7 --json"
    ));
    let forward =
        format!("gradient room.xml -p box.translate.x {options} --seed 3 --json -o f.npz");
    let forward = capwalk.json(&forward);
    let parameter = &back["parameters"][0];
    let [value, error] =
        ["value", "standard_error"].map(|key| parameter[key].as_f64().expect("a number"));
    let layered = layers(&capwalk, "f.npz");
    let pixels = |layer: &str| layered.layer(layer).expect("a layer").pixels.iter();
    let sum: f64 = pixels("gradient").map(|p| p.r + p.g + p.b).sum();
    let spread: f64 = pixels("stderr").map(|p| (p.r + p.g + p.b).powi(2)).sum();
    let z = (value - sum) / spread.sqrt().hypot(error);
    assert!(z.abs() < 4.0, "{value} ± {error}, {sum}: {z}");
    // And the same part is missing.
    let share = |json: &serde_json::Value, key: &str| {
        json["statistics"]["missing"][key]
            .as_f64()
            .expect("a number")
    };
    let apart = share(&back, "share") - share(&forward, "share");
    let error = share(&back, "standard_error").hypot(share(&forward, "standard_error"));
    assert!(apart.abs() < 4.0 * error, "{apart} ± {error}");
}

#[test]
fn differences_miss_nothing() {
    let capwalk = Capwalk::new("missing_fd");
    let fd = "gradient leaf -p leaf.translate.x --method fd --allow-missing specular";
    assert_has(&capwalk.error(fd), &["--allow-missing", "miss nothing"]);
}
