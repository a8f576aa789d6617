//! Claims and what follows about them from measured numbers.

use std::fmt;

use capwalk_diff::check;
use capwalk_math::Moments;

/// A claim of the paper beside what was measured here.
#[derive(Clone, Debug, PartialEq)]
pub struct Claim {
    /// What is claimed.
    pub statement: String,
    /// The paper's number or figure.
    pub paper: String,
    /// Ours, with its uncertainty.
    pub ours: String,
    /// What follows.
    pub verdict: Verdict,
}

/// What follows about a claim.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// It is so here, beyond the uncertainty.
    Holds,
    /// It is not so here, beyond the uncertainty.
    DoesNotHold(String),
    /// The uncertainty is too large.
    Inconclusive(String),
    /// The number depends on what differs between the paper and here.
    NotComparable(String),
}

impl Verdict {
    /// Its words, without the reason.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::DoesNotHold(_) => "does not hold",
            Self::Inconclusive(_) => "inconclusive",
            Self::NotComparable(_) => "not comparable",
        }
    }

    /// Why a claim is not said to hold.
    pub fn reason(&self) -> Option<&str> {
        match self {
            Self::Holds => None,
            Self::DoesNotHold(reason)
            | Self::Inconclusive(reason)
            | Self::NotComparable(reason) => Some(reason),
        }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.reason() {
            None => f.write_str(self.name()),
            Some(reason) => write!(f, "{}: {reason}", self.name()),
        }
    }
}

/// Standard errors beyond which something is not an accident: one false verdict
/// in 740 for a single test.
pub const SIGNIFICANT: f64 = 3.0;

/// A number and its standard error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The number.
    pub value: f64,
    /// Its standard error; 0 for numbers without noise.
    pub error: f64,
}

impl From<Moments> for Measured {
    fn from(moments: Moments) -> Self {
        Self {
            value: moments.mean,
            error: moments.standard_error(),
        }
    }
}

impl Measured {
    /// A number without noise.
    pub fn exact(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// Times a number without noise.
    pub fn times(self, factor: f64) -> Self {
        Self {
            value: factor * self.value,
            error: factor.abs() * self.error,
        }
    }

    /// `self / other`, errors to first order.
    pub fn over(self, other: Self) -> Self {
        let value = self.value / other.value;
        let error = self.error.hypot(value * other.error) / other.value.abs();
        Self { value, error }
    }

    /// Difference from a number in standard errors.
    pub fn z(self, expected: f64) -> f64 {
        let difference = self.value - expected;
        match difference == 0.0 {
            true => 0.0,
            false => difference / self.error,
        }
    }
}

impl fmt::Display for Measured {
    /// The error in two digits, the value to the same place; no error if there is
    /// none, and words for what is not known.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { value, error } = *self;
        if !value.is_finite() {
            return write!(f, "a number that cannot be told");
        }
        if !error.is_finite() {
            return write!(f, "{} (its error cannot be told)", digits(value));
        }
        if error <= 0.0 {
            return write!(f, "{}", digits(value));
        }
        let place = 1.0 - error.log10().floor();
        if place <= 6.0 || value.abs() >= 1e-3 {
            let place = place.max(0.0) as usize;
            return write!(f, "{value:.place$} ± {error:.place$}");
        }
        // Both in the unit of the larger one.
        let exponent = value.abs().max(error).log10().floor();
        let place = (place + exponent) as usize;
        let [value, error] = [value, error].map(|x| x / 10_f64.powf(exponent));
        write!(f, "({value:.place$} ± {error:.place$})e{exponent}")
    }
}

/// A number in about three digits.
pub fn digits(x: f64) -> String {
    let size = x.abs();
    if size != 0.0 && !(1e-3..1e6).contains(&size) {
        return format!("{x:.2e}");
    }
    let decimals = match size == 0.0 {
        true => 0,
        false => (2.0 - size.log10().floor()).clamp(0.0, 6.0) as usize,
    };
    format!("{x:.decimals$}")
}

/// That every number is what it should be. Too noisy to say so if an error
/// exceeds the `tolerance`, the deviation that matters.
pub fn all_equal(numbers: &[Measured], expected: f64, tolerance: f64) -> Verdict {
    // The more numbers, the more of them are far off by accident (Bonferroni).
    let allowed = SIGNIFICANT + 0.5 * (numbers.len() as f64).ln();
    let worst = numbers
        .iter()
        .max_by(|a, b| a.z(expected).abs().total_cmp(&b.z(expected).abs()))
        .expect("there are numbers to compare");
    if worst.z(expected).abs() > allowed {
        let z = worst.z(expected);
        return Verdict::DoesNotHold(match z.is_finite() {
            true => format!("{worst} is {z:.1} standard errors from {expected}"),
            false => format!("{worst} is not {expected}"),
        });
    }
    match numbers.iter().find(|n| n.error > tolerance) {
        Some(noisy) => Verdict::Inconclusive(format!("{noisy} is too noisy")),
        None => Verdict::Holds,
    }
}

/// That a number is above zero.
pub fn positive(number: Measured) -> Verdict {
    match below(Measured::exact(0.0), number) {
        Verdict::DoesNotHold(_) => Verdict::DoesNotHold(format!("{number} is below zero")),
        Verdict::Inconclusive(_) => Verdict::Inconclusive(format!("{number} may be zero")),
        other => other,
    }
}

/// That a number is below another.
pub fn below(smaller: Measured, larger: Measured) -> Verdict {
    let error = smaller.error.hypot(larger.error);
    let z = (larger.value - smaller.value) / error;
    if z > SIGNIFICANT {
        Verdict::Holds
    } else if z < -SIGNIFICANT {
        Verdict::DoesNotHold(format!("{smaller} is above {larger}"))
    } else {
        Verdict::Inconclusive(format!("{smaller} against {larger}"))
    }
}

