//! A gradient against finite differences.

use capwalk_diff::GradientImage;
use capwalk_diff::check::{
    Comparison, Verdict, compare, compare_with_differences, without_rounding,
};
use capwalk_diff::{GradientOptions, Missing, Stencil};
use capwalk_scene::{Scene, Tangent};

use crate::direction;
use crate::edge_on::EdgeOnFace;
use crate::error::Error;
use crate::options::{self, DifferenceOptions, check_spp};
use crate::text::{count, list, number, plus_minus, significant};

/// Samples of the reference for each one of the gradient, before the noise of both is known:
/// differences are cheaper, and noisier.
const REFERENCE_FACTOR: u32 = 4;

/// Makes the reference's random numbers independent of the gradient's.
const REFERENCE_SEED: u64 = 0x9e37_79b9_7f4a_7c15;

/// How many times the samples of the first reference others have. Where no step was asked for,
/// that of each is so many times smaller than that of the one before.
pub(crate) const SECOND_FACTOR: u32 = 4;

/// How many references are made at most, where each contradicts the one before.
const MOST_REFERENCES: u32 = 4;

/// Makes the random numbers of further references independent of the first.
const NEXT_SEED: u64 = 0xb7e1_5162_8aed_2a6a;

/// Makes those of the second gradient independent of all these.
const SECOND_GRADIENT_SEED: u64 = 0x6a09_e667_f3bc_c908;

/// Makes those of the reference that the second gradient is compared with independent of all these.
const CONFIRMATION_SEED: u64 = 0x3c6e_f372_fe94_f82b;

/// How many of the worst pixels are shown.
const SHOWN_PIXELS: usize = 4;

/// Pairs of shapes, and faces, that are named, at most.
const SHOWN_PAIRS: usize = 5;

/// How a gradient is checked.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CheckOptions {
    /// How the gradient is estimated.
    pub gradient: GradientOptions,
    /// Samples per pixel of the first reference on each side of the difference; `None` takes as
    /// many as bring the most for the time: more, the noisier differences are beside the gradient.
    /// Others, where the first contradicts the gradient or leaves a doubt of it, have four times as
    /// many.
    pub reference_spp: Option<u32>,
    /// How far the parameter moves on each side, in its own units; `None` chooses
    /// [`Prepared::difference_step`](crate::Prepared::difference_step).
    pub step: Option<f64>,
}

impl CheckOptions {
    /// How the reference for a motion of a scene is made, with the given step if none is asked
    /// for. Its random numbers are independent of the gradient's.
    pub fn reference(
        &self,
        scene: &Scene,
        tangent: &Tangent,
        step: impl FnOnce() -> f64,
    ) -> Result<Reference, Error> {
        let GradientOptions {
            spp,
            seed,
            adaptive,
            ..
        } = self.gradient;
        direction::check(tangent, || direction::VELOCITIES.into())?;
        let fits_scene = self.step.is_none();
        let step = options::step(self.step, step)?;
        let spp = self
            .reference_spp
            .unwrap_or(spp.saturating_mul(REFERENCE_FACTOR));
        check_spp("reference_spp", spp)?;
        Ok(Reference {
            spp,
            fits_noise: self.reference_spp.is_none(),
            adaptive,
            seed: seed ^ REFERENCE_SEED,
            step,
            fits_scene,
            sides: Stencil::of(scene, tangent, step)?,
        })
    }
}

/// How the reference of a check is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// Samples per pixel on each side.
    pub spp: u32,
    /// Whether as many are taken instead as suit the noise.
    pub fits_noise: bool,
    /// Whether pixels get more or fewer of them by how noisy they are.
    pub adaptive: bool,
    /// Seed of its random numbers.
    pub seed: u64,
    /// How far the parameter moves on each side, in its own units.
    pub step: f64,
    /// Whether no step was asked for, and this is the one that fits the scene.
    pub fits_scene: bool,
    /// Whether it moves to both sides.
    pub sides: Stencil,
}

impl Reference {
    /// How far the parameter moves from one side to the other, in its own units.
    pub fn span(&self) -> f64 {
        match self.sides {
            Stencil::Both => 2.0 * self.step,
            Stencil::Above | Stencil::Below => self.step,
        }
    }

    /// Which differences these are, in words.
    pub fn describe(&self) -> String {
        let over = self.over();
        match self.sides {
            Stencil::Both => format!("central differences over {over}"),
            Stencil::Above | Stencil::Below => format!(
                "one-sided differences over {over}: on the other side the scene would not be valid"
            ),
        }
    }

    /// The step with the sides that it is taken to.
    fn over(&self) -> String {
        let sign = match self.sides {
            Stencil::Both => '±',
            Stencil::Above => '+',
            Stencil::Below => '-',
        };
        format!("{sign} {}", number(self.step))
    }

    /// As options of finite differences.
    pub fn options(&self) -> DifferenceOptions {
        DifferenceOptions {
            spp: self.spp,
            adaptive: self.adaptive,
            seed: self.seed,
            step: Some(self.step),
        }
    }
}

