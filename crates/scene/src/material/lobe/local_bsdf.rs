//! Several lobes at once: the BSDF at a point.

use capwalk_math::{Real, Rgb, Vec3};

use super::event::{Drawn, Event, Side, Specular};
use super::list::Lobe;
use super::rough_surface::RoughSurface;
use super::tilt::Tilt;

/// Up to [`LocalBsdf::MAX_LOBES`] lobes with weights: what a surface does to light
/// at a point.
///
/// Sampling chooses a lobe in proportion to the values of the weights (negative
/// ones count as zero), and a density is that of the whole choice. With
/// [`LocalBsdf::explored`], lobes are chosen even at weight zero.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalBsdf<R: Real = f64> {
    lobes: [Option<(R, Lobe<R>)>; 4],
    /// Lobes that have normals of their own.
    tilts: [Option<Box<Tilt<R>>>; 4],
    /// Lobes that are chosen with [`LEAST_CHANCE`] at least.
    is_explored: [bool; 4],
    side: Option<Side>,
}

/// Smallest chance of a lobe whose weight may have a derivative, which is there
/// even where the weight is zero.
const LEAST_CHANCE: f64 = 0.1;

/// A direction drawn by a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BsdfSample {
    /// The direction to continue in.
    pub wo: Vec3,
    /// Its density per solid angle, [`LocalBsdf::pdf`]; for a specular event its
    /// probability. Positive.
    pub pdf: f64,
    /// `None` if `wo` comes from a density. Otherwise the throughput is that of
    /// [`LocalBsdf::specular`] over `pdf`.
    pub specular: Option<Specular>,
}

/// A direction drawn by a surface, without its density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BsdfDirection {
    /// The direction to continue in.
    pub wo: Vec3,
    /// The specular event and its probability; `None` if the direction comes from a density.
    pub specular: Option<(Specular, f64)>,
}

impl<R: Real> Default for LocalBsdf<R> {
    /// A black surface: no lobes, to be seen from both sides.
    #[inline]
    fn default() -> Self {
        Self {
            lobes: [const { None }; 4],
            tilts: [const { None }; 4],
            is_explored: [false; 4],
            side: None,
        }
    }
}

impl<R: Real> From<Lobe<R>> for LocalBsdf<R> {
    /// One lobe of weight one.
    fn from(lobe: Lobe<R>) -> Self {
        let mut bsdf = Self::default();
        bsdf.push(R::constant(1.0), lobe);
        bsdf
    }
}

impl<R: Real> LocalBsdf<R> {
    /// How many lobes there is place for.
    pub const MAX_LOBES: usize = 4;

    /// Removes all lobes; writes less than a new one would.
    pub fn clear(&mut self) {
        self.lobes.iter_mut().for_each(|lobe| *lobe = None);
        self.tilts.iter_mut().for_each(|tilt| *tilt = None);
        (self.is_explored, self.side) = ([false; 4], None);
    }

    /// Adds a lobe.
    ///
    /// # Panics
    ///
    /// If there is no place; refuse such materials when reading them.
    pub fn push(&mut self, weight: R, lobe: Lobe<R>) {
        self.push_tilted(weight, lobe, None);
    }

    /// Adds a lobe that may have a normal of its own.
    ///
    /// # Panics
    ///
    /// If there is no place; refuse such materials when reading them.
    #[inline]
    pub fn push_tilted(&mut self, weight: R, lobe: Lobe<R>, tilt: Option<Tilt<R>>) {
        let place = self.lobes.iter().position(Option::is_none);
        let place = place.expect("materials of more lobes are refused when read");
        self.lobes[place] = Some((weight, lobe));
        self.tilts[place] = tilt.map(Box::new);
    }

    /// The same surface, all lobes about the shading normal.
    #[must_use]
    pub fn levelled(mut self) -> Self {
        self.tilts = [const { None }; 4];
        self
    }

    /// True if some lobe has a normal of its own.
    pub fn is_tilted(&self) -> bool {
        self.tilts().any(|tilt| tilt.is_some())
    }

    /// The tilts of the lobes, in the order of [`LocalBsdf::lobes`].
    fn tilts(&self) -> impl Iterator<Item = Option<&Tilt<R>>> {
        self.tilts.iter().map(Option::as_deref)
    }

