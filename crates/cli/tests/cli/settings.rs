//! Which sensor renders, and parameters that are set before anything is done.

use serde_json::json;

use crate::{Capwalk, assert_has};

const TINY: &str = "--size 12x9 --spp 8";

/// A box seen from the left, and from the right by twice as many pixels.
const TWO_SENSORS: &str = r#"<scene version="3.0.0"><integrator type="path"/>
<sensor type="perspective" id="left"><transform name="to_world"><translate x="-1" z="-6"/></transform>
<film type="hdrfilm"><integer name="width" value="8"/><integer name="height" value="6"/></film></sensor>
<sensor type="perspective" id="right"><transform name="to_world"><translate x="1" z="-6"/></transform>
<film type="hdrfilm"><integer name="width" value="16"/><integer name="height" value="6"/></film></sensor>
<emitter type="constant"/><shape type="cube" id="box"/></scene>"#;

/// Every command takes a sensor by its number or by its name; the first is the default.
#[test]
fn sensors_by_number_or_name() {
    let capwalk = Capwalk::new("sensors");
    capwalk.write("two.xml", TWO_SENSORS);
    let commands = [
        "info two.xml",
        "render two.xml --spp 2",
        "gradient two.xml -p box.bsdf.reflectance.value --spp 2",
        "backward two.xml --adjoint adjoint.npz -p box.bsdf.reflectance.value --spp 2",
    ];
    for (sensor, width) in [
        ("", 8),
        ("-s 1", 16),
        ("--sensor right", 16),
        ("--sensor left", 8),
    ] {
        capwalk.run(&format!("render two.xml {sensor} --spp 2 -o adjoint.npz"));
        for command in commands {
            let json = capwalk.json(&format!("{command} {sensor} --json"));
            assert_eq!(json["size"], json!([width, 6]), "{command} {sensor}");
        }
        let check = "check two.xml -p box.bsdf.reflectance.value --spp 2";
        let finished = capwalk.run(&format!("{check} {sensor} --json"));
        let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
        assert_eq!(json["size"], json!([width, 6]), "{sensor}");
    }
    let message = capwalk.error("render two.xml --sensor up");
    assert_has(&message, &["there is no sensor \"up\"", "left, right"]);
    let message = capwalk.error("render two.xml --sensor 2");
    assert_has(&message, &["the scene has no sensor 2", "0 to 1"]);
    let message = capwalk.error("render leaf --sensor left");
    assert_has(&message, &["there is no sensor \"left\"; there are sensor"]);
}

/// The value is that of the scene from then on, for every command; what was set is said.
#[test]
fn parameters_are_set() {
    let capwalk = Capwalk::new("settings");
    let colour = "floor.bsdf.reflectance.value";
    let set = format!("--set {colour}=0.25,0.5,0.125 --set leaf.translate.x=0.25");
    let said = json!([
        {"name": colour, "values": [0.25, 0.5, 0.125]},
        {"name": "leaf.translate.x", "values": [0.25]},
    ]);
    let info = capwalk.json(&format!("info leaf {set} --json"));
    assert_eq!(info["set"], said);
    let parameters = info["parameters"].as_array().expect("a list");
    let found = parameters.iter().find(|p| p["name"] == colour);
    assert_eq!(found.expect("listed")["value"], json!([0.25, 0.5, 0.125]));

    let render = capwalk.json(&format!("render leaf {TINY} {set} --json -o set.npz"));
    assert_eq!(render["set"], said);
    let plain = capwalk.json(&format!("render leaf {TINY} --json -o plain.npz"));
    assert_eq!(plain["set"], json!([]));
    assert_ne!(render["mean"], plain["mean"]);
    let gradient = format!("gradient leaf -p leaf.translate.x {TINY} --method walk");
    let moved = capwalk.json(&format!("{gradient} {set} --json -o set-g.npz"));
    assert_eq!(moved["set"], said);
    for file in ["set.npz", "set-g.npz"] {
        let layered = capwalk_scene_io::image::read(&capwalk.path(file)).expect("readable");
        let mut pairs = layered.metadata.iter();
        let noted = pairs
            .find(|(key, _)| key == "set")
            .map(|(_, value)| &value[..]);
        let expected = format!("{colour}=0.25,0.5,0.125; leaf.translate.x=0.25");
        assert_eq!(noted, Some(&expected[..]), "{file}");
    }
    // One number is that of all channels, and a sum of places moves all of them.
    let means = [
        format!("--set {colour}=0.5 --set leaf.translate.x=0.25"),
        format!("--set {colour}=0.5,0.5,0.5 --set 0.5*leaf.translate.x=0.5"),
    ]
    .map(|set| capwalk.json(&format!("render leaf {TINY} {set} --json"))["mean"].clone());
    assert_eq!(means[0], means[1]);
    let vector = format!("--set {colour}=0.5 --set leaf.translate=0.25,0,0");
    let vector = capwalk.json(&format!("render leaf {TINY} {vector} --json"));
    assert_eq!(vector["mean"], means[0]);
    let backward = format!("backward leaf --adjoint plain.npz --layer value {TINY}");
    let json = capwalk.json(&format!("{backward} -p leaf.translate.x {set} --json"));
    assert_eq!(json["set"], said);
}

#[test]
fn what_cannot_be_set() {
    let capwalk = Capwalk::new("bad_settings");
    for (set, expected) in [
        ("floor.bsdf.reflectance.value=-1", "at least 0"),
        (
            "floor.bsdf.reflectance.value=1,2",
            "expected 3, or one for all of them",
        ),
        ("leaf.scale=0", "cannot be 0; expected a scale above 0"),
        (
            "leaf.translate.x=1e200",
            "cannot be 1e200; expected a distance of at most 1e30",
        ),
        (
            "leaf.rotate.x=1e300",
            "\"leaf.rotate.x\" cannot be 1e300; expected an angle of at most 1e6 radians",
        ),
        (
            "sensor.rotate.y=1e300",
            "expected an angle of at most 1e6 radians",
        ),
        ("sensor.translate.x=1e200", "sensor.to_world is"),
        ("leaf.positions[0,1]=1e200", "vertex 0 has the position"),
        ("leaf.scale=1e-320", "leaf.to_world is [[1e-320, 0.0, 0.0, "),
        ("leaf.positions=0", "all vertices of a shape"),
        ("leaff.translate.x=0.1", "did you mean"),
        ("leaf.translate.x", "expected NAME=VALUE"),
        ("leaf.translate.x=far", "finite number"),
        ("leaf.translate.x=nan", "finite number"),
        ("=1", "expected NAME=VALUE"),
    ] {
        let message = capwalk.error(&format!("render leaf {TINY} --set {set}"));
        assert_has(&message, &[expected]);
    }
    let twice = "--set leaf.scale=1 --set leaf.scale=2";
    assert_has(
        &capwalk.error(&format!("info leaf {twice}")),
        &["leaf.scale"],
    );
}