/// A gradient, its reference, and how they compare.
#[derive(Clone, Debug)]
pub struct Check {
    /// The gradient in question.
    pub gradient: GradientImage,
    /// Central differences, without what only rounding makes of them.
    pub reference: GradientImage,
    /// The statistics and the verdict.
    pub comparison: Comparison,
    /// How the reference was made.
    pub made: Reference,
    /// How many references were made: 2 if the first contradicted the gradient or left a doubt of
    /// it, up to 4 if they contradicted each other as well; one more if all of them and a second
    /// gradient called it wrong. This is the one that decided.
    pub references: u32,
    /// Samples of all of them.
    pub reference_samples: u64,
    /// Shapes that lie on each other and move against each other, see
    /// [`Prepared::coplanar_shapes`](crate::Prepared::coplanar_shapes).
    pub coplanar: Vec<[String; 2]>,
    /// Faces that the camera sees edge-on and moves against, see
    /// [`Prepared::edge_on_faces`](crate::Prepared::edge_on_faces).
    pub edge_on: Vec<EdgeOnFace>,
    /// True as long as no other reference agrees with this one: if this one speaks against the
    /// gradient, others may change the verdict.
    is_open: bool,
}

impl Check {
    /// Compares a gradient with differences of the same size, and how they were made; where
    /// something is missing, those of the light that it does not concern.
    pub fn new(
        gradient: GradientImage,
        (made, mut reference): (Reference, GradientImage),
        coplanar: Vec<[String; 2]>,
    ) -> Self {
        reference.gradient = without_rounding(&reference, made.step);
        let mut comparison = compare_with_differences(&gradient, &reference, made.span());
        if gradient.missing.is_some() {
            let rest = Box::new(comparison.verdict);
            comparison.verdict = Verdict::Partial { rest };
        }
        Self {
            comparison,
            gradient,
            references: 1,
            is_open: true,
            reference_samples: reference.statistics.samples,
            reference,
            made,
            coplanar,
            edge_on: Vec::new(),
        }
    }

    /// How to make another reference, if this one contradicts the gradient or leaves a doubt of
    /// it, and no other agrees with this one: with other random numbers, and with a smaller step
    /// if it is up to us. The variance of differences grows as the step becomes smaller, and so
    /// does the number of samples of the second one.
    pub(crate) fn next_reference(&self) -> Option<Reference> {
        let is_wanted = self.is_open && self.references < MOST_REFERENCES;
        let contradicts = self.contradiction().is_some() && self.reference.statistics.complete;
        (contradicts && is_wanted).then(|| {
            let Reference { spp, step, .. } = self.made;
            Reference {
                spp: match self.references {
                    1 => spp.saturating_mul(SECOND_FACTOR),
                    _ => spp,
                },
                fits_noise: false,
                seed: self.made.seed ^ NEXT_SEED.rotate_left(self.references - 1),
                step: match self.made.fits_scene {
                    true => step / f64::from(SECOND_FACTOR),
                    false => step,
                },
                ..self.made
            }
        })
    }

    /// The verdict beside another reference, if this one speaks against the gradient.
    ///
    /// * If that one agrees with the gradient, it is right. (A third or fourth one sees no more than
    ///   the second: it must contradict the one before, or noise may have hidden what that saw.)
    /// * If that one speaks against the gradient, too, and does not contradict this one, the gradient
    ///   is wrong if that one calls it so; else this verdict stays.
    /// * If they contradict each other, yet another one is needed.
    /// * If that one is too noisy to say anything, what this one says is a doubt.
    pub(crate) fn with_next_reference(self, (made, image): (Reference, GradientImage)) -> Self {
        let Some(contradiction) = self.contradiction() else {
            return self;
        };
        let references = self.references + 1;
        let samples = self.reference_samples + image.statistics.samples;
        let counted = |is_open: bool, check: Self| Self {
            references,
            reference_samples: samples,
            is_open,
            ..check
        };
        if !image.statistics.complete {
            return counted(false, self.decided());
        }
        let unconfirmed = match (self.made.fits_scene, self.references) {
            (true, _) => "a smaller step does",
            (false, 1) => "more samples do",
            (false, _) => "other random numbers do",
        };
        let over = self.made.over();
        let doubt_of_this =
            format!("over {over} they differ ({contradiction}), which {unconfirmed} not confirm");
        let mut check = Self::new(self.gradient.clone(), (made, image), self.coplanar.clone());
        let between = compare(&check.reference.gradient, &self.reference.gradient);
        let agree = !matches!(between.verdict, Verdict::Wrong { .. });
        let says_nothing = check.comparison.few_events;
        match check.rest_mut() {
            Verdict::Inconclusive { doubt: Some(_), .. } if agree && !says_nothing => {
                let mut this = self;
                let is_first = this.references == 1;
                if let Verdict::Inconclusive { samples_factor, .. } = this.rest_mut()
                    && is_first
                {
                    // So many samples were just taken.
                    *samples_factor *= f64::from(SECOND_FACTOR);
                }
                counted(false, this)
            }
            Verdict::Inconclusive { doubt: Some(_), .. } if !says_nothing => counted(true, check),
            Verdict::Inconclusive { doubt, .. } => {
                *doubt = Some(doubt_of_this);
                counted(false, check)
            }
            verdict @ Verdict::Right if agree && references > 2 => {
                *verdict = Verdict::Inconclusive {
                    samples_factor: f64::from(SECOND_FACTOR),
                    doubt: Some(doubt_of_this),
                };
                counted(false, check)
            }
            Verdict::Right => counted(false, check),
            Verdict::Wrong { .. } | Verdict::Partial { .. } => counted(!agree, check),
        }
    }

