//! How far the field of ours reaches, and what that does to its variance: the reason
//! where its error is not below another one's.

use capwalk_diff::{Method, WalkSettings};

use crate::claim::{self, Measured, Verdict};
use crate::figure::Table;
use crate::gradients::{Run, Subject};
use crate::settings::{Failure, Settings};

/// Radians.
const REACHES: [f64; 6] = [0.2, 0.1, 0.05, 0.025, 0.0125, 0.00625];

/// Ours with a field that reaches this far.
pub struct Reached {
    /// Radians.
    pub reach: f64,
    /// Of a sample.
    pub variance: Measured,
    pub run: Run,
}

/// Ours with each reach, with few samples: variances of samples do not depend on
/// how many there are. Random numbers are those from the `set`-th on.
pub fn measure(subject: &Subject, set: u64, settings: &Settings) -> Result<Vec<Reached>, Failure> {
    let spp = settings.quality.choose(4, 32, 32);
    let with = |(i, reach): (u64, f64)| {
        let walk = WalkSettings {
            max_radius: reach,
            ..WalkSettings::default()
        };
        let run = subject.gradient(Method::Walk, walk, spp, set + i, settings)?;
        Ok(Reached {
            reach,
            variance: run.variance(),
            run,
        })
    };
    (0..).zip(REACHES).map(with).collect()
}

/// The variances beside those of other methods.
pub fn table<'a>(reaches: &[Reached], others: impl Iterator<Item = (&'a str, &'a Run)>) -> Table {
    let line = |name: &str, reach: String, run: &Run| {
        vec![
            name.to_owned(),
            reach,
            run.spp.to_string(),
            run.variance().to_string(),
        ]
    };
    let ours = reaches
        .iter()
        .map(|reached| line("ours", reached.reach.to_string(), &reached.run));
    let others = others.map(|(name, run)| line(name, String::new(), run));
    Table {
        title: "Reach".into(),
        columns: vec![
            "method",
            "reach of the field, rad",
            "samples per pixel",
            "variance of a sample",
        ],
        rows: ours.chain(others).collect(),
    }
}

/// What the reach of ours has to do with an error that is not below another method's:
/// the least variance that was found beside the other's.
pub fn in_words(reaches: &[Reached], reach: f64, (name, variance): (&str, Measured)) -> String {
    let least = reaches
        .iter()
        .min_by(|a, b| a.variance.value.total_cmp(&b.variance.value))
        .expect("there are reaches");
    let conclusion = match claim::below(least.variance, variance) {
        Verdict::Holds => "the reach is the reason",
        Verdict::DoesNotHold(_) => "the reach alone is not the reason",
        _ => "whether the reach is the reason could not be told",
    };
    format!(
        "; here the field reaches {reach:.3} rad; of {} reaches tried, {} rad has the least variance of a \
         sample, {}, beside {variance} of {name}: {conclusion}",
        reaches.len(),
        least.reach,
        least.variance
    )
}

/// What a caption says of the table.
pub const CAPTION: &str = "The last table has the variance of a sample of ours by the reach of \
     its field; images and claims have the reach that the pilot finds.";
