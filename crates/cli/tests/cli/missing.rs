//! What a derivative may leave out instead of being refused (`--allow-missing`).

use capwalk_scene_io::image::{LayeredImage, read};

use crate::{Capwalk, assert_has};

/// Two boards over a floor turn up, the right one behind a pane that refracts. Nothing moves
/// where the border of the pane is in the image, and the pane reflects nothing. A sign that
/// glows is behind it, too.
const ROOM: &str = r#"<scene version="3.0.0"><integrator type="path"><integer name="max_depth" value="3"/></integrator>
<sensor type="perspective"><float name="fov" value="40"/>
<transform name="to_world"><lookat origin="0.1, -3.4, 1.3" target="0.1, 0, 0.5" up="0, 0, 1"/></transform>
<film type="hdrfilm"><integer name="width" value="12"/><integer name="height" value="9"/><rfilter type="box"/></film>
<sampler type="independent"><integer name="sample_count" value="64"/></sampler></sensor>
<bsdf type="twosided" id="paper"><bsdf type="diffuse"><rgb name="reflectance" value="0.4, 0.6, 0.9"/></bsdf></bsdf>
<shape type="rectangle" id="left"><transform name="to_world"><scale value="0.3"/><rotate x="1" angle="65"/><translate x="-0.4" y="-0.2" z="0.5"/></transform><ref id="paper"/></shape>
<shape type="rectangle" id="right"><transform name="to_world"><scale value="0.3"/><rotate x="1" angle="65"/><translate x="0.6" y="-0.2" z="0.5"/></transform><ref id="paper"/></shape>
<shape type="rectangle" id="floor"><transform name="to_world"><scale value="2"/></transform>
<bsdf type="diffuse"><rgb name="reflectance" value="0.7, 0.6, 0.5"/></bsdf></shape>
<shape type="rectangle" id="pane"><transform name="to_world"><rotate x="1" angle="80"/><translate x="1.1" y="-2.4" z="1.1"/></transform>
<bsdf type="dielectric"><rgb name="specular_reflectance" value="0"/></bsdf></shape>
<shape type="rectangle" id="lamp"><transform name="to_world"><scale value="0.5"/><rotate x="1" angle="180"/><translate x="0.1" y="-0.5" z="1.9"/></transform>
<emitter type="area"><rgb name="radiance" value="8"/></emitter></shape>
<shape type="rectangle" id="sign"><transform name="to_world"><scale value="0.2"/><rotate x="1" angle="90"/><translate x="0.7" z="1.1"/></transform>
<emitter type="area"><rgb name="radiance" value="0.3"/></emitter></shape></scene>"#;

/// What moves in the room.
const MOTION: &str = "-p left.rotate.x+right.rotate.x";

/// The option that this file is about.
const ALLOW: &str = "--allow-missing specular";

fn with_room(test: &str) -> Capwalk {
    let capwalk = Capwalk::new(test);
    capwalk.write("room.xml", ROOM);
    capwalk
}

fn layers(capwalk: &Capwalk, file: &str) -> LayeredImage {
    read(&capwalk.path(file)).expect("readable")
}

/// The sums of the channels of each pixel of a layer, row by row.
fn pixels(image: &LayeredImage, layer: &str) -> Vec<f64> {
    let pixels = &image.layer(layer).expect("a layer").pixels;
    pixels.iter().map(|p| p.r + p.g + p.b).collect()
}

/// What times one image is the other one, on average over the pixels that are in question.
fn factor(from: &[f64], to: &[f64], is_in_question: impl Fn(usize) -> bool) -> f64 {
    let product = |a: &[f64], b: &[f64]| -> f64 {
        let terms = a.iter().zip(b).enumerate();
        terms
            .filter_map(|(i, (x, y))| is_in_question(i).then_some(x * y))
            .sum()
    };
    product(from, to) / product(from, from)
}

/// Refused without, and it says what to do.
#[test]
fn motion_seen_through_glass_is_refused() {
    let capwalk = with_room("missing_refused");
    let message = capwalk.error(&format!("gradient room.xml {MOTION} --spp 4"));
    assert_has(&message, &["refracting glass", ALLOW, "--method fd"]);
}