    /// The verdict where no further reference is made: no gradient is called wrong by one alone, nor
    /// by some that contradict each other, which is said.
    pub(crate) fn decided(mut self) -> Self {
        if !self.is_open {
            return self;
        }
        if self.references == 1 {
            return self.unconfirmed();
        }
        let over = self.made.over();
        let (samples_factor, other) = match self.made.fits_scene {
            true => (
                f64::INFINITY,
                "one with a step four times as large: the image may jump close by, which a \
                 smaller step would show",
            ),
            false => (
                f64::from(SECOND_FACTOR),
                "another one over the same step: where few rare events were met, errors are too small",
            ),
        };
        if let Some(reason) = self.contradiction() {
            let doubt = format!(
                "over {over} they differ ({reason}), but this reference contradicts {other}"
            );
            *self.rest_mut() = Verdict::Inconclusive {
                samples_factor,
                doubt: Some(doubt),
            };
        }
        self
    }

    /// How to estimate the gradient again, if two references contradict it: with other random
    /// numbers and more samples. Where it met few rare events, its errors are too small.
    pub(crate) fn second_gradient(&self, options: &GradientOptions) -> Option<GradientOptions> {
        let is_wrong = matches!(self.rest(), Verdict::Wrong { .. });
        (is_wrong && self.references > 1).then(|| GradientOptions {
            spp: options.spp.saturating_mul(SECOND_FACTOR),
            seed: options.seed ^ SECOND_GRADIENT_SEED,
            ..*options
        })
    }

    /// What remains of a contradiction beside a second gradient: if that is not contradicted, and
    /// no doubt of it is left, the first is not called wrong.
    pub(crate) fn with_second_gradient(self, gradient: &GradientImage) -> Self {
        if !gradient.statistics.complete {
            return self.not_called_wrong(f64::from(SECOND_FACTOR), |reason| {
                format!(
                    "{reason}, and there was no time for a second gradient, which may show that \
                     the errors of the first are too small"
                )
            });
        }
        let made = (self.made, self.reference.clone());
        let again = Self::new(gradient.clone(), made, Vec::new());
        match again.contradiction() {
            Some(_) => self,
            None => self.not_confirmed(&again, "a second gradient with more samples does"),
        }
    }

    /// How to make the reference that the second gradient is compared with, if that is contradicted
    /// as well: with more samples than all before and other random numbers. The references before
    /// were looked at until they agreed, and may all have met too few rare events.
    pub(crate) fn confirmation(&self) -> Option<Reference> {
        matches!(self.rest(), Verdict::Wrong { .. }).then(|| Reference {
            spp: self.made.spp.saturating_mul(SECOND_FACTOR),
            fits_noise: false,
            seed: self.made.seed ^ CONFIRMATION_SEED,
            ..self.made
        })
    }

    /// What remains of a contradiction beside a second gradient and a reference of its own: these
    /// share no random number with all before, and must call the gradient wrong by themselves.
    pub(crate) fn with_confirmation(
        self,
        gradient: GradientImage,
        (made, image): (Reference, GradientImage),
    ) -> Self {
        let samples = self.reference_samples + image.statistics.samples;
        let counted = Self {
            references: self.references + 1,
            reference_samples: samples,
            ..self
        };
        if !image.statistics.complete {
            return counted.unconfirmed();
        }
        let again = Self::new(gradient, (made, image), Vec::new());
        match again.rest() {
            Verdict::Wrong { .. } => counted,
            _ => counted.not_confirmed(&again, "a second gradient and another reference do"),
        }
    }

    /// A doubt in the place of "wrong", which another comparison with four times the samples does not
    /// confirm; what does not is given in words.
    fn not_confirmed(self, again: &Self, without: &str) -> Self {
        let needed = match again.rest() {
            Verdict::Inconclusive { samples_factor, .. } => samples_factor.max(1.0),
            _ => 1.0,
        };
        self.not_called_wrong(needed * f64::from(SECOND_FACTOR), |reason| {
            format!(
                "{reason}, which {without} not confirm: where few rare events were met, errors are \
                 too small"
            )
        })
    }

