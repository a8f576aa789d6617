//! Words of any length and numbers of any size make messages that can be read.

use crate::{Capwalk, assert_has};

/// More than a message should have, bytes.
const LONG: usize = 4000;

#[test]
fn long_names_make_short_messages() {
    let capwalk = Capwalk::new("long_names");
    capwalk.run("render leaf --size 4x3 --spp 2 -o a.npz");
    let name = "n".repeat(70_000);
    for command in [
        "render leaf --set NAME=1",
        "render leaf --set NAME",
        "render leaf --size NAME",
        "render leaf -s NAME",
        "render leaf -o NAME.npz",
        "render leaf -o NAME/a.npz",
        "render NAME",
        "compare a.npz a.npz --layer NAME",
        "compare NAME.npz NAME.npz",
        "backward leaf --loss l2 --target a.npz --size 4x3 --layer NAME",
        "backward leaf --loss l2 --target a.npz --size 4x3 -p NAME",
        "gradient leaf --motion NAME=x",
        "gradient leaf --motion leaf=NAME",
        "gradient leaf -p NAME",
        "gradient leaf -p leaf.positions[NAME",
        "scenes NAME",
        "optimize NAME.toml",
        "NAME",
    ] {
        let message = capwalk.error(&command.replace("NAME", &name));
        assert!(message.len() < LONG, "{command}: {} bytes", message.len());
        assert_has(&message, &["nnnnnnnnnn…"]);
    }
}

/// Numbers of three hundred digits are powers of ten.
#[test]
fn large_numbers_make_short_messages() {
    let capwalk = Capwalk::new("large_numbers");
    for command in [
        "render leaf --set lamp.emitter.radiance.value=-1e300",
        "render leaf --set lamp.emitter.radiance.value=-1e300,-1e300,-1e300",
        "gradient leaf -p leaf.translate.x --method fd --step 1e300",
        "check leaf -p leaf.translate.x --step 1e300",
    ] {
        let message = capwalk.error(command);
        assert_has(&message, &["1e300"]);
        assert!(!message.contains("00000000000000000000"), "{message}");
    }
}

/// Arrays whose names could not be read are refused before anything is computed.
#[test]
fn long_sums_have_no_arrays() {
    let capwalk = Capwalk::new("long_sums");
    capwalk.run("render leaf --size 4x3 --spp 2 -o a.npz");
    let backward = "backward leaf --adjoint a.npz --size 4x3 --spp 4 -p";
    let sum = vec!["leaf.translate.x"; 600].join("+");
    let message = capwalk.error(&format!("{backward} {sum}"));
    assert_has(
        &message,
        &["a name of 10199 bytes", "expected at most 8188", "shorter"],
    );
}

/// What begins with a minus is joined to its option.
#[test]
fn values_with_a_minus() {
    let capwalk = Capwalk::new("minus");
    capwalk.run("render leaf --size 4x3 --spp 2 -o a.npz");
    let backward = "backward leaf --adjoint a.npz --size 4x3 --spp 2";
    let message = capwalk.error(&format!("{backward} -p -leaf.translate.x"));
    let advice = "--param=-leaf.translate.x";
    assert_has(&message, &[advice]);
    assert!(!message.contains("-- -"), "{message}");
    let finished = capwalk.run(&format!("{backward} {advice}"));
    assert_eq!(finished.status, 0, "{}", finished.stderr);
}

/// A step that rounding swallows, also where some coordinates are zero.
#[test]
fn steps_below_rounding_are_refused() {
    let capwalk = Capwalk::new("small_steps");
    let small = "--size 4x3 --spp 2 --step 1e-17";
    for command in [
        "gradient leaf -p leaf.translate.x --method fd",
        "gradient leaf -p floor.translate.y --method fd",
        "gradient leaf -p sensor.translate.x --method fd",
        "check leaf -p leaf.translate.x",
    ] {
        let message = capwalk.error(&format!("{command} {small}"));
        assert_has(&message, &["changes nothing", "1e-17", "larger step"]);
    }
}

/// One word of what was expected.
#[test]
fn times_of_jobs_are_expected_once() {
    let capwalk = Capwalk::new("times_of_jobs");
    capwalk.write(
        "job.toml",
        "scene = \"leaf\"\niterations = 1\nspp = 1\ntime_limit = \"x\"\n",
    );
    let message = capwalk.error("optimize job.toml");
    assert_has(&message, &["expected a time above 0"]);
    assert!(!message.contains("expected expected"), "{message}");
}
