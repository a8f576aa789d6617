//! Scenes in which capwalk differs from Mitsuba on purpose, and by how much it
//! may: a difference that grows is a fault like any other. They are listed in
//! `tests/parity/deviations.json`, where the golden images find them, too.

use std::fs;

use anyhow::{Context, Result};
use serde_json::Value;

use crate::shell::root;

/// A difference on purpose, and its bounds.
pub struct Deviation {
    /// Why it differs.
    pub reason: String,
    /// Largest share of pixels that may fail their z-test.
    failing: f64,
    /// Largest relative difference of the mean brightness, either sign.
    brightness: f64,
}

/// Standard errors of the sum of all differences within which an image counts
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
    /// The deviation of the scene with this name, if it may differ.
    pub fn of(scene: &str) -> Result<Option<Self>> {
        let file = root().join("tests/parity/deviations.json");
        let text =
            fs::read_to_string(&file).with_context(|| format!("cannot read {}", file.display()))?;
        let all: Value = serde_json::from_str(&text)?;
        let Some(known) = all.get(scene) else {
            return Ok(None);
        };
        let at_most = |key: &str| {
            let bound = known[key]["at_most"].as_f64();
            bound.with_context(|| format!("{}: no bound for \"{key}\"", file.display()))
        };
        Ok(Some(Self {
            reason: known["reason"].as_str().unwrap_or_default().to_owned(),
            failing: at_most("failing_pixels")?,
            brightness: at_most("brightness")?,
        }))
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

    fn known() -> Deviation {
        Deviation {
            reason: "b".into(),
            failing: 0.01,
            brightness: 0.003,
        }
    }

    fn judge(passing: f64, brightness: f64, sign: f64, right: bool) -> Finding {
        let result = json!({
            "passing": passing,
            "relative_mean_difference": brightness,
            "sign": sign,
            "right": right,
        });
        known().judge(&result).expect("all numbers are there")
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
        assert!(known().judge(&result).is_err());
    }

    #[test]
    fn the_file_is_complete() {
        let folder = root().join("tests/parity");
        let text = fs::read_to_string(folder.join("deviations.json")).unwrap();
        let all: Value = serde_json::from_str(&text).unwrap();
        for scene in all.as_object().unwrap().keys() {
            assert!(folder.join(format!("{scene}.xml")).exists(), "{scene}");
            let known = Deviation::of(scene).unwrap().unwrap();
            assert!(!known.reason.is_empty(), "{scene}");
        }
        assert!(Deviation::of("no such scene").unwrap().is_none());
    }
}