    /// What a contradiction is without a confirmation: the reference may be at fault, or the errors
    /// of either too small.
    fn unconfirmed(self) -> Self {
        let over = self.made.over();
        self.not_called_wrong(f64::from(SECOND_FACTOR), |reason| {
            format!(
                "over {over} they differ ({reason}), and there was no time to confirm it with \
                 other random numbers"
            )
        })
    }

    /// The same with a doubt in the place of "wrong", given the reason for that.
    fn not_called_wrong(mut self, samples_factor: f64, doubt: impl FnOnce(&str) -> String) -> Self {
        let verdict = self.rest_mut();
        if let Verdict::Wrong { reason } = verdict {
            *verdict = Verdict::Inconclusive {
                samples_factor,
                doubt: Some(doubt(reason)),
            };
        }
        self
    }

    /// What speaks against the gradient.
    fn contradiction(&self) -> Option<&str> {
        match self.rest() {
            _ if self.comparison.few_events => None,
            Verdict::Wrong { reason } => Some(reason),
            Verdict::Inconclusive { doubt, .. } => doubt.as_deref(),
            Verdict::Right | Verdict::Partial { .. } => None,
        }
    }

    fn rest_mut(&mut self) -> &mut Verdict {
        match &mut self.comparison.verdict {
            Verdict::Partial { rest } => rest,
            whole => whole,
        }
    }

    /// The verdict on what is compared.
    fn rest(&self) -> &Verdict {
        match &self.comparison.verdict {
            Verdict::Partial { rest } => rest,
            whole => whole,
        }
    }

    /// What follows, in a sentence. `option` writes an option as the reader would give it:
    /// its name, `step` or `spp`, and its value if it should have one.
    pub fn verdict(&self, option: impl Fn(&str, Option<u64>) -> String) -> String {
        // Samples that were really taken: the work may have been stopped.
        let taken = |image: &GradientImage| {
            let statistics = &image.statistics;
            statistics.samples as f64 / statistics.samples_per_pixel.len() as f64
        };
        let taken = [taken(&self.gradient), taken(&self.reference)];
        let words = |verdict: &Verdict| self.words(verdict, taken, &option);
        match (&self.comparison.verdict, &self.gradient.statistics.missing) {
            (Verdict::Partial { rest }, Some(missing)) => {
                let (missing, rest) = (missing_text(missing), words(rest));
                format!(
                    "partial: {missing}.\nThe derivative of the light that arrives otherwise is {rest}"
                )
            }
            (verdict, _) => words(verdict),
        }
    }

    /// A verdict in words, of so many samples per pixel of gradient and reference.
    fn words(
        &self,
        verdict: &Verdict,
        [spp, reference_spp]: [f64; 2],
        option: impl Fn(&str, Option<u64>) -> String,
    ) -> String {
        match verdict {
            Verdict::Partial { .. } => "partial: something is left out".into(),
            Verdict::Right if self.comparison.scale_factor.is_nan() => {
                "right: both are zero everywhere: nothing in the image changes".into()
            }
            Verdict::Right => {
                "right: they agree, and a factor wrong by 10 % would have been seen".into()
            }
            Verdict::Wrong { reason } => {
                let step = option("step", None);
                format!(
                    "wrong: {reason}\n(if a smaller {step} changes this, the reference is at fault)"
                )
            }
            Verdict::Inconclusive { .. } if spp.min(reference_spp) < 2.0 => {
                "inconclusive: standard errors need at least two samples per pixel".into()
            }
            Verdict::Inconclusive {
                samples_factor,
                doubt,
            } => {
                let enough = |spp: f64| Some((spp * samples_factor).ceil() as u64);
                let needed = || {
                    format!(
                        "about {} times the samples would be enough ({} {})",
                        significant(*samples_factor, 2),
                        option("spp", enough(spp)),
                        option("reference-spp", enough(reference_spp))
                    )
                };
                let what = match (doubt, samples_factor.is_finite()) {
                    (Some(doubt), true) => format!("{doubt}; {}", needed()),
                    (Some(doubt), false) => doubt.clone(),
                    (None, true) => needed(),
                    (None, false) => "the gradient shows no derivative, only noise".into(),
                };
                format!("inconclusive: {what}")
            }
        }
    }
}

/// What is left out of a gradient, and how much of the image arrives by paths with such events.
pub fn missing_text(missing: &Missing) -> String {
    let [share, error] = [missing.share, missing.standard_error].map(|x| 100.0 * x);
    format!(
        "how silhouettes and hard shadows move that are seen in curved mirrors, through refracting \
         glass, or after many reflections is left out; {} % of the radiance arrives by paths with \
         such events, whether something moves there or not",
        plus_minus(share, error)
    )
}

/// What is to be said about shapes that lie on each other and move against each other: a line,
/// or nothing.
pub fn coplanar_text(pairs: &[[String; 2]]) -> String {
    let names = pairs.iter().take(SHOWN_PAIRS);
    let names: Vec<String> = names.map(|[a, b]| format!("\"{a}\" and \"{b}\"")).collect();
    let more = match pairs.len().saturating_sub(SHOWN_PAIRS) {
        0 => String::new(),
        n => format!(" and {n} more pairs"),
    };
    match pairs {
        [] => String::new(),
        _ => format!(
            "note: {}{more} have faces in one plane that overlap, and move against each other: \
             where that is seen the image has no derivative: one of them comes out of the plane of \
             the other, or which of them is in front is up to rounding. Move them apart a little\n",
            names.join(", ")
        ),
    }
}

