//! The velocity field around a viewpoint for light that arrives by a chain of specular events, by walks along the
//! chain (METHOD 6). Its boundaries are all that each segment of the chain sees: those around the viewpoint, and those
//! around each specular vertex. While the faces of the chain stay the same, its vertices `x_i` and directions `r_i` are
//! smooth functions of the direction `q`. With `a_i` the angle at `x_i` between `r_i` and the closest boundary, the
//! largest ball around `q` has the radius
//!
//! ```text
//! A(q) = min( a_0, min_i a_i c_i / s_i )
//! ```
//!
//! with `s_i / c_i` a guess of how much the chain magnifies: `s_i` is a constant, and `c_i` the smallest cosine
//! of a ray with the normal at its vertices, at least 0.05. A walk needs no more than that it is continuous, and
//! zero on the boundary, only there.

use std::cell::Cell;
use std::f64::consts::PI;

use capwalk_boundary::{
    BoundarySample, Field, Numbers, Viewpoint, Warp, direct_sphere, seen_by_chains,
};
use capwalk_geometry::{Ray, Sight, SilhouettePoint};
use capwalk_math::{Dual, Frame, Real, Vec3, sphere};
use capwalk_scene::lobe::Event;
use capwalk_walk::{Domain, Nearest, Sphere, WalkSettings, sample_field, sample_value};

use crate::chain::{AfterLink, Bent, Link, Start, follow, next_link};
use crate::chain_survey::{ChainSurvey, spread};
use crate::scene_eval::{SceneEval, Warped};

/// How strongly the motion of the image along an edge is damped, which moves no boundary: little of it counts where the
/// square of what the chain does to the direction along the edge is a smaller part of the square of all it does, or is
/// guessed to do.
const DAMPING: f64 = 0.1;

/// What is known of a chain of events from a viewpoint.
#[derive(Clone, Copy)]
pub struct ChainField<'a, R> {
    /// The scene and its boundaries.
    pub field: &'a Field<'a>,
    /// Its beginning.
    pub viewpoint: &'a Viewpoint<R>,
    pub start: &'a Start<R>,
    /// The events, one after the other.
    pub events: &'a [Event],
    /// By how much they magnify.
    pub survey: &'a ChainSurvey,
}

/// A boundary point of such a field.
#[derive(Clone, Copy, Debug)]
enum Site {
    /// Seen from the viewpoint.
    Direct(SilhouettePoint),
    /// Seen after some events of the chain in a direction.
    Behind {
        q: Vec3,
        events: usize,
        point: SilhouettePoint,
    },
}

/// The sphere of directions around the viewpoint.
struct ChainSphere<'a, R, F> {
    chain: &'a ChainField<'a, R>,
    start: Start<f64>,
    direct: [Sphere<'a, F>; 2],
    /// How many closest-silhouette queries were made.
    queries: Cell<u64>,
    /// The largest radius of a ball.
    max_radius: f64,
}

impl<R: Real> ChainField<'_, R> {
    /// A direction that moves with the field, an unbiased sample of it and of its divergence.
    pub fn warp<W: SceneEval<R>>(
        &self,
        eval: &W,
        q: Vec3,
        settings: &WalkSettings,
        random: Numbers,
    ) -> Warped<R> {
        let viewpoints = self.viewpoints();
        let sphere = self.sphere(&viewpoints, settings);
        let sample = sample_field(&sphere, q, settings, |i| random.number(i));
        random.draw.count_queries(sphere.queries.get());
        // What is seen from the viewpoint moves as ever.
        let direct = sample.filter_map(|site| self.direct_sample(site));
        let mut warped = eval.moved(self.viewpoint, q, Warp::Boundary(direct));
        for term in sample.terms() {
            let Some(velocity) = sphere.velocity(eval, &term.site) else {
                continue;
            };
            let covector = Vec3::constant(sample.divergence_covector(term));
            // Some have a share of the divergence alone, and the direction does not depend on them.
            if term.weight != 0.0 {
                warped.direction +=
                    (velocity * R::constant(term.weight)).reject_from(Vec3::constant(q));
            }
            warped.jacobian = warped.jacobian + covector.dot(velocity);
            warped.near_boundary = true;
        }
        warped
    }

    /// The direction of [`Self::warp`] without the divergence.
    pub fn warp_value<W: SceneEval<R>>(
        &self,
        eval: &W,
        q: Vec3,
        settings: &WalkSettings,
        random: Numbers,
    ) -> Vec3<R> {
        let viewpoints = self.viewpoints();
        let sphere = self.sphere(&viewpoints, settings);
        let found = sample_value(&sphere, q, settings, |i| random.number(i));
        random.draw.count_queries(sphere.queries.get());
        let still = Vec3::constant(q);
        let Some(site) = found else {
            return still;
        };
        match sphere.velocity(eval, &site) {
            Some(velocity) => still + velocity.reject_from(still),
            None => {
                let warp = Warp::Value(self.direct_sample(&site));
                eval.moved(self.viewpoint, q, warp).direction
            }
        }
    }

    fn direct_sample(&self, site: &Site) -> Option<BoundarySample> {
        match site {
            Site::Direct(point) => Some(self.field.direct_boundary_sample(self.viewpoint, point)),
            Site::Behind { .. } => None,
        }
    }

    /// The same viewpoint, from which only those edges are seen that bound such light.
    fn viewpoints(&self) -> [Viewpoint<R>; 2] {
        seen_by_chains(self.events.is_empty()).map(|(group, selection)| Viewpoint {
            group,
            selection,
            ..*self.viewpoint
        })
    }

    fn sphere<'s>(
        &'s self,
        viewpoints: &'s [Viewpoint<R>; 2],
        settings: &WalkSettings,
    ) -> ChainSphere<'s, R, impl Sight> {
        let [all, silhouettes] = viewpoints;
        ChainSphere {
            chain: self,
            start: self.start.value(),
            direct: [all, silhouettes].map(|viewpoint| direct_sphere(self.field, viewpoint)),
            queries: Cell::new(0),
            max_radius: settings.max_radius,
        }
    }
}