    /// The lobes and their weights, in the order in which they were added.
    pub fn lobes(&self) -> impl Iterator<Item = &(R, Lobe<R>)> {
        self.lobes.iter().flatten()
    }

    /// The same surface, of which the face shows the given side, whatever the
    /// sign of `wi.z`: for directions that an interpolated normal puts on the
    /// other side, lobes answer for the mirrored direction. On the back,
    /// one-sided lobes are black.
    ///
    /// Without it, two-sided lobes take the side from the sign of `wi.z`, and
    /// one-sided ones count as seen from the front.
    #[must_use]
    pub fn seen_from(mut self, side: Side) -> Self {
        self.see_from(side);
        self
    }

    /// [`LocalBsdf::seen_from`] in place.
    #[inline]
    pub fn see_from(&mut self, side: Side) {
        self.side = Some(side);
    }

    /// `wi` in a lobe's frame, on the side that is seen; `None` if the lobe shows
    /// nothing there.
    #[inline]
    fn seen(&self, wi: Vec3<R>, tilt: Option<&Tilt<R>>) -> Option<Vec3<R>> {
        let Some(tilt) = tilt else {
            return Some(match self.side {
                None => wi,
                Some(side) => side.put(wi),
            });
        };
        let side = self.side.unwrap_or(match wi.z.value() < 0.0 {
            true => Side::Back,
            false => Side::Front,
        });
        let wi = side.put(wi);
        (!tilt.is_turned_away(wi)).then(|| side.put(tilt.turned(wi)))
    }

    /// True if the lobe shows something to the side that is seen.
    #[inline]
    fn shows(&self, lobe: &Lobe<R>) -> bool {
        self.side != Some(Side::Back) || lobe.is_two_sided()
    }

    /// The lobes and the weights with which they are chosen, up to a common
    /// factor.
    #[inline]
    fn chances(&self) -> impl Iterator<Item = (f64, &Lobe<R>)> {
        let lobes = self.lobes().zip(self.is_explored);
        lobes.map(|((weight, lobe), is_explored)| {
            let least = if is_explored { LEAST_CHANCE } else { 0.0 };
            let chance = weight.value().max(least);
            (if self.shows(lobe) { chance } else { 0.0 }, lobe)
        })
    }

    /// `f(wi, wo) |cos wo|` of everything but perfectly specular parts.
    // Not inlined: among the rest of a path all lobes would be evaluated and one selected.
    #[inline(never)]
    pub fn eval(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        if let Some((weight, lobe)) = self.only_lobe() {
            let wi = self.side.map_or(wi, |side| side.put(wi));
            return lobe.eval(wi, wo) * *weight;
        }
        self.eval_all(wi, wo)
    }

    /// The lobe, if it is the only one, is about the shading normal, and shows something to the
    /// side that is seen.
    #[inline]
    fn only_lobe(&self) -> Option<&(R, Lobe<R>)> {
        let [first @ Some((_, lobe)), None, None, None] = &self.lobes else {
            return None;
        };
        let is_level = self.tilts[0].is_none() && self.shows(lobe);
        first.as_ref().filter(|_| is_level)
    }

    /// [`LocalBsdf::eval`] of any lobes.
    fn eval_all(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        let parts = self.lobes().zip(self.tilts());
        let parts = parts.filter(|((_, lobe), _)| self.shows(lobe));
        parts.fold(Rgb::zero(), |sum, ((weight, lobe), tilt)| {
            let Some(wi) = self.seen(wi, tilt) else {
                return sum;
            };
            sum + match tilt {
                None => lobe.eval(wi, wo) * *weight,
                Some(tilt) => lobe.eval(wi, tilt.turned(wo)) * (*weight * tilt.shown(wo)),
            }
        })
    }

    /// True if part of what it reflects is reflected by facets ([`LocalBsdf::mirrored`]).
    pub fn has_facets(&self) -> bool {
        self.lobes().any(|(_, lobe)| lobe.has_facets())
    }