/// What is to be said about faces that the camera sees edge-on and moves against: a line, or nothing.
pub fn edge_on_text(faces: &[EdgeOnFace]) -> String {
    let names = faces.iter().take(SHOWN_PAIRS);
    let names = names.map(|EdgeOnFace { shape, face }| format!("face {face} of \"{shape}\""));
    let names: Vec<String> = names.collect();
    let more = match faces.len().saturating_sub(SHOWN_PAIRS) {
        0 => String::new(),
        n => format!(" and {n} more faces"),
    };
    match faces {
        [] => String::new(),
        _ => format!(
            "note: the camera sees {}{more} exactly edge-on, and moves against that: where it is seen \
             the image has no derivative: one side of it comes into view to one side of the motion, the \
             other to the other. Move the camera a little\n",
            names.join(", ")
        ),
    }
}

/// The best factor from gradient to reference, or that none can be told.
fn scale_factor(c: &Comparison) -> String {
    match c.knows_scale_factor() {
        true => {
            let factor = plus_minus(c.scale_factor, c.scale_factor_error);
            format!("{factor} (reference / gradient)")
        }
        false => "- (the gradient is too noisy to say by which factor it is off)".into(),
    }
}

/// The numbers of a comparison, one on each line; `-` stands for what images
/// without noise, or of zeros, do not have.
pub fn comparison_text(c: &Comparison) -> String {
    let worst = c.worst.iter().take(SHOWN_PIXELS);
    let worst: Vec<String> = worst
        .map(|(x, y, z)| format!("({x}, {y}) {z:.1}"))
        .collect();
    let worst = match worst.is_empty() {
        true => "-".into(),
        false => worst.join(", "),
    };
    let if_any = |x: f64, text: String| if x.is_nan() { "-".into() } else { text };
    let mut lines = vec![
        (
            "relative L1",
            format!(
                "{} (noise alone: {})",
                number(c.relative_l1),
                number(c.relative_l1_of_noise)
            ),
        ),
        (
            "correlation",
            if_any(c.correlation, format!("{:.4}", c.correlation)),
        ),
        ("scale factor", if_any(c.scale_factor, scale_factor(c))),
        (
            "mean z²",
            format!(
                "{} over {} pixels with noise",
                if_any(
                    c.mean_z_squared,
                    plus_minus(c.mean_z_squared, c.mean_z_squared_error)
                ),
                count(c.pixels as u64)
            ),
        ),
        (
            "plain mean z²",
            format!(
                "{} (all pixels alike; off 1 where noise is rare events)",
                if_any(c.mean_z_squared_plain, number(c.mean_z_squared_plain))
            ),
        ),
        (
            "sign",
            if_any(c.sign, format!("{:+.2} standard errors", c.sign)),
        ),
        ("worst z", worst),
    ];
    if c.left_out > 0 {
        lines.push((
            "left out",
            format!("{} pixels without a standard error", c.left_out),
        ));
    }
    list(&lines)
}

#[cfg(test)]
mod tests {
    mod verdicts;

    use super::*;
    use capwalk_diff::{Estimate, Statistics};
    use capwalk_math::Rgb;
    use capwalk_scene::Image;

    const SIDE: usize = 24;

    /// Numbers that look random, of mean 0 and variance 1: sums of twelve uniform ones.
    struct Noise(u64);

    impl Noise {
        fn next(&mut self) -> f64 {
            let uniform = |_| {
                self.0 = self.0.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(1);
                (self.0 >> 11) as f64 / (1_u64 << 53) as f64
            };
            (0..12).map(uniform).sum::<f64>() - 6.0
        }
    }

    /// An image of 1, whose derivative is waves times `factor`, and `spikes` in a few pixels, with
    /// noise of this size.
    fn waves(seed: u64, factor: f64, spikes: f64, noise: f64) -> GradientImage {
        let mut random = Noise(seed);
        let flat = |value: f64| {
            let mut image = Image::new(SIDE, SIDE);
            image.pixels.fill(Rgb::splat(value));
            image
        };
        let mut mean = Image::new(SIDE, SIDE);
        for (i, pixel) in mean.pixels.iter_mut().enumerate() {
            let spike = match i % 97 {
                13 => spikes,
                _ => 0.0,
            };
            let wave = factor * (0.7 * i as f64).sin();
            *pixel = Rgb::splat(wave + spike + noise * random.next());
        }
        GradientImage {
            value: Estimate {
                mean: flat(1.0),
                standard_error: flat(0.01),
            },
            gradient: Estimate {
                mean,
                standard_error: flat(noise),
            },
            missing: None,
            statistics: Statistics {
                samples_per_pixel: vec![1000; SIDE * SIDE],
                complete: true,
                samples: 1000 * (SIDE * SIDE) as u64,
                non_finite: 0,
                cone_queries: 0,
                uncovered: 0,
                effort: 0,
                missing: None,
            },
        }
    }