impl<R: Real, F: Sight> ChainSphere<'_, R, F> {
    /// The rays of a direction after each event, as long as its surfaces have them.
    fn links(&self, q: Vec3) -> impl Iterator<Item = AfterLink> {
        let accel = self.chain.field.accel;
        let mut ray: Ray = self.start.bounded_ray(accel, q);
        self.chain.events.iter().map_while(move |&event| {
            let after = next_link(accel, &ray, event)?;
            ray = accel.ray_leaving(&after.leaving, after.ray[0], after.ray[1]);
            Some(after)
        })
    }

    /// The first events of a direction's chain.
    fn first_links(&self, q: Vec3, count: usize) -> Vec<Link> {
        self.links(q).take(count).map(|after| after.link).collect()
    }

    /// By what the angle to a boundary after some events is multiplied.
    fn scale(&self, events: usize) -> f64 {
        1.0 / self.chain.survey.magnification_after(&self.start, events)
    }

    fn spread(&self, q: Vec3, links: &[Link]) -> (Frame, Bent<Dual<2>>) {
        spread(self.chain.field.accel, &self.start, q, links)
    }

    /// How the image of a boundary point moves that is seen after some events, radians; `None` for what is seen from
    /// the viewpoint itself.
    ///
    /// With `g` the direction from `x_i` to the point, the direction `q + u` stays on it if `K u = b` in the plane across
    /// `r_i`, where `K = ∂(r_i - g)/∂q` and `b` is how fast `g - r_i` changes. Only the motion across the edge moves the
    /// boundary: that row holds exactly, the one along the edge in the sense of least squares, damped.
    fn velocity<W: SceneEval<R>>(&self, eval: &W, site: &Site) -> Option<Vec3<R>> {
        let &Site::Behind { q, events, point } = site else {
            return None;
        };
        let field = self.chain.field;
        let links = self.first_links(q, events);
        // What changes with the direction.
        let (frame, bent) = self.spread(q, &links);
        let [x, r] = bent.ray;
        let ends = field.boundaries.edge(point.edge).vertices;
        let place = field.boundaries.point(ends, point.t);
        let g = (Vec3::constant(place) - x).normalized();
        let change = r - g;
        // Across the edge, and along it.
        let [a, b] = ends.map(|i| field.boundaries.position(i) - x.value());
        let across = a.cross(b).normalized();
        let along = across.cross(g.value());
        let row = |v: Vec3| [0, 1].map(|i| change.tangent(i).dot(v));
        let ([m0, m1], [t0, t1]) = (row(across), row(along));
        // What changes with the scene.
        let still = Vec3::constant(q);
        let [x, r] = follow(eval, field.accel, self.chain.start.ray(still), &links).ray;
        let [a, b] = ends.map(|i| eval.boundary_point(i));
        let place = a + (b - a) * R::constant(point.t);
        let moved = (place - x).normalized() - r;
        let moved = moved - Vec3::constant(moved.value());
        let [by_m, by_t] = [across, along].map(|v| moved.dot(Vec3::constant(v)));
        // u = K_m b_m / |K_m|² + α p, with p across K_m.
        let squared = m0 * m0 + m1 * m1;
        let p = [-m1 / squared.sqrt(), m0 / squared.sqrt()];
        let scale = self.scale(events);
        let apart = (scale * bent.cosine.value * point.angle / self.max_radius).min(1.0);
        let all = squared + t0 * t0 + t1 * t1 + 1.0 / (scale * scale);
        let damped = squared + apart * apart * all;
        let least = [m0 / damped, m1 / damped];
        let (by_least, by_p) = (t0 * least[0] + t1 * least[1], t0 * p[0] + t1 * p[1]);
        let damped = by_p / (by_p * by_p + DAMPING * all);
        let rest = (by_t - by_m * R::constant(by_least)) * R::constant(damped);
        let [u, v] = [0, 1].map(|i| by_m * R::constant(least[i]) + rest * R::constant(p[i]));
        let (s, t) = (Vec3::constant(frame.s), Vec3::constant(frame.t));
        // Where the chain turns nothing across the edge, this is NaN, and counted with the sample.
        Some(s * u + t * v)
    }
}

