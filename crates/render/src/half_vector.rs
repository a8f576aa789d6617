//! How sampled directions move that follow no boundary (METHOD 8): they turn with the shading normal, and
//! what facets reflect follows its half vector, which stays in the shading frame.

use capwalk_math::{Dual, Frame, Real, Rgb, Vec3};
use capwalk_scene::lobe::LocalBsdf;

use crate::scene_eval::Warped;
use crate::vertex::Vertex;

/// How fast the share of the half vector falls with roughness and towards grazing angles: about where the
/// derivative of its Jacobian is as noisy as that of a lobe which turns with the normal.
const ROUGHNESS_COUNTS: f64 = 2.0;

/// What the directions sampled at a vertex follow: a field on their sphere, without boundaries.
#[derive(Clone, Copy, Debug)]
pub struct Following<'v, R: Real> {
    /// The shading normal.
    normal: Vec3<R>,
    /// True if what no facets reflect turns with it; or else that stays.
    rest_turns: bool,
    /// If facets reflect a part, and nothing is transmitted.
    facets: Option<Facets<'v, R>>,
}

/// The facets of a vertex.
#[derive(Clone, Copy, Debug)]
struct Facets<'v, R: Real> {
    /// All of its BSDF.
    bsdf: &'v LocalBsdf<R>,
    frame: Frame,
    /// Unit direction to the viewer in the frame.
    wi: Vec3,
    /// The same in the world.
    viewer: Vec3<R>,
    /// One over the square of how wide the light is that they reflect, radians: in light that is narrower than
    /// the lobe, directions that stay are less noisy.
    narrowness: f64,
}

impl<'v, R: Real> Following<'v, R> {
    /// What directions from a vertex to light from all around it follow: the normal, or the half vector.
    pub fn of(vertex: &'v Vertex<R>) -> Self {
        Self {
            facets: Facets::of(vertex, 0.0),
            ..Self::normal_of(vertex)
        }
    }

    /// Likewise the normal alone.
    pub fn normal_of(vertex: &Vertex<R>) -> Self {
        Self {
            normal: vertex.frame.n,
            rest_turns: true,
            facets: None,
        }
    }

    /// What directions to light follow that has the angular radius whose squared tangent this is; `None` if all
    /// stay.
    pub fn of_facets(vertex: &'v Vertex<R>, tan2: f64) -> Option<Self> {
        let facets = Facets::of(vertex, 1.0 / tan2);
        facets.is_some().then_some(Self {
            normal: vertex.frame.n,
            rest_turns: false,
            facets,
        })
    }

    /// The same at an image of the vertex, which has this frame; `image` is that of a moving direction.
    pub fn seen(self, frame: Frame, image: impl Fn(Vec3<R>) -> Vec3<R>) -> Self {
        Self {
            normal: image(self.normal),
            rest_turns: self.rest_turns,
            facets: self.facets.map(|facets| Facets {
                frame,
                viewer: image(facets.viewer),
                ..facets
            }),
        }
    }

    /// The shading normal and, if facets count, the direction to the viewer.
    pub fn axes(&self) -> (Vec3<R>, Option<Vec3<R>>) {
        (self.normal, self.facets.map(|facets| facets.viewer))
    }

    /// The facets, where the normal or the viewer moves: else the half vector stays, as all directions do.
    fn moving_facets(&self) -> Option<&Facets<'v, R>> {
        let facets = self.facets.as_ref();
        facets.filter(|facets| !self.normal.is_constant() || !facets.viewer.is_constant())
    }

    /// A unit direction that moves along the field, and the field's divergence.
    pub fn warped(&self, q: Vec3) -> Warped<R> {
        let Some(facets) = self.moving_facets() else {
            return Warped::turning(q, self.normal);
        };
        let [x, y, z] = facets.frame.to_local(q).to_array();
        let [x, y, z] = [(x, 0), (y, 1), (z, 2)].map(|(x, i)| Dual::<3>::variable(x, i));
        let share = facets.share(Vec3::new(x, y, z));
        let slope = facets.frame.to_world(Vec3::from(share.tangent));
        let Parts {
            rest,
            own,
            divergence,
        } = self.parts(facets, q);
        // div (k s) = k div s + s·∇k
        let share = R::constant(share.value);
        let growth = divergence * share + own.dot(Vec3::constant(slope));
        Warped {
            direction: rest + own * share,
            jacobian: R::constant(1.0) + growth,
            ..Warped::still(q)
        }
    }

    /// The direction of [`Self::warped`] alone.
    pub fn direction(&self, q: Vec3) -> Vec3<R> {
        let Some(facets) = self.moving_facets() else {
            return Warped::turning(q, self.normal).direction;
        };
        let share = facets.share(facets.frame.to_local(q));
        let Parts { rest, own, .. } = self.parts(facets, q);
        rest + own * R::constant(share)
    }

    /// The field without facets, and what it lacks where the half vector stays in the turning frame. With `v`
    /// the direction to the viewer, which has the velocity `w` in that frame, the direction has
    ///
    /// ```text
    /// s = φ (q + v) - w ,    div s = φ = (q·w) / (1 + q·v)
    /// ```
    fn parts(&self, facets: &Facets<R>, q: Vec3) -> Parts<R> {
        let turned = |x| Warped::turning(x, self.normal).direction;
        let v = facets.viewer.value();
        let w = facets.viewer - turned(v);
        let divergence = w.dot(Vec3::constant(q / (1.0 + q.dot(v))));
        let against = Vec3::constant(q + v) * divergence - w;
        let (still, turning) = (Vec3::constant(q), turned(q));
        let (rest, own) = match self.rest_turns {
            true => (turning, against),
            false => (still, against + turning - still),
        };
        Parts {
            rest,
            own,
            divergence,
        }
    }
}