    const MADE: Reference = Reference {
        spp: 1000,
        fits_noise: true,
        adaptive: true,
        seed: 5,
        step: 0.01,
        fits_scene: true,
        sides: Stencil::Both,
    };

    /// A check of the waves against a reference.
    fn checked(made: Reference, reference: &GradientImage) -> Check {
        let gradient = waves(1, 1.0, 0.0, 0.1);
        Check::new(gradient, (made, reference.clone()), Vec::new())
    }

    /// The same against a second reference after the first.
    fn checked_twice(made: Reference, first: &GradientImage, second: &GradientImage) -> Check {
        let check = checked(made, first);
        let again = check.next_reference().expect("there is a contradiction");
        check.with_next_reference((again, second.clone()))
    }

    /// A check whose second reference agrees with the gradient.
    fn twice_right() -> Check {
        checked_twice(MADE, &waves(3, 1.3, 0.0, 0.1), &waves(2, 1.0, 0.0, 0.1))
    }

    /// What contradicts a gradient, or leaves a doubt of it, gets another reference: over a
    /// smaller step, unless one was asked for, with more samples and other random numbers.
    #[test]
    fn a_contradiction_gets_another_reference() {
        let (right, wrong) = (waves(2, 1.0, 0.0, 0.1), waves(3, 1.3, 0.0, 0.1));
        assert_eq!(checked(MADE, &right).comparison.verdict, Verdict::Right);
        assert_eq!(checked(MADE, &right).next_reference(), None);
        let second = |made| {
            let second = checked(made, &wrong).next_reference();
            second.expect("there is a contradiction")
        };
        assert_eq!((second(MADE).step, second(MADE).spp), (0.0025, 4000));
        assert!(second(MADE).seed != MADE.seed && !second(MADE).fits_noise);
        let own = Reference {
            fits_scene: false,
            ..MADE
        };
        assert_eq!((second(own).step, second(own).spp), (0.01, 4000));
        assert_ne!(second(own).seed, own.seed);
        // What was cut short is no reason to begin anew.
        let mut cut = wrong.clone();
        cut.statistics.complete = false;
        assert_eq!(checked(MADE, &cut).next_reference(), None);
    }

    /// The second reference decides if it can.
    #[test]
    fn the_second_reference_decides() {
        let (right, wrong) = (waves(2, 1.0, 0.0, 0.1), waves(3, 1.3, 0.0, 0.1));
        let noisy = waves(4, 1.0, 0.0, 3.0);
        let verdict = |first: &_, second: &_| checked_twice(MADE, first, second).comparison.verdict;
        assert_eq!(verdict(&wrong, &right), Verdict::Right);
        let both = verdict(&wrong, &waves(5, 1.3, 0.0, 0.1));
        assert!(matches!(both, Verdict::Wrong { .. }));
        // What is inconclusive leaves a doubt.
        for (fits_scene, words) in [(true, "smaller step does"), (false, "more samples do")] {
            let made = Reference { fits_scene, ..MADE };
            match checked_twice(made, &wrong, &noisy).comparison.verdict {
                Verdict::Inconclusive { doubt, .. } => {
                    let doubt = doubt.expect("what was said first");
                    assert!(doubt.contains(words) && doubt.contains("0.0100"), "{doubt}");
                }
                verdict => panic!("{verdict:?}"),
            }
        }
        // Where time ran out, the first stays, but nobody is called wrong by it alone.
        let mut cut = right.clone();
        cut.statistics.complete = false;
        for check in [
            checked_twice(MADE, &wrong, &cut),
            checked(MADE, &wrong).decided(),
        ] {
            assert!(check.verdict(|_, _| String::new()).contains("no time"));
            assert_eq!(check.made.step, MADE.step);
        }
        // A second gradient with which both references agree shows that the first had too small errors.
        let both = || checked_twice(MADE, &wrong, &waves(5, 1.3, 0.0, 0.1));
        let options = GradientOptions::default();
        let again = both().second_gradient(&options).expect("it is wrong");
        assert_eq!(again.spp, 4 * options.spp);
        assert_ne!(again.seed, options.seed);
        assert!(twice_right().second_gradient(&options).is_none());
        let of = |gradient| both().with_second_gradient(&gradient).comparison.verdict;
        assert!(matches!(of(waves(8, 1.0, 0.0, 0.1)), Verdict::Wrong { .. }));
        match of(waves(8, 1.3, 0.0, 0.1)) {
            Verdict::Inconclusive { doubt, .. } => {
                let doubt = doubt.expect("what was said first");
                assert!(doubt.contains("second gradient"), "{doubt}");
            }
            verdict => panic!("{verdict:?}"),
        }
        // A second gradient and a reference of its own must call it wrong by themselves.
        let made = both().confirmation().expect("it is wrong");
        assert_eq!((made.step, made.spp), (0.0025, 16000));
        let confirmed = |gradient: GradientImage, image: &GradientImage| {
            both().with_confirmation(gradient, (made, image.clone()))
        };
        let check = confirmed(waves(8, 1.0, 0.0, 0.1), &waves(9, 1.3, 0.0, 0.1));
        assert!(matches!(check.rest(), Verdict::Wrong { .. }));
        assert_eq!((check.references, check.made.step), (3, 0.0025));
        assert_eq!(check.reference_samples, 3 * right.statistics.samples);
        for (image, words) in [
            (&right, "another reference do not confirm"),
            (&noisy, "another reference do not confirm"),
            (&cut, "no time"),
        ] {
            let check = confirmed(waves(8, 1.0, 0.0, 0.1), image);
            let text = check.verdict(|_, _| String::new());
            assert!(
                text.starts_with("inconclusive") && text.contains(words),
                "{text}"
            );
            assert!(check.confirmation().is_none());
        }
        // Both are counted.
        let twice = checked_twice(MADE, &wrong, &right);
        assert_eq!((twice.references, twice.made.step), (2, 0.0025));
        assert_eq!(twice.reference_samples, 2 * right.statistics.samples);
        // Two doubts take more samples than the second reference had.
        let doubtful = [6, 7].map(|seed| waves(seed, 1.0, 0.8, 0.1));
        let factor = |check: Check| match check.comparison.verdict {
            Verdict::Inconclusive {
                samples_factor,
                doubt: Some(_),
            } => samples_factor,
            verdict => panic!("{verdict:?}"),
        };
        let once = factor(checked(MADE, &doubtful[0]));
        let both = checked_twice(MADE, &doubtful[0], &doubtful[1]);
        assert_eq!(factor(both), 4.0 * once);
        // A doubt that the second reference does not share is none.
        let doubtful = waves(6, 1.0, 0.8, 0.1);
        let first = checked(MADE, &doubtful).comparison.verdict;
        assert!(
            matches!(first, Verdict::Inconclusive { doubt: Some(_), .. }),
            "{first:?}"
        );
        assert_eq!(verdict(&doubtful, &right), Verdict::Right);
    }