    /// Calls `visit` with each part of [`LocalBsdf::eval`] that facets reflect as mirrors, and the product of
    /// their roughnesses.
    pub fn mirrored(&self, wi: Vec3<R>, wo: Vec3<R>, visit: &mut impl FnMut(Rgb<R>, R)) {
        let parts = self.lobes().zip(self.tilts());
        for ((weight, lobe), tilt) in parts.filter(|((_, lobe), _)| self.shows(lobe)) {
            let Some(wi) = self.seen(wi, tilt) else {
                continue;
            };
            let (wo, weight) = match tilt {
                None => (wo, *weight),
                Some(tilt) => (tilt.turned(wo), *weight * tilt.shown(wo)),
            };
            lobe.mirrored(wi, wo, &mut |part, alpha2| visit(part * weight, alpha2));
        }
    }

    /// Where a perfectly specular event sends `wi`, and how much radiance
    /// comes back from there: `weight · Fresnel · tint · scaling of radiance`,
    /// as smooth functions.
    ///
    /// # Panics
    ///
    /// If the surface has no such event; [`LocalBsdf::sample`] never returns one.
    pub fn specular(&self, event: Specular, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        let (weight, lobe) = self.lobes[event.lobe]
            .as_ref()
            .expect("events come from lobes that are there");
        let tilt = self.tilts[event.lobe].as_deref();
        let seen = self.seen(wi, tilt);
        let seen = seen.expect("events come from lobes that are seen");
        let (own, throughput) = lobe.specular(event, seen);
        let wo = match (event.event, tilt) {
            // Straight on, whatever the normals.
            (Event::Pass, _) => -wi,
            (_, Some(tilt)) => tilt.turned_back(own),
            (_, None) => own,
        };
        let shown = tilt.map_or(R::constant(1.0), |tilt| tilt.shown(wo));
        (wo, throughput * (*weight * shown))
    }

    /// The perfectly specular events that `wi` can take part in, black ones among them: each can
    /// be given to [`LocalBsdf::specular`].
    pub fn events(&self, wi: Vec3<R>) -> impl Iterator<Item = Specular> {
        let lobes = self.lobes().zip(self.tilts()).enumerate();
        let shown = lobes.filter(move |(_, ((_, lobe), tilt))| {
            self.shows(lobe) && self.seen(wi, *tilt).is_some()
        });
        shown.flat_map(|(place, ((_, lobe), _))| {
            let events = lobe.events().iter();
            events.map(move |&event| Specular { lobe: place, event })
        })
    }

    /// The surface with `f` of each weight and number, in order.
    pub fn map<S: Real>(&self, f: &mut impl FnMut(R) -> S) -> LocalBsdf<S> {
        let mut mapped = LocalBsdf {
            side: self.side,
            is_explored: self.is_explored,
            ..LocalBsdf::default()
        };
        for ((weight, lobe), tilt) in self.lobes().zip(self.tilts()) {
            let weight = f(*weight);
            let lobe = lobe.map(f);
            mapped.push_tilted(weight, lobe, tilt.map(|tilt| tilt.map(f)));
        }
        mapped
    }

    /// The primal BSDF: without derivatives.
    pub fn value(&self) -> LocalBsdf {
        self.map(&mut R::value)
    }

    /// The same surface, of which every lobe is drawn, also those of weight zero:
    /// their weights may have derivatives.
    #[must_use]
    pub fn explored(mut self) -> Self {
        self.explore();
        self
    }

    /// [`LocalBsdf::explored`] in place.
    #[inline]
    pub fn explore(&mut self) {
        self.is_explored = [true; 4];
    }

    /// True if light can come from both sides.
    pub fn transmits(&self) -> bool {
        self.lobes().any(|(_, lobe)| lobe.is_two_sided())
    }

    /// True if all lobes are diffuse.
    pub fn is_diffuse(&self) -> bool {
        self.lobes()
            .all(|(_, lobe)| matches!(lobe, Lobe::Diffuse(_)))
    }

    /// True if it can be drawn anything that is not perfectly specular: worth
    /// sampling emitters.
    pub fn has_smooth(&self) -> bool {
        self.chances()
            .any(|(chance, lobe)| chance > 0.0 && lobe.has_smooth())
    }
}

impl LocalBsdf {
    /// Sum of the weights that are chosen by.
    #[inline]
    fn total_chance(&self) -> f64 {
        self.chances().map(|(chance, _)| chance).sum()
    }