impl<R: Real, F: Sight> Domain for ChainSphere<'_, R, F> {
    type Vector = Vec3;
    type Site = Site;

    fn closest(&self, q: Vec3, limit: f64) -> Option<Nearest<Site, Vec3>> {
        // What is seen from the viewpoint.
        let mut best: Option<Nearest<Site, Vec3>> = None;
        for direct in &self.direct {
            let limit = best.map_or(limit, |best| best.distance);
            if let Some(nearest) = direct.closest(q, limit) {
                best = Some(Nearest {
                    site: Site::Direct(nearest.site),
                    point: nearest.point,
                    distance: nearest.distance,
                });
            }
        }
        let mut queries = self.queries.get() + self.direct.len() as u64;
        // And from each vertex of the chain.
        let mut cosine = 1.0_f64;
        for (i, after) in self.links(q).enumerate() {
            cosine = after.cosine.min(cosine);
            let scale = self.scale(i + 1) * cosine;
            let bound = (best.map_or(limit, |best| best.distance) / scale).min(PI);
            let [x, r] = after.ray;
            queries += 1;
            let last = i + 1 == self.chain.events.len();
            let found = (self.chain.field).closest_behind(x, &after.leaving, r, last, bound);
            if let Some(point) = found {
                best = Some(Nearest {
                    site: Site::Behind {
                        q,
                        events: i + 1,
                        point,
                    },
                    point: q,
                    distance: scale * point.angle,
                });
            }
        }
        self.queries.set(queries);
        best
    }

    fn radius_at(&self, q: Vec3, known: &Nearest<Site, Vec3>) -> Option<f64> {
        match known.site {
            Site::Direct(_) => Some(sphere::angle_between(q, known.point)),
            Site::Behind { .. } => None,
        }
    }

    /// Not behind events: where they magnify more than is guessed, it changes faster.
    fn is_distance(&self) -> bool {
        self.chain.events.is_empty()
    }

    /// Behind events, `∇(a c) / s`: the point stays, and with it its direction `g`, up to the motion of `x_i`.
    fn growth(&self, q: Vec3, nearest: &Nearest<Site, Vec3>) -> Vec3 {
        let Site::Behind { events, point, .. } = nearest.site else {
            return -sphere::tangent_towards(q, nearest.point);
        };
        let boundaries = self.chain.field.boundaries;
        let links = self.first_links(q, events);
        let (frame, bent) = self.spread(q, &links);
        let [x, r] = bent.ray;
        let place = boundaries.point(boundaries.edge(point.edge).vertices, point.t);
        let apart = r - (Vec3::constant(place) - x).normalized();
        // |r - g| = 2 sin(a / 2)
        let length = apart.value().length();
        let per_length = 1.0 / (length * (1.0 - 0.25 * length * length).sqrt());
        let [s, t] = [0, 1].map(|i| {
            let angle = apart.value().dot(apart.tangent(i)) * per_length;
            angle * bent.cosine.value + point.angle * bent.cosine.tangent[i]
        });
        (frame.s * s + frame.t * t) * self.scale(events)
    }

    #[inline]
    fn tangent(&self, q: Vec3, azimuth: f64) -> Vec3 {
        self.direct[0].tangent(q, azimuth)
    }
    #[inline]
    fn walk(&self, q: Vec3, e: Vec3, angle: f64) -> Vec3 {
        self.direct[0].walk(q, e, angle)
    }
    #[inline]
    fn radius_inside(&self, half_angle: f64, u: f64) -> f64 {
        self.direct[0].radius_inside(half_angle, u)
    }
    #[inline]
    fn rim_over_ball(&self, half_angle: f64) -> f64 {
        self.direct[0].rim_over_ball(half_angle)
    }
    #[inline]
    fn curvature(&self, q: Vec3) -> Vec3 {
        self.direct[0].curvature(q)
    }
}