    /// Where references contradict each other, none of them calls a gradient wrong: others are made,
    /// as long as each contradicts the gradient and the one before.
    #[test]
    fn references_that_contradict_each_other_call_nothing_wrong() {
        let [right, first, second] =
            [(2, 1.0), (3, 1.3), (5, 1.6)].map(|(seed, factor)| waves(seed, factor, 0.0, 0.1));
        let apart = || checked_twice(MADE, &first, &second);
        assert!(matches!(apart().rest(), Verdict::Wrong { .. }));
        let third = apart().next_reference().expect("they do not agree");
        assert_eq!((third.step, third.spp), (MADE.step / 16.0, 4000));
        let with = |check: Check, next: &GradientImage| {
            let made = check.next_reference().expect("it is open");
            check.with_next_reference((made, next.clone()))
        };
        let doubt_of = |check: &Check| match check.rest() {
            Verdict::Inconclusive {
                doubt: Some(doubt), ..
            } => doubt.clone(),
            verdict => panic!("{verdict:?}"),
        };
        // The third one decides, if it contradicts the second.
        let decided = with(apart(), &right);
        assert_eq!(*decided.rest(), Verdict::Right);
        assert_eq!((decided.references, decided.made.step), (3, third.step));
        let of_all = 3 * right.statistics.samples;
        assert_eq!(decided.reference_samples, of_all);
        let confirmed = with(apart(), &waves(6, 1.6, 0.0, 0.1));
        assert!(confirmed.next_reference().is_none());
        assert!(matches!(confirmed.decided().rest(), Verdict::Wrong { .. }));
        // Noise alone does not acquit: the same few pixels are off in the second and the third.
        let spikes = |seed, spikes, noise| waves(seed, 1.0, spikes, noise);
        let few = checked_twice(MADE, &spikes(3, 3.0, 0.1), &spikes(5, 1.3, 0.1));
        assert!(matches!(few.rest(), Verdict::Wrong { .. }));
        let hidden = with(few, &spikes(6, 0.9, 0.2));
        let alone = checked(MADE, &spikes(6, 0.9, 0.2));
        assert_eq!(*alone.rest(), Verdict::Right);
        assert!(doubt_of(&hidden).contains("0.00250"));
        assert!(hidden.next_reference().is_none());
        // Nor does it accuse: what a noisy one leaves is the doubt of the one before.
        let noisy = waves(7, 1.0, 0.0, 3.0);
        let doubtful = with(apart(), &noisy);
        assert!(doubt_of(&doubtful).contains("0.00250") && doubtful.next_reference().is_none());
        // So it does where one says that, and the other leaves a doubt that does not agree.
        let unlike = [waves(3, 1.3, 0.0, 0.1), waves(6, 1.0, 0.8, 0.1)];
        let check = checked_twice(MADE, &unlike[0], &unlike[1]);
        assert!(doubt_of(&check).contains("mean z²") && check.is_open);
        let words = check.decided().verdict(|_, _| String::new());
        assert!(words.contains("contradicts one with") && !words.contains("times the samples"));
        // A third one with the doubt of the second leaves the second's verdict; the samples that
        // were taken are not taken again.
        let few = || checked_twice(MADE, &spikes(3, 3.0, 0.1), &spikes(5, 1.3, 0.1));
        let shared = with(few(), &spikes(6, 0.8, 0.1));
        assert!(matches!(shared.rest(), Verdict::Wrong { .. }) && !shared.is_open);
        assert_eq!((shared.references, shared.made.step), (3, MADE.step / 4.0));
        let doubtful = checked_twice(MADE, &waves(3, 4.0, 0.0, 0.1), &waves(4, 1.0, 0.0, 1.0));
        assert!(doubt_of(&doubtful).contains("0.0100") && doubtful.next_reference().is_none());
        // They end, with random numbers of their own, and nothing is wrong then.
        let mut check = checked(MADE, &first);
        let mut seeds = vec![check.made.seed];
        for next in [&second, &first, &second] {
            check = with(check, next);
            seeds.push(check.made.seed);
        }
        seeds.sort_unstable();
        seeds.dedup();
        assert_eq!((seeds.len(), check.references), (4, 4));
        assert!(check.next_reference().is_none());
        let words = check.decided().verdict(|_, _| String::new());
        let says = |text: &str| words.contains(text);
        assert!(words.starts_with("inconclusive") && says("jump") && !says("times the samples"));
        // So it is where time runs out between them, and with a step that was asked for.
        let mut cut = right.clone();
        cut.statistics.complete = false;
        let check = with(apart(), &cut);
        assert!(doubt_of(&check).contains("contradicts one with") && !check.is_open);
        let own = Reference {
            fits_scene: false,
            ..MADE
        };
        let apart = checked_twice(own, &first, &second);
        assert_eq!(apart.next_reference().map(|next| next.step), Some(own.step));
        let words = apart.decided().verdict(|_, _| String::new());
        assert!(
            words.contains("rare events") && words.contains("times the samples"),
            "{words}"
        );
    }

