//! The methods of the feature `paper`: what they refuse, and what they say of
//! themselves.

use crate::methods::{LEAF, gradient_by};
use crate::{Capwalk, assert_has};

#[test]
fn options_of_other_methods_are_errors() {
    let capwalk = Capwalk::new("baseline_options");
    let refused = |arguments: &str, words: &[&str]| {
        assert_has(&capwalk.error(&format!("{arguments} {LEAF}")), words);
    };
    refused(
        "gradient --was-rays 16",
        &["--was-rays", "the method is auto", "--method was"],
    );
    refused(
        "check --method was --walk-steps 2",
        &["--walk-steps", "the method is was", "--method walk"],
    );
    refused(
        "gradient --method was --domain triangle",
        &["--domain", "the method is was"],
    );
    refused(
        "gradient --method fd --was-debias",
        &["--was-debias", "the method is fd"],
    );
    refused("gradient --method was --was-kappa 0", &["above 0"]);
}

/// Beside textures that jump, motion is differentiated by walks and gathered edges, and
/// refused with the baselines.
#[test]
fn baselines_know_no_textures_that_jump() {
    let capwalk = Capwalk::new("jumps");
    let scene = r#"<scene version="3.0.0"><integrator type="direct"/><sensor type="perspective"/>
<emitter type="constant"/><shape type="cube" id="box"><bsdf type="diffuse">
<texture name="reflectance" type="checkerboard"/></bsdf></shape></scene>"#;
    capwalk.write("board.xml", scene);
    let gradient = "gradient board.xml -p box.scale --size 8x8 --spp 1";
    assert_eq!(capwalk.run(gradient).status, 0);
    let message = capwalk.error(&format!("{gradient} --method was"));
    assert_has(
        &message,
        &["box.bsdf.reflectance", "discontinuous", "bilinear"],
    );
    let info = capwalk.run("info board.xml").stdout;
    let colours = ["checkerboard of (0.4", "box.bsdf.reflectance.color1.value"];
    assert_has(&info, &colours);
    assert!(!info.contains("refused"), "{info}");
}

/// What is refused elsewhere is a warning here.
#[test]
fn mirrors_are_a_warning() {
    let scene = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../tests/scenes/object_moves_in_a_curved_mirror/scene.xml"
    );
    let capwalk = Capwalk::new("method_mirrors");
    let finished = capwalk.run(&format!(
        "gradient {scene} -p thing.translate.x --spp 2 --method was"
    ));
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    let words = [
        "baseline and biased",
        "specular events",
        "% of the radiance arrives by paths with such events, whether",
    ];
    assert_has(&finished.stderr, &words);
}

/// Files name the method; baselines are called what they are, once.
#[test]
fn methods_say_what_they_are() {
    let capwalk = Capwalk::new("baseline_names");
    let run = |method: &str| gradient_by(&capwalk, method);
    let (stderr, method, _) = run("--domain triangle");
    assert_has(&stderr, &["rare samples are very large"]);
    assert_eq!(method.as_deref(), Some("walk, domain triangle"));
    let (stderr, method, _) = run("--method psdr-was --was-rays 4");
    assert_has(&stderr, &["psdr-was is a baseline and biased"]);
    assert_eq!(method.as_deref(), Some("psdr-was"));
    let (stderr, method, step) = run("--method was");
    assert_eq!(stderr.matches("baseline").count(), 1, "{stderr}");
    assert_eq!((method.as_deref(), step), (Some("was"), None));
}

/// On triangles, too.
#[test]
fn infinite_variance_is_said() {
    let capwalk = Capwalk::new("baseline_literal");
    for (walk, expected) in [
        ("", 0),
        ("--estimator literal", 1),
        ("--estimator literal --antithetic", 0),
    ] {
        let (stderr, ..) = gradient_by(&capwalk, &format!("--domain triangle {walk}"));
        let found = stderr.matches("infinite variance").count();
        assert_eq!(found, expected, "{walk}: {stderr}");
    }
}
