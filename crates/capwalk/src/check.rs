//! A gradient against finite differences.

#[cfg(test)]
mod tests;
mod words;

use std::cmp::Ordering;

use capwalk_diff::GradientImage;
use capwalk_diff::check::{
    Comparison, Verdict, compare, compare_with_differences, without_rounding,
};
use capwalk_diff::{GradientOptions, Stencil};
use capwalk_scene::{Scene, Tangent};

use crate::direction;
use crate::edge_on::EdgeOnFace;
use crate::error::Error;
use crate::options::{self, DifferenceOptions, check_spp};
use crate::text::number;

pub use words::{comparison_text, coplanar_text, edge_on_text, touching_text};

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
    /// True if as many are taken instead as suit the noise.
    pub fits_noise: bool,
    /// True if pixels get more or fewer of them by how noisy they are.
    pub adaptive: bool,
    /// Seed of its random numbers.
    pub seed: u64,
    /// How far the parameter moves on each side, in its own units.
    pub step: f64,
    /// True if no step was asked for, and this is the one that fits the scene.
    pub fits_scene: bool,
    /// True if it moves to both sides.
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

    /// That of the next reference: a smaller one, unless a step was asked for.
    fn smaller_step(&self) -> f64 {
        match self.fits_scene {
            true => self.step / f64::from(SECOND_FACTOR),
            false => self.step,
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
    /// it, up to 4 if they contradicted each other as well; one or two more if all of them and a
    /// second gradient called it wrong. This is the one that decided.
    pub references: u32,
    /// Samples of all of them.
    pub reference_samples: u64,
    /// Shapes that lie on each other and move against each other, see
    /// [`Prepared::coplanar_shapes`](crate::Prepared::coplanar_shapes).
    pub coplanar: Vec<[String; 2]>,
    /// Shapes that lie with an edge on others and move off them, but for pairs of
    /// [`Check::coplanar`], see [`Prepared::touching_shapes`](crate::Prepared::touching_shapes).
    pub touching: Vec<[String; 2]>,
    /// Faces that the camera sees edge-on and moves against, see
    /// [`Prepared::edge_on_faces`](crate::Prepared::edge_on_faces).
    pub edge_on: Vec<EdgeOnFace>,
    /// True as long as no other reference agrees with this one: if this one speaks against the
    /// gradient, others may change the verdict.
    is_open: bool,
}

impl Check {
    /// Compares a gradient with differences of the same size, and how they were made.
    pub fn new(
        gradient: GradientImage,
        (made, mut reference): (Reference, GradientImage),
        coplanar: Vec<[String; 2]>,
    ) -> Self {
        reference.gradient = without_rounding(&reference, made.step);
        let comparison = compare_with_differences(&gradient, &reference, made.span());
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
            touching: Vec::new(),
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
            let Reference { spp, .. } = self.made;
            Reference {
                spp: match self.references {
                    1 => spp.saturating_mul(SECOND_FACTOR),
                    _ => spp,
                },
                fits_noise: false,
                seed: self.made.seed ^ NEXT_SEED.rotate_left(self.references - 1),
                step: self.made.smaller_step(),
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
        match &mut check.comparison.verdict {
            Verdict::Inconclusive { doubt: Some(_), .. } if agree && !says_nothing => {
                let mut this = self;
                let is_first = this.references == 1;
                if let Verdict::Inconclusive { samples_factor, .. } = &mut this.comparison.verdict
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
            Verdict::Wrong { .. } => counted(!agree, check),
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
                "one with a step four times as large: the image may be discontinuous close by, which a \
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
            self.comparison.verdict = Verdict::Inconclusive {
                samples_factor,
                doubt: Some(doubt),
            };
        }
        self
    }

    /// How to estimate the gradient again, if two references contradict it: with other random
    /// numbers and more samples. Where it met few rare events, its errors are too small.
    pub(crate) fn second_gradient(&self, options: &GradientOptions) -> Option<GradientOptions> {
        let is_wrong = matches!(&self.comparison.verdict, Verdict::Wrong { .. });
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

    /// How to make the references that the second gradient is compared with, if that is contradicted
    /// as well: with more samples than all before and other random numbers. The references before
    /// were looked at until they agreed. Edges may lie closer to the borders of pixels than the steps
    /// of all of them, which a smaller step shows. Or all met too few rare events: where steps get
    /// smaller as samples get more, no one of them meets more than the others. A larger step does.
    pub(crate) fn confirmations(&self) -> Vec<Reference> {
        let Reference { step, .. } = self.made;
        let steps = match (&self.comparison.verdict, self.made.fits_scene) {
            (Verdict::Wrong { .. }, true) => {
                vec![self.made.smaller_step(), step * f64::from(SECOND_FACTOR)]
            }
            (Verdict::Wrong { .. }, false) => vec![step],
            _ => Vec::new(),
        };
        let seed = self.made.seed ^ CONFIRMATION_SEED;
        let of_step = |(i, step)| Reference {
            spp: self.made.spp.saturating_mul(SECOND_FACTOR),
            fits_noise: false,
            seed: seed.rotate_left(i),
            step,
            ..self.made
        };
        (0..).zip(steps).map(of_step).collect()
    }

    /// What remains of a contradiction beside a second gradient and a reference of its own: these
    /// share no random number with all before, and must call the gradient wrong by themselves.
    pub(crate) fn with_confirmation(
        self,
        gradient: &GradientImage,
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
        let again = Self::new(gradient.clone(), (made, image), Vec::new());
        match &again.comparison.verdict {
            Verdict::Wrong { .. } => counted,
            _ => {
                let step = match again.made.step.total_cmp(&counted.made.step) {
                    Ordering::Less => " over a smaller step",
                    Ordering::Equal => "",
                    Ordering::Greater => " over a larger step",
                };
                let without = format!("a second gradient and another reference{step} do");
                counted.not_confirmed(&again, &without)
            }
        }
    }

    /// A doubt in the place of "wrong", which another comparison with four times the samples does not
    /// confirm; what does not is given in words.
    fn not_confirmed(self, again: &Self, without: &str) -> Self {
        let needed = match &again.comparison.verdict {
            Verdict::Inconclusive { samples_factor, .. } => samples_factor.max(1.0),
            _ => 1.0,
        };
        let edges = match again.made.step < self.made.step {
            true => ", and where an edge lies on the border of a pixel, steps are too large",
            false => "",
        };
        self.not_called_wrong(needed * f64::from(SECOND_FACTOR), |reason| {
            format!(
                "{reason}, which {without} not confirm: where few rare events were met, errors are \
                 too small{edges}"
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

    /// This check with a doubt in the place of "wrong", given the reason for that.
    fn not_called_wrong(mut self, samples_factor: f64, doubt: impl FnOnce(&str) -> String) -> Self {
        let verdict = &mut self.comparison.verdict;
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
        match &self.comparison.verdict {
            _ if self.comparison.few_events => None,
            Verdict::Wrong { reason } => Some(reason),
            Verdict::Inconclusive { doubt, .. } => doubt.as_deref(),
            Verdict::Right => None,
        }
    }
}