/// Without names, `backward` gives what is not refused, and says what it leaves out; with them,
/// it says what to type, and not what it has not.
#[test]
fn backward_without_names_leaves_out_what_is_refused() {
    let capwalk = with_room("missing_backward_all");
    capwalk.run("render room.xml --spp 4 -o target.npz");
    let backward = "backward room.xml --loss l2 --target target.npz --spp 8 -o b.npz";
    let finished = capwalk.run(&format!("{backward} --json"));
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert_has(
        &finished.stderr,
        &["left.positions", "are left out", "refracting glass", ALLOW],
    );
    assert!(
        !finished.stderr.contains("--method fd"),
        "{}",
        finished.stderr
    );
    let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
    let names = json["parameters"].as_array().expect("a list");
    let names: Vec<_> = names.iter().filter_map(|p| p["name"].as_str()).collect();
    assert!(
        names.iter().any(|name| name.contains("reflectance")),
        "{names:?}"
    );
    assert!(!names.contains(&"left.positions"), "{names:?}");
    let message = capwalk.error(&format!("{backward} -p left.vertex_positions"));
    assert_has(&message, &[ALLOW, "-p NAME"]);
    assert!(!message.contains("--method fd"), "{message}");
}

/// Everything says what is left out and how much light arrives by such paths.
#[test]
fn what_is_left_out_is_said() {
    let capwalk = with_room("missing_said");
    let finished = capwalk.run(&format!(
        "gradient room.xml {MOTION} {ALLOW} --json -o g.npz,g.png"
    ));
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert_has(
        &finished.stderr,
        &[
            "incomplete",
            "refracting glass",
            "% of the radiance arrives by paths with such events, whether",
        ],
    );
    let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
    let missing = &json["statistics"]["missing"];
    let [share, error] = ["share", "standard_error"].map(|key| missing[key].as_f64());
    let (share, error) = (share.expect("a number"), error.expect("a number"));
    // What arrives through the pane: 34.01 % ± 0.06 % with many samples.
    assert!((share - 0.3401).abs() < 4.0 * error, "{share} ± {error}");
    assert!(error > 0.002 && error < 0.02, "{error}");
    let layered = layers(&capwalk, "g.npz");
    let said = |key: &str| layered.metadata.iter().any(|(own, _)| own == key);
    assert!(said("missing") && said("missing_share") && said("missing_share_stderr"));

    // The share is that of the layer.
    let sum = |layer: &str| pixels(&layered, layer).iter().sum::<f64>();
    let whole = sum("missing") / sum("value");
    assert!((whole - share).abs() < 1e-6, "{whole} {share}");

    // Nothing is left out where nothing that moves is seen through glass.
    let colour = format!("gradient room.xml -p right.bsdf.reflectance.value {ALLOW}");
    let colour = capwalk.json(&format!("{colour} --spp 4 --json"));
    assert!(colour["statistics"]["missing"].is_null());
}

