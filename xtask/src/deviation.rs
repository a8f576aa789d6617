//! Scenes in which capwalk differs from Mitsuba on purpose, and by how much it
//! may: a difference that grows is a fault like any other.

use anyhow::{Context, Result};
use serde_json::Value;

/// A difference on purpose, and its bounds.
pub struct Deviation {
    /// The scene's file in `tests/parity`, without its ending.
    pub scene: &'static str,
    /// Why it differs.
    pub reason: &'static str,
    /// Largest share of pixels that may fail their z-test.
    pub failing: f64,
    /// Largest relative difference of the mean brightness, either sign.
    pub brightness: f64,
}

/// Bounds are two and a half times what was measured (docs/benchmarks.md).
pub const DEVIATIONS: [Deviation; 2] = [
    Deviation {
        scene: "coarse_normals",
        reason: "the face decides which side is seen, not the interpolated normal (docs/scene-files.md)",
        failing: 0.01,     // measured: 0.39 %
        brightness: 0.003, // measured: 0.12 %
    },
    Deviation {
        scene: "turned_normals",
        reason: "normals of maps that turn away from the viewer are not turned back, which would \
                 be a jump (docs/scene-files.md)",
        failing: 0.06,    // measured: 2.38 %
        brightness: 0.01, // measured: -0.39 %
    },
];

/// Standard errors of the sum of all differences within which a picture counts
/// as equal by a wide margin; a difference is called one at four.
const CLEARLY_EQUAL: f64 = 2.0;

/// How a scene that may differ does.
#[derive(Debug, PartialEq)]
pub enum Finding {
    /// It differs within its bounds, or is equal by accident.
    AsKnown,
    /// It differs by more.
    Drifted(String),
    /// It is equal by a wide margin: the entry is perhaps out of date.
    Stale,
}

impl Deviation {
    /// That of this scene, if it may differ.
    pub fn of(scene: &str) -> Option<&'static Self> {
        DEVIATIONS.iter().find(|known| known.scene == scene)
    }

    /// Judges what `parity.py` found; an error if a number is missing.
    pub fn judge(&self, result: &Value) -> Result<Finding> {
        let number = |key: &str| {
            let number = result[key].as_f64();
            number.with_context(|| format!("Mitsuba's script gave no number \"{key}\": {result}"))
        };
        let failing = 1.0 - number("passing")?;
        let brightness = number("relative_mean_difference")?.abs();
        let mut beyond = Vec::new();
        for (what, found, bound) in [
            ("failing pixels", failing, self.failing),
            ("brightness", brightness, self.brightness),
        ] {
            if found > bound {
                let (found, bound) = (100.0 * found, 100.0 * bound);
                beyond.push(format!(
                    "{what} {found:.2} % instead of at most {bound:.2} %"
                ));
            }
        }
        if !beyond.is_empty() {
            return Ok(Finding::Drifted(beyond.join(", ")));
        }
        let equal = result["right"].as_bool().unwrap_or(false);
        let clearly = failing == 0.0 && number("sign")?.abs() < CLEARLY_EQUAL;
        Ok(match equal && clearly {
            true => Finding::Stale,
            false => Finding::AsKnown,
        })
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    const KNOWN: Deviation = Deviation {
        scene: "a",
        reason: "b",
        failing: 0.01,
        brightness: 0.003,
    };

    fn judge(passing: f64, brightness: f64, sign: f64, right: bool) -> Finding {
        let result = json!({
            "passing": passing,
            "relative_mean_difference": brightness,
            "sign": sign,
            "right": right,
        });
        KNOWN.judge(&result).expect("all numbers are there")
    }

    #[test]
    fn a_known_difference_may_not_grow() {
        assert_eq!(judge(0.9961, 0.0012, 2.6, false), Finding::AsKnown);
        assert_eq!(judge(0.9961, -0.0012, -2.6, false), Finding::AsKnown);
        let drifted = |finding, what: &str| match finding {
            Finding::Drifted(text) => assert!(text.contains(what), "{text}"),
            other => panic!("{other:?}"),
        };
        drifted(
            judge(0.98, 0.0012, 2.6, false),
            "failing pixels 2.00 % instead of at most 1.00 %",
        );
        for brightness in [0.004, -0.004] {
            let text = "brightness 0.40 % instead of at most 0.30 %";
            drifted(judge(0.9961, brightness, 2.6, false), text);
        }
        // However equal the test finds them.
        drifted(judge(1.0, 0.004, 0.0, true), "brightness");
    }

    #[test]
    fn an_entry_without_a_difference_is_stale() {
        assert_eq!(judge(1.0, 0.0001, 0.5, true), Finding::Stale);
        // Equal, but only just.
        assert_eq!(judge(0.9990, 0.0001, 0.5, true), Finding::AsKnown);
        assert_eq!(judge(1.0, 0.0001, -3.0, true), Finding::AsKnown);
        assert_eq!(judge(1.0, 0.0001, 0.5, false), Finding::AsKnown);
    }

    /// A number that is not there must not pass.
    #[test]
    fn missing_numbers_are_errors() {
        let result = json!({ "passing": null, "relative_mean_difference": 0.0 });
        assert!(KNOWN.judge(&result).is_err());
    }

    #[test]
    fn the_scenes_exist() {
        for known in &DEVIATIONS {
            let file = format!("tests/parity/{}.xml", known.scene);
            assert!(crate::shell::root().join(&file).exists(), "{file}");
        }
    }
}