#[cfg(test)]
mod tests {
    use capwalk_boundary::{Accel, Boundaries, Method, SEEN};
    use capwalk_geometry::edge::closest_direction;
    use capwalk_geometry::{Edge, EdgeSelection};
    use capwalk_scene::lobe::Conductor;
    use capwalk_scene::primitive::icosphere;
    use capwalk_scene::{BsdfId, Material, Scene, ShadingNormals, Shape, Texture, builtin};

    use super::*;

    /// A mirror ball before a built-in scene's camera, beside what that sees.
    fn with_mirror_ball() -> Scene {
        let mut scene = builtin::scene("box-room").expect("built in");
        let mut number = |id: &str, x: f64| scene.add_texture(Texture::number(id, x));
        let (eta, k) = (number("eta", 0.0), number("k", 1.0));
        let metal = Conductor {
            eta,
            k,
            specular_reflectance: k,
        };
        scene.materials.push(Material {
            id: "metal".into(),
            bsdf: metal.into(),
        });
        let id = BsdfId(scene.materials.len() as u32 - 1);
        let view = scene.sensor.view(&scene.film);
        let [x, y] = scene.film.size.map(|n| 0.5 * f64::from(n));
        let centre = view.origin + view.direction([x, y]) * 2.0;
        let mut ball = icosphere(3);
        ball.positions
            .iter_mut()
            .for_each(|p| *p = *p * 0.5 + centre);
        let normals = ShadingNormals::computed(&ball);
        scene.add_shape(Shape::new("mirror", ball, normals, id));
        scene
    }

    /// Directions of the camera.
    fn directions(accel: &Accel) -> impl Iterator<Item = Vec3> {
        let [width, height] = accel.scene.film.size.map(f64::from);
        (0..300).map(move |i| {
            let [x, y] = [0.618_034, 0.414_214].map(|k| (f64::from(i) * k).fract());
            accel.view.direction([width * x, height * y])
        })
    }

    /// All edges, one after the other: those that bound light of chains, whose closest point is seen from the surface
    /// and that are not in the plane of the face.
    #[test]
    fn what_is_closest_behind_an_event_is_that_of_brute_force() {
        let mut scene = with_mirror_ball();
        // Another one, and one that scatters light.
        let ball = Shape::clone(scene.shapes.last().expect("the ball"));
        let places = [Vec3::new(0.7, 0.5, -0.6), Vec3::new(-0.7, 0.5, -0.6)];
        for ((id, bsdf), by) in [("mirror 2", ball.bsdf), ("paint", BsdfId(0))]
            .into_iter()
            .zip(places)
        {
            let mut moved = Shape {
                id: id.into(),
                bsdf,
                ..ball.clone()
            };
            (moved.mesh.positions.iter_mut()).for_each(|p| *p += by);
            scene.add_shape(moved);
        }
        let accel = Accel::new(scene);
        let boundaries = Boundaries::new(&accel);
        let field = Field::new(&accel, &boundaries, Method::Walk);
        let event = Event::Reflect;
        // Of how many directions the closest one is a silhouette of a smooth mesh or not, where that is all it can be.
        let mut found = [[0, 0], [0, 0]];
        for (q, last) in directions(&accel).flat_map(|q| [(q, false), (q, true)]) {
            let ray = Start::Camera(accel.view).bounded_ray(&accel, q);
            let Some(after) = next_link(&accel, &ray, event) else {
                continue;
            };
            let [x, r] = after.ray;
            let angle = |edge: &Edge| {
                let [all, silhouettes] =
                    seen_by_chains(last).map(|(group, _)| edge.groups & group != 0);
                let ends = edge.vertices.map(|i| boundaries.position(i));
                let [a, b] = ends.map(|p| p - x);
                let closest = closest_direction(a, b, r)?;
                let counts = all || silhouettes && edge.is_silhouette(&accel.mesh, x);
                let is_own = field.in_horizon(x, edge.vertices, after.leaving.normal());
                let ray = accel.ray_leaving(&after.leaving, x, closest.direction);
                let seen = accel.first_hit_within(&ray);
                let is_seen = seen.is_none_or(|hit| hit.t > closest.distance - 1e-7);
                (counts && !is_own && is_seen).then_some((closest.angle, silhouettes))
            };
            let edges = boundaries.edges().iter();
            let expected = edges
                .filter_map(angle)
                .min_by(|(a, _), (b, _)| a.total_cmp(b));
            let point = field.closest_behind(x, &after.leaving, r, last, PI);
            let (point, (angle, is_silhouette)) = point.zip(expected).expect("a room has edges");
            assert!(
                (point.angle - angle).abs() < 1e-12,
                "{q:?}: {}, {angle}",
                point.angle
            );
            found[usize::from(last)][usize::from(is_silhouette)] += 1;
        }
        assert!(found.iter().flatten().all(|&count| count > 5), "{found:?}");
    }