/// An optimisation is refused without, too; with it, it says what its gradients leave out.
#[test]
fn optimisations_leave_out_what_is_allowed() {
    let capwalk = with_room("missing_optimize");
    let job = r#"scene = "room.xml"
iterations = 2
spp = 16
target = { set = { "right.translate.x" = 0.1 } }
parameter = [{ name = "right.translate.x" }]
optimizer = { lr = 0.01 }
"#;
    capwalk.write("refused.toml", job);
    let refused = capwalk.error("optimize refused.toml");
    assert_has(&refused, &["is refused", "`allow_missing`", "refused.toml"]);

    let method = |allowed: &str| format!("{job}[method]\nallow_missing = {allowed}\n");
    capwalk.write("partial.toml", &method(r#"["specular"]"#));
    let finished = capwalk.run("optimize partial.toml --json");
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert_has(
        &finished.stderr,
        &["the gradients are incomplete", "refracting glass"],
    );
    let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
    let share = json["missing"]["share"].as_f64().expect("a number");
    // What arrives through the pane, as above, and its error.
    assert!((share - 0.34).abs() < 0.05, "{share}");
    let record = std::fs::read_to_string(capwalk.path("partial.out/record.csv")).expect("written");
    let mut rows = record
        .lines()
        .map(|row| row.split(',').nth(8).expect("nine columns"));
    assert_eq!(rows.next(), Some("missing_share"));
    let shares: Vec<f64> = rows.filter_map(|cell| cell.parse().ok()).collect();
    // The largest of all steps.
    assert_eq!((shares.len(), shares[0].max(shares[1])), (2, share));

    capwalk.write("unknown.toml", &method(r#"["glass"]"#));
    let unknown = capwalk.error("optimize unknown.toml");
    assert_has(&unknown, &["unknown.toml:8", "specular"]);
}

/// The first step decides: a board that comes behind the glass later stops no run, and every row says
/// what is left out.
#[test]
fn optimisations_go_on_where_something_comes_behind_glass() {
    let capwalk = Capwalk::new("missing_later");
    // Nothing is lit by way of the pane.
    capwalk.write(
        "room.xml",
        &ROOM.replace("\"max_depth\" value=\"3\"", "\"max_depth\" value=\"2\""),
    );
    let job = r#"scene = "room.xml"
iterations = 2
spp = 16
target = { set = { "left.translate.x" = 0.25 } }
parameter = [{ name = "left.translate.x" }]
optimizer = { lr = 1.0 }
"#;
    capwalk.write("later.toml", job);
    let finished = capwalk.run("optimize later.toml");
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert_has(&finished.stderr, &["the gradients are incomplete"]);
    let record = std::fs::read_to_string(capwalk.path("later.out/record.csv")).expect("written");
    let cells = record.lines().map(|row| row.split(',').nth(8));
    let shares: Vec<f64> = cells.filter_map(|cell| cell?.parse().ok()).collect();
    assert!(shares[0] == 0.0 && shares[1] > 0.05, "{record}");
}

/// The rest of the gradient is right: where no glass is seen, it is that of differences, and
/// through glass it has what is no silhouette.
#[test]
fn the_rest_of_the_gradient_is_right() {
    let capwalk = with_room("missing_rest");
    let options = "--spp 512 -o g.npz";
    capwalk.json(&format!(
        "gradient room.xml {MOTION} {ALLOW} {options} --json"
    ));
    let differences = "--method fd --step 0.02 --spp 2048 -o d.npz --json";
    capwalk.json(&format!("gradient room.xml {MOTION} {differences}"));
    let (gradient, differences) = (layers(&capwalk, "g.npz"), layers(&capwalk, "d.npz"));
    let missing = pixels(&gradient, "missing");
    let [gradient, differences] = [&gradient, &differences].map(|image| pixels(image, "gradient"));
    let rest = factor(&gradient, &differences, |i| missing[i] == 0.0);
    assert!((rest - 1.0).abs() < 0.15, "{rest}");
    // Pixels inside the right board.
    let inside = factor(&gradient, &differences, |i| [56, 57].contains(&i));
    assert!((inside - 1.0).abs() < 0.15, "{inside}");
    // Pixels of its upper edge: how that moves is much of the derivative.
    let edge = factor(&differences, &gradient, |i| [44, 45].contains(&i));
    assert!(edge > 1.5, "{edge}");
}

/// A check compares the light of which nothing is missing, and does not call the whole right.
#[test]
fn a_check_knows_what_is_left_out() {
    let capwalk = with_room("missing_check");
    let options = format!("{MOTION} {ALLOW} --spp 900 --json");
    let check = capwalk.run(&format!(
        "check room.xml {options} --step 0.02 -o c.npz,c.png"
    ));
    assert_eq!(check.status, 6, "{}{}", check.stderr, check.stdout);
    let json: serde_json::Value = serde_json::from_str(&check.stdout).expect("JSON");
    let comparison = &json["comparison"];
    assert_eq!(comparison["verdict"], "partial");
    assert_eq!(comparison["verdict_of_rest"], "right", "{comparison}");

    // Nothing is left out twice, and nothing else: so few samples are the same of both.
    let options = format!("{MOTION} {ALLOW} --spp 15 --json");
    capwalk.run(&format!(
        "check room.xml {options} --step 0.02 -o c.npz,c.png"
    ));
    capwalk.json(&format!("gradient room.xml {options} -o g.npz"));
    let (check, gradient) = (layers(&capwalk, "c.npz"), layers(&capwalk, "g.npz"));
    let [rest, missing] = ["value", "missing"].map(|layer| pixels(&check, layer));
    for (i, whole) in pixels(&gradient, "value").into_iter().enumerate() {
        let parts = rest[i] + missing[i];
        assert!(
            (parts - whole).abs() < 1e-5 * (1.0 + whole),
            "{i}: {parts} {whole}"
        );
    }
}

/// The same samples, one after the other.
#[test]
fn both_modes_leave_out_the_same() {
    let capwalk = with_room("missing_both_modes");
    let options = format!("{MOTION} {ALLOW} --method edges --spp 128");
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
        "backward room.xml --adjoint ones.npz --layer value {options} --seed 7 --json"
    ));
    let forward = format!("gradient room.xml {options} --seed 3 --json -o f.npz");
    let forward = capwalk.json(&forward);
    let parameter = &back["parameters"][0];
    let [value, error] =
        ["value", "standard_error"].map(|key| parameter[key].as_f64().expect("a number"));
    let layered = layers(&capwalk, "f.npz");
    let sum: f64 = pixels(&layered, "gradient").iter().sum();
    let spread: f64 = pixels(&layered, "stderr").iter().map(|e| e * e).sum();
    let spread = spread.sqrt().hypot(error);
    assert!(
        (value - sum).abs() < 4.0 * spread,
        "{value} {sum} ± {spread}"
    );
    assert!(spread < 0.1 * sum.abs(), "{sum} ± {spread}");
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