    /// Density per solid angle of the smooth directions that [`LocalBsdf::sample`]
    /// draws, including the probability that it draws one.
    #[inline(never)]
    pub fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        match self.only_lobe() {
            Some((weight, lobe)) if *weight > 0.0 => {
                lobe.pdf(self.side.map_or(wi, |side| side.put(wi)), wo)
            }
            _ => self.pdf_of_all(wi, wo),
        }
    }

    /// [`LocalBsdf::eval`] and [`LocalBsdf::pdf`].
    #[inline(never)]
    pub fn eval_and_pdf(&self, wi: Vec3, wo: Vec3) -> (Rgb, f64) {
        match self.only_lobe() {
            Some((weight, lobe)) if *weight > 0.0 => {
                let wi = self.side.map_or(wi, |side| side.put(wi));
                let (f, pdf) = lobe.eval_and_pdf(wi, wo);
                (f * *weight, pdf)
            }
            _ => (self.eval_all(wi, wo), self.pdf_of_all(wi, wo)),
        }
    }

    /// The only lobe as plain numbers; `None` if there are others, or if it is neither a rough metal nor
    /// a rough plastic.
    pub fn rough_surface(&self) -> Option<RoughSurface> {
        let (weight, lobe) = self.only_lobe().filter(|(weight, _)| *weight > 0.0)?;
        lobe.rough_surface(*weight)
    }

    /// [`LocalBsdf::pdf`] of any lobes.
    fn pdf_of_all(&self, wi: Vec3, wo: Vec3) -> f64 {
        let total = self.total_chance();
        if total <= 0.0 {
            return 0.0;
        }
        let parts = self.chances().zip(self.tilts());
        let sum: f64 = parts
            .filter(|((chance, _), _)| *chance > 0.0)
            .map(|((chance, lobe), tilt)| {
                let Some(wi) = self.seen(wi, tilt) else {
                    return 0.0;
                };
                chance
                    * match tilt {
                        None => lobe.pdf(wi, wo),
                        Some(tilt) if tilt.is_on_one_side(wo) => lobe.pdf(wi, tilt.turned(wo)),
                        Some(_) => 0.0,
                    }
            })
            .sum();
        sum / total
    }

    /// Draws a direction or a specular event; `None` if the path ends.
    /// `u_choice` and `u` are uniform in `[0, 1)`.
    pub fn sample(&self, wi: Vec3, u_choice: f64, u: [f64; 2]) -> Option<BsdfSample> {
        let BsdfDirection { wo, specular } = self.draw(wi, u_choice, u)?;
        let Some((event, probability)) = specular else {
            let pdf = self.pdf(wi, wo);
            return (pdf > 0.0).then_some(BsdfSample {
                wo,
                pdf,
                specular: None,
            });
        };
        Some(BsdfSample {
            wo,
            pdf: probability,
            specular: Some(event),
        })
    }

    /// [`LocalBsdf::sample`] without the density, which may be zero: then the path ends.
    #[inline]
    pub fn draw(&self, wi: Vec3, u_choice: f64, u: [f64; 2]) -> Option<BsdfDirection> {
        // The lobe; what is left of the random number chooses within it.
        let total = self.total_chance();
        let mut left = u_choice * total;
        let mut chosen = None;
        for (place, (chance, lobe)) in self.chances().enumerate() {
            if chance <= 0.0 {
                continue;
            }
            // The last one takes what rounding leaves over.
            chosen = Some((place, lobe, chance, (left / chance).min(1.0 - f64::EPSILON)));
            if left < chance {
                break;
            }
            left -= chance;
        }
        let (place, lobe, chance, choice) = chosen?;
        let tilt = self.tilts[place].as_deref();
        let is_shown = |wo| tilt.is_none_or(|tilt| tilt.is_on_one_side(wo));
        match lobe.sample(self.seen(wi, tilt)?, choice, u)? {
            Drawn::Smooth(wo) => {
                let wo = tilt.map_or(wo, |tilt| tilt.turned_back(wo));
                is_shown(wo).then_some(BsdfDirection { wo, specular: None })
            }
            Drawn::Specular(event, probability) => {
                let specular = Specular { lobe: place, event };
                let wo = self.specular(specular, wi).0;
                is_shown(wo).then_some(BsdfDirection {
                    wo,
                    specular: Some((specular, probability * chance / total)),
                })
            }
        }
    }
}
