//! Methods by name: what they refuse, and what they say of themselves.

use capwalk_scene_io::image;

use crate::{Capwalk, assert_has};

const LEAF: &str = "leaf -p leaf.translate.x --size 12x9 --spp 4";

#[test]
fn options_of_other_methods_are_errors() {
    let capwalk = Capwalk::new("method_options");
    let refused = |arguments: &str, words: &[&str]| {
        assert_has(&capwalk.error(&format!("{arguments} {LEAF}")), words);
    };
    refused(
        "gradient --was-rays 16",
        &["--was-rays", "the method is walk", "--method was"],
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
    refused("gradient --step 0.1", &["--step", "--method fd"]);
    refused("check --method fd", &["nothing to check", "compare"]);
    refused("gradient --method was --was-kappa 0", &["above 0"]);
    let backward = "backward --adjoint none.exr --method fd leaf";
    assert_has(
        &capwalk.error(backward),
        &["by one parameter", "gradient --method fd -p NAME"],
    );
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
        "outlines there is missing",
    ];
    assert_has(&finished.stderr, &words);
}

/// Files name the method; baselines are called what they are, once.
#[test]
fn methods_say_what_they_are() {
    let capwalk = Capwalk::new("method_names");
    let run = |method: &str| {
        let finished = capwalk.run(&format!("gradient {LEAF} {method} -o out.exr"));
        assert_eq!(finished.status, 0, "{}", finished.stderr);
        let picture = image::read(&capwalk.path("out.exr")).expect("it was written");
        let notes = picture.metadata.into_iter();
        let of = |key: &str| {
            let mut notes = notes.clone().filter(|(name, _)| name == key);
            notes.next().map(|(_, value)| value)
        };
        (finished.stderr, of("method"), of("step"))
    };
    let (stderr, method, step) = run("");
    assert!(!stderr.contains("baseline"), "{stderr}");
    assert_eq!((method.as_deref(), step), (Some("walk"), None));
    let (_, method, _) = run("--domain triangle");
    assert_eq!(method.as_deref(), Some("walk, domain triangle"));
    let (stderr, method, _) = run("--method psdr-was --was-rays 4");
    assert_has(&stderr, &["psdr-was is a baseline and biased"]);
    assert_eq!(method.as_deref(), Some("psdr-was"));
    let (stderr, method, step) = run("--method was");
    assert_eq!(stderr.matches("baseline").count(), 1, "{stderr}");
    assert_eq!((method.as_deref(), step), (Some("was"), None));
    let (stderr, method, step) = run("--method fd --step 0.125");
    assert_has(&stderr, &["fd is a baseline"]);
    assert_eq!(method.as_deref(), Some("fd"));
    assert_eq!(step.as_deref(), Some("0.125"));
}