/// A sampled direction that moves along a field, or stays if there is none.
pub fn along<R: Real>(q: Vec3, following: Option<Following<R>>) -> Warped<R> {
    following.map_or(Warped::still(q), |following| following.warped(q))
}

/// The direction of [`along`] alone.
pub fn direction_along<R: Real>(q: Vec3, following: Option<Following<R>>) -> Vec3<R> {
    following.map_or(Vec3::constant(q), |following| following.direction(q))
}

/// A direction of the field without facets, and what is to be added for facets, which has the value zero, and
/// its divergence.
struct Parts<R> {
    rest: Vec3<R>,
    own: Vec3<R>,
    divergence: R,
}

impl<'v, R: Real> Facets<'v, R> {
    /// Those of a vertex; `None` if it has none, and if it transmits light. Whether they move does not matter
    /// here: sampling weights must not know it where no velocity is known.
    fn of(vertex: &'v Vertex<R>, narrowness: f64) -> Option<Self> {
        let has_facets = vertex.bsdf.has_facets() && !vertex.transmits;
        has_facets.then(|| {
            // Facets that are seen from behind reflect what they would to the mirrored viewer.
            let Vec3 { x, y, z } = vertex.wi;
            let wi = Vec3::new(x, y, z.abs());
            Self {
                bsdf: &vertex.bsdf,
                frame: vertex.frame.value(),
                wi: wi.value(),
                viewer: vertex.frame.to_world(wi),
                narrowness,
            }
        })
    }

    /// The share `k` of the half vector in the velocity of a direction of the frame: `Σ f_l k_l / Σ f_l` over
    /// the parts `f_l` of the BSDF, so that each is an integral with a field of its own. With `θ` half the angle
    /// between direction and viewer, and `δ` the width of the light, facets have
    /// `k_l = 1 / (1 + α² (c tan² θ + 1 / δ²))`, and the rest 0.
    fn share<S: Real>(&self, wo: Vec3<S>) -> S {
        let bsdf = self.bsdf.map(&mut |x| S::constant(x.value()));
        let wi = Vec3::constant(self.wi);
        let all = sum(bsdf.eval(wi, wo));
        if all.value() <= 0.0 {
            return S::constant(0.0);
        }
        // tan² = (1 - cos) / (1 + cos) of the whole angle.
        let (one, cos) = (S::constant(1.0), wi.dot(wo));
        let mut follows = S::constant(0.0);
        bsdf.mirrored(wi, wo, &mut |part, alpha2| {
            let grazing = S::constant(ROUGHNESS_COUNTS) * (one - cos);
            let wide = S::constant(self.narrowness) * (one + cos);
            let rough = alpha2 * (grazing + wide);
            follows = follows + sum(part) * (one + cos) / (one + cos + rough);
        });
        follows / all
    }
}

