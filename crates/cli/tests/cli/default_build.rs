//! What a program that was built without features says about what they add.

use crate::methods::LEAF;
use crate::{Capwalk, assert_has};

#[test]
fn baselines_are_left_out_and_say_so() {
    let capwalk = Capwalk::new("left_out");
    for choice in [
        "--method was",
        "--method psdr-was",
        "--domain triangle",
        "--domain explicit",
    ] {
        for command in ["gradient", "check"] {
            let message = capwalk.error(&format!("{command} {LEAF} {choice}"));
            assert_has(&message, &[choice, "--features paper"]);
        }
        let help = capwalk.run("gradient --help").stdout;
        let (option, name) = choice.split_once(' ').expect("an option and its value");
        let is_offered = help
            .lines()
            .any(|line| line.contains(&format!("- {name}:")));
        assert!(!is_offered, "{option} {name} in:\n{help}");
    }
}

#[cfg(not(feature = "gpu"))]
#[test]
fn without_the_feature_a_gpu_is_an_error_that_says_how_to_build_it() {
    let capwalk = Capwalk::new("device_not_built");
    let render = "render leaf --spp 1 --size 8x6 -o image.exr";
    let message = capwalk.error(&format!("{render} --device gpu"));
    assert_has(
        &message,
        &["built without the GPU", "--features gpu", "--device cpu"],
    );
    assert!(!capwalk.folder.join("image.exr").exists());
    // Without a GPU, any is as good as another.
    let json = capwalk.json(&format!("{render} --device auto --json"));
    assert_eq!(json["device"], "cpu");
}