    /// The radius grows as it says: along each of two tangents, by central differences where the same boundary point
    /// is closest on both sides.
    #[test]
    fn growth_is_the_gradient_of_the_radius() {
        let accel = Accel::new(with_mirror_ball());
        let boundaries = Boundaries::new(&accel);
        let field = Field::new(&accel, &boundaries, Method::Walk);
        let chain = ChainField {
            field: &field,
            viewpoint: &Viewpoint::camera(&accel.view, 0),
            start: &Start::Camera(accel.view),
            events: &[Event::Reflect],
            survey: &ChainSurvey::of(&accel),
        };
        let viewpoints = chain.viewpoints();
        let settings = WalkSettings::default();
        let sphere = chain.sphere(&viewpoints, &settings);
        let mut compared = 0;
        for q in directions(&accel) {
            let Some(nearest) = sphere.closest(q, 3.0) else {
                continue;
            };
            let Site::Behind { point, .. } = nearest.site else {
                continue;
            };
            let growth = sphere.growth(q, &nearest);
            let Frame { s, t, .. } = Frame::from_normal(q);
            let step = 1e-7;
            for e in [s, t] {
                let at = |by: f64| sphere.closest((q + e * by).normalized(), 3.0);
                let same = |found: &Nearest<Site, Vec3>| matches!(found.site, Site::Behind { point: other, .. } if other.edge == point.edge);
                let (Some(before), Some(after)) = (at(-step).filter(same), at(step).filter(same))
                else {
                    continue;
                };
                let difference = (after.distance - before.distance) / (2.0 * step);
                let error = (growth.dot(e) - difference).abs();
                // Normals are interpolated: some differences are across an edge of the mirror.
                compared += u32::from(error < 1e-4 * (1.0 + growth.length()));
                assert!(
                    error < 0.3 * (1.0 + growth.length()),
                    "{growth:?} {difference}"
                );
            }
        }
        assert!(compared > 60, "{compared}");
    }

    /// Without events it is the field around the viewpoint, to the bit.
    #[test]
    fn a_chain_without_events_is_the_ordinary_field() {
        let accel = Accel::new(builtin::scene("box-room").expect("built in"));
        let boundaries = Boundaries::new(&accel);
        let field = Field::new(&accel, &boundaries, Method::Walk);
        let viewpoint = Viewpoint::camera(&accel.view, 0);
        assert_eq!(
            (viewpoint.group, viewpoint.selection),
            (SEEN, EdgeSelection::All)
        );
        let chain = ChainField {
            field: &field,
            viewpoint: &viewpoint,
            start: &Start::Camera(accel.view),
            events: &[],
            survey: &ChainSurvey::default(),
        };
        let settings = WalkSettings::default();
        let viewpoints = chain.viewpoints();
        let chained = chain.sphere(&viewpoints, &settings);
        let direct = direct_sphere(&field, &viewpoint);
        let mut count = 0;
        for (i, q) in (0..).zip(directions(&accel)) {
            let random = |k: u32| (f64::from(i * 7 + k) * 0.754_877_67).fract();
            let [a, b] = [
                sample_field(&chained, q, &settings, random).map(|site| match site {
                    Site::Direct(point) => *point,
                    Site::Behind { .. } => unreachable!("there are no events"),
                }),
                sample_field(&direct, q, &settings, random),
            ];
            let terms = |sample: &capwalk_walk::FieldSample<SilhouettePoint, Vec3>| {
                let terms = sample.terms();
                let terms =
                    terms.map(|term| (term.site.edge, term.site.t, term.weight, term.gradient));
                terms.collect::<Vec<_>>()
            };
            assert_eq!(terms(&a), terms(&b));
            count += u32::from(!a.is_zero());
        }
        assert!(count > 100, "{count}");
    }
}