    /// A reference that saw too few events is no evidence, neither as the first nor as the second.
    #[test]
    fn too_few_events_are_no_evidence() {
        let (wrong, mut blind) = (waves(3, 1.3, 0.0, 0.1), waves(4, 0.0, 0.0, 0.0));
        let statistics = &mut blind.statistics;
        statistics.samples_per_pixel.fill(2);
        statistics.samples = 2 * (SIDE * SIDE) as u64;
        let short = Reference { step: 1e-5, ..MADE };
        let check = checked(short, &blind);
        assert!(check.comparison.few_events && check.next_reference().is_none());
        let first = checked(MADE, &wrong);
        match first.with_next_reference((short, blind)).comparison.verdict {
            Verdict::Inconclusive { doubt, .. } => {
                let doubt = doubt.expect("what was said first");
                assert!(doubt.contains("does not confirm"), "{doubt}");
            }
            verdict => panic!("{verdict:?}"),
        }
    }

    /// The sides of a step are named.
    #[test]
    fn one_sided_differences_are_described() {
        let sides = |sides| Reference { sides, ..MADE }.describe();
        assert!(sides(Stencil::Below).contains("over - 0.0100: on the other side"));
        assert!(sides(Stencil::Above).contains("over + 0.0100"));
        assert_eq!(sides(Stencil::Both), "central differences over ± 0.0100");
    }

    /// A few faces are named, the others counted.
    #[test]
    fn faces_that_are_seen_edge_on_are_named() {
        let faces: Vec<EdgeOnFace> = (0..7)
            .map(|face| EdgeOnFace {
                shape: "card".into(),
                face,
            })
            .collect();
        assert_eq!(edge_on_text(&[]), "");
        let text = edge_on_text(&faces[..1]);
        let starts = "note: the camera sees face 0 of \"card\" exactly";
        assert!(text.starts_with(starts) && text.ends_with('\n'), "{text}");
        let text = edge_on_text(&faces);
        assert!(
            text.contains("face 4 of \"card\" and 2 more faces"),
            "{text}"
        );
    }

    /// A few pairs are named, the others counted.
    #[test]
    fn shapes_that_lie_on_each_other_are_named() {
        let pairs: Vec<[String; 2]> = (0..7)
            .map(|i| ["floor".into(), format!("box{i}")])
            .collect();
        assert_eq!(coplanar_text(&[]), "");
        let text = coplanar_text(&pairs[..1]);
        assert!(
            text.starts_with("note: \"floor\" and \"box0\" have faces"),
            "{text}"
        );
        let text = coplanar_text(&pairs);
        assert!(text.contains("box4\" and 2 more pairs"), "{text}");
        assert!(!text.contains("box5") && text.ends_with('\n'), "{text}");
    }
}