/// That all of several claims hold.
pub fn all(verdicts: impl IntoIterator<Item = Verdict>) -> Verdict {
    let mut verdict = Verdict::Holds;
    for other in verdicts {
        match (&verdict, &other) {
            (Verdict::DoesNotHold(_), _) | (_, Verdict::Holds) => {}
            (Verdict::Holds, _) | (_, Verdict::DoesNotHold(_)) => verdict = other,
            _ => {}
        }
    }
    verdict
}

/// That a derivative image is that of its reference.
pub fn of_check(comparison: &check::Comparison) -> Verdict {
    match &comparison.verdict {
        check::Verdict::Right => Verdict::Holds,
        check::Verdict::Wrong { reason } => Verdict::DoesNotHold(reason.clone()),
        check::Verdict::Inconclusive {
            samples_factor,
            doubt,
        } => Verdict::Inconclusive(match (doubt, samples_factor.is_finite()) {
            (Some(doubt), _) => doubt.clone(),
            (None, true) => format!("needs {} times the samples", digits(*samples_factor)),
            (None, false) => "too few samples to say how many are needed".into(),
        }),
    }
}

/// That a derivative image is not that of its reference.
pub fn of_deviation(comparison: &check::Comparison) -> Verdict {
    match of_check(comparison) {
        Verdict::DoesNotHold(_) => Verdict::Holds,
        Verdict::Holds => Verdict::DoesNotHold("it agrees here".into()),
        other => other,
    }
}

/// What a comparison of images found, in one line.
pub fn in_words(comparison: &check::Comparison) -> String {
    let factor = Measured {
        value: comparison.scale_factor,
        error: comparison.scale_factor_error,
    };
    let z_squared = Measured {
        value: comparison.mean_z_squared,
        error: comparison.mean_z_squared_error,
    };
    format!("best factor {factor}, mean z² {z_squared}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measured(value: f64, error: f64) -> Measured {
        Measured { value, error }
    }

    #[test]
    fn verdicts_follow_from_numbers() {
        let is = |verdict: Verdict| match verdict {
            Verdict::Holds => 1,
            Verdict::DoesNotHold(_) => -1,
            Verdict::Inconclusive(_) => 0,
            Verdict::NotComparable(_) => 2,
        };
        assert_eq!(is(below(measured(1.0, 0.1), measured(2.0, 0.1))), 1);
        assert_eq!(is(below(measured(2.0, 0.1), measured(1.0, 0.1))), -1);
        assert_eq!(is(below(measured(1.0, 0.1), measured(1.2, 0.1))), 0);
        let close = [measured(1.01, 0.01), measured(1.0, 0.0)];
        assert_eq!(is(all_equal(&close, 1.0, 0.05)), 1);
        assert_eq!(is(all_equal(&close, 1.0, 0.005)), 0);
        assert_eq!(is(all_equal(&[measured(1.1, 0.01)], 1.0, 0.05)), -1);
        assert_eq!(is(all_equal(&[measured(1.1, 0.0)], 1.0, 0.05)), -1);
        let unsure = || Verdict::Inconclusive(String::new());
        let wrong = || Verdict::DoesNotHold(String::new());
        assert_eq!(is(all([Verdict::Holds, unsure(), wrong()])), -1);
        assert_eq!(is(all([wrong(), unsure()])), -1);
        assert_eq!(is(all([unsure(), Verdict::Holds])), 0);
        assert_eq!(is(all([Verdict::Holds, Verdict::Holds])), 1);
    }

    #[test]
    fn ratios_have_errors_at_zero_too() {
        let ratio = measured(3.0, 0.3).over(measured(2.0, 0.2));
        assert!((ratio.error / 1.5 - 0.02_f64.sqrt()).abs() < 1e-12);
        let nothing = measured(0.0, 0.0).over(measured(2.0, 0.2));
        assert_eq!(nothing, measured(0.0, 0.0));
        assert_eq!(below(nothing, measured(0.1, 0.0)), Verdict::Holds);
    }

    #[test]
    fn numbers_are_as_long_as_their_errors() {
        assert_eq!(measured(0.032146, 0.00123).to_string(), "0.0321 ± 0.0012");
        assert_eq!(measured(1234.6, 12.3).to_string(), "1235 ± 12");
        assert_eq!(measured(-5e-5, 2.92e-7).to_string(), "(-5.000 ± 0.029)e-5");
        assert_eq!(measured(2.65e-6, 1.02e-6).to_string(), "(2.7 ± 1.0)e-6");
        assert_eq!(measured(-1e-9, 3.04e-7).to_string(), "(-0.0 ± 3.0)e-7");
        assert_eq!(
            measured(-2.0, 2.46e-6).to_string(),
            "-2.0000000 ± 0.0000025"
        );
    }

    #[test]
    fn what_is_exact_or_unknown_is_said_in_words() {
        assert_eq!(measured(1.0, 0.0).to_string(), "1.00");
        assert_eq!(measured(0.0, 0.0).to_string(), "0");
        let unknown = measured(0.922, f64::INFINITY).to_string();
        assert_eq!(unknown, "0.922 (its error cannot be told)");
        for error in [f64::INFINITY, f64::NAN, 0.1] {
            let unknown = measured(f64::NAN, error).to_string();
            assert_eq!(unknown, "a number that cannot be told");
        }
        let zero = positive(measured(0.017, 0.012)).to_string();
        assert_eq!(zero, "inconclusive: 0.017 ± 0.012 may be zero");
    }

    #[test]
    fn digits_are_about_three() {
        assert_eq!(digits(0.000_012_34), "1.23e-5");
        assert_eq!(digits(123.4), "123");
    }
}
