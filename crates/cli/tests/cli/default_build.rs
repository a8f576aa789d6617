//! What a program that was built without the feature `paper` says about its methods.

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