/// The sum of the channels.
fn sum<R: Real>(colour: Rgb<R>) -> R {
    colour.r + colour.g + colour.b
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use capwalk_math::Moments;
    use capwalk_scene::lobe::{
        Distribution, Lobe, Microfacets, RoughConductor, RoughPlastic, RoughTransmittance,
    };

    use super::*;

    type D = Dual<1>;

    const ALPHA: f64 = 0.1;

    fn metal() -> Lobe {
        Lobe::RoughConductor(RoughConductor {
            microfacets: Microfacets::isotropic(Distribution::Ggx, ALPHA),
            eta: Rgb::splat(0.0),
            k: Rgb::splat(1.0),
            specular_reflectance: Rgb::splat(1.0),
        })
    }

    fn plastic() -> Lobe {
        let eta = 1.5;
        Lobe::RoughPlastic(RoughPlastic {
            distribution: Distribution::Ggx,
            alpha: ALPHA,
            eta,
            diffuse_reflectance: Rgb::splat(0.5),
            specular_reflectance: Rgb::splat(1.0),
            nonlinear: false,
            transmittance: Arc::new(RoughTransmittance::new(Distribution::Ggx, ALPHA, eta)),
        })
    }

    /// A surface that turns before a viewer who moves.
    fn vertex(lobe: &Lobe) -> Vertex<D> {
        let normal = Vec3::new(0.2, -0.3, 0.9).normalized();
        let turns = Vec3::new(0.7, 0.9, -0.4).cross(normal);
        let viewer = Vec3::new(0.8, 0.1, 0.7).normalized();
        let moves = Vec3::new(-0.3, 0.5, 0.2).reject_from(viewer);
        Vertex::new(
            Vec3::zero(),
            0,
            normal,
            Frame::from_normal(normal.with_tangent(turns)),
            viewer.with_tangent(moves),
            LocalBsdf::from(lobe.map(&mut |x| D::constant(x))),
        )
    }

    /// Directions of the hemisphere above a vertex, most of them in the lobe.
    fn directions(vertex: &Vertex<D>, count: u32) -> impl Iterator<Item = (Vec3, f64)> {
        let primal = vertex.value();
        (0..count).filter_map(move |i| {
            let [choice, x, y] =
                [0.819_172_5, 0.671_043_6, 0.549_700_5].map(|step| (f64::from(i) * step).fract());
            let drawn = primal.bsdf.sample(primal.wi, choice, [x, y])?;
            Some((primal.frame.to_world(drawn.wo), drawn.pdf))
        })
    }

    fn fields<'v>(vertex: &'v Vertex<D>) -> [Following<'v, D>; 2] {
        let before_a_lamp = Following::of_facets(vertex, 0.1);
        [
            Following::of(vertex),
            before_a_lamp.expect("there are facets"),
        ]
    }

    /// The half vector of what metal reflects stays in the frame, but for a part of the size of its
    /// roughness squared.
    #[test]
    fn half_vectors_stay_in_the_frame() {
        let vertex = vertex(&metal());
        let following = Following::of(&vertex);
        for (q, _) in directions(&vertex, 50) {
            let local = |v: Vec3<D>| vertex.frame.to_local(v);
            let half = |q| (local(q) + vertex.wi).normalized().tangent(0);
            let [follows, turns] = [
                following.direction(q),
                Warped::turning(q, vertex.frame.n).direction,
            ]
            .map(|q| half(q).length());
            assert!(follows < 10.0 * ALPHA * ALPHA * turns, "{follows} {turns}");
        }
    }

    /// The divergence is that of the directions' velocities, by central differences.
    #[test]
    fn divergences_match_differences() {
        for lobe in [metal(), plastic()] {
            let vertex = vertex(&lobe);
            for (field, (q, _)) in fields(&vertex)
                .into_iter()
                .flat_map(|field| directions(&vertex, 50).map(move |at| (field, at)))
            {
                let warped = field.warped(q);
                assert_eq!(warped.direction.value(), q);
                assert_eq!(warped.direction, field.direction(q));
                let step = 1e-5;
                let Frame { s, t, .. } = Frame::from_normal(q);
                let velocity = |offset: Vec3| {
                    let direction = field.direction((q + offset).normalized());
                    direction.tangent(0)
                };
                let slope = |e: Vec3| (velocity(e * step) - velocity(-e * step)).dot(e);
                let difference = (slope(s) + slope(t)) / (2.0 * step);
                let found = warped.jacobian.tangent[0];
                let error = (found - difference).abs();
                // The table of what passes a coat has kinks.
                assert!(error < 2e-3 * (1.0 + found.abs()), "{found} {difference}");
            }
        }
    }

    /// Light that a lobe scatters has the same derivative whether its directions stay, turn with the
    /// normal, or follow the half vector, but not the same variance. (Of plastic, most is the base's.)
    #[test]
    fn half_vectors_take_the_noise_of_narrow_lobes_away() {
        let light = |q: Vec3<D>| {
            let [x, y] = [q.x * D::constant(5.0), q.y * D::constant(4.0)];
            D::constant(1.0) + x.sin_cos().0 * D::constant(0.5) + y.sin_cos().1 * D::constant(0.4)
        };
        for (lobe, less) in [(metal(), 5.0), (plastic(), 1.0)] {
            let vertex = vertex(&lobe);
            let moments = |warp: &dyn Fn(Vec3) -> Warped<D>| {
                let mut moments = Moments::default();
                for (q, pdf) in directions(&vertex, 40_000) {
                    let warped = warp(q);
                    let f = vertex.eval(warped.direction).r;
                    let seen = f * light(warped.direction) * warped.jacobian;
                    moments.add(seen.tangent[0] / pdf);
                }
                moments
            };
            let [all, lamp] = fields(&vertex);
            let stays = moments(&|q| Warped::still(q));
            let turns = moments(&|q| Warped::turning(q, vertex.frame.n));
            for field in [all, lamp] {
                let follows = moments(&|q| field.warped(q));
                for other in [&stays, &turns] {
                    let error = follows.standard_error().hypot(other.standard_error());
                    let score = (follows.mean - other.mean) / error;
                    assert!(score.abs() < 4.0, "{follows:?} {other:?}");
                    let ratio = other.variance() / follows.variance();
                    assert!(ratio > less, "{}: {ratio} times", lobe.plugin());
                }
            }
        }
    }
}
