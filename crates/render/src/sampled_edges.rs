//! Points sampled on edges around a shading point, in proportion to what they contribute
//! to the boundary term, where directions do not move, turn with the shading normal,
//! or follow the half vector (METHOD 8).

use std::borrow::Cow;

use capwalk_boundary::{
    Boundaries, EdgePoint, Field, MirrorImage, Motion, SilhouettePieces, Viewpoint, clip,
    moving_apex, place,
};
use capwalk_geometry::add_effort;
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::EmitterId;
use capwalk_scene::lobe::Lobe;

use crate::emitter_edge_term::{emitted_and_reflected, emitted_past, reflected_environment};
use crate::half_vector::{Following, direction_along};
use crate::scene_eval::SceneEval;
use crate::vertex::Vertex;

/// How far the planes of a window are moved outward, as a fraction of the edge's
/// distance: more than rounding.
pub const IN_PLANE: f64 = 1e-9;

/// The effort of weighing a piece: BSDF and cosine are evaluated.
const EFFORT_OF_PIECE: u64 = 4;

/// Length of the longest piece that has one sampling weight, radians, where lobes may be narrow, and on GPUs at
/// all surfaces that are not diffuse.
pub const PIECE: f64 = 0.05;
/// Length of the longest piece at wide lobes, radians.
const LONGEST_PIECE: f64 = 0.4;
/// Length of the longest piece at diffuse surfaces, radians. There longer ones add more noise than they save time.
pub const DIFFUSE_PIECE: f64 = 0.2;
/// The most pieces of one edge.
pub const MOST_PIECES: f64 = 32.0;

/// Share of the mean over all pieces that is added to what a piece contributes at its
/// middle: beside the middle there may be light, or motion.
pub const LEAST_WEIGHT: f64 = 0.03;
/// The weight per angle that is added where that mean is zero.
const TINY: f64 = 1e-30;

/// A shading point at which boundary terms are estimated.
pub struct ShadingPoint<'a, R: Real, W> {
    /// The boundaries of the scene.
    pub field: &'a Field<'a>,
    /// Its numbers.
    pub eval: &'a W,
    /// The point with its derivatives.
    pub viewpoint: &'a Viewpoint<R>,
    /// The primal point.
    pub vertex: &'a Vertex<f64>,
    /// What sampled directions follow, if they do not stay.
    pub following: Option<Following<'a, R>>,
    /// If edges count as flat mirrors show them: then all of this is where mirrors make it appear.
    pub in_mirrors: Option<InMirrors<'a, R>>,
}

/// A shading point that looks into flat mirrors.
#[derive(Clone, Copy, Debug)]
pub struct InMirrors<'a, R: Real> {
    /// What they show.
    pub image: &'a MirrorImage,
    /// The most specular events on the way.
    pub events: u32,
    /// Where the point is.
    pub position: Vec3<R>,
    /// What directions from there follow, if they do not stay.
    pub following: Option<Following<'a, R>>,
    /// How much faster than one face of each mirror the others move, at most, world units.
    pub spread: f64,
}

/// How directions from a shading point move, as far as sampling weights use it.
#[derive(Clone, Copy, Debug)]
pub struct Turning {
    motion: Motion,
    /// Angular velocity.
    rotation: Vec3,
    /// How fast they turn, radians, where only that is guessed.
    guessed: f64,
}

impl Turning {
    /// How fast directions turn, radians.
    pub fn speed(&self) -> f64 {
        self.rotation.length() + self.guessed
    }

    /// The motion of what is seen still at some offset from the shading point.
    #[inline]
    pub fn at(&self, offset: Vec3) -> Motion {
        Motion {
            velocity: self.motion.velocity + self.rotation.cross(offset),
            spread: self.motion.spread + self.guessed * offset.length(),
        }
    }

    /// True if they certainly do not move.
    pub fn is_still(&self) -> bool {
        self.motion == Motion::STILL && self.speed() == 0.0
    }
}

impl<R: Real, W: SceneEval<R>> ShadingPoint<'_, R, W> {
    /// How directions move, as far as sampling weights may use it.
    pub fn motion(&self) -> Turning {
        let mut motion = self.eval.motion_of(self.viewpoint.position);
        motion.spread += self.in_mirrors.as_ref().map_or(0.0, |seen| seen.spread);
        let Some((normal, viewer)) = self.following.map(|following| following.axes()) else {
            return Turning {
                motion,
                rotation: Vec3::zero(),
                guessed: 0.0,
            };
        };
        let (n, change) = (normal.value(), self.eval.motion_of(normal));
        let mut turning = Turning {
            motion,
            rotation: n.cross(change.velocity),
            // What may move may turn.
            guessed: change.spread.max(motion.spread),
        };
        if let Some(viewer) = viewer {
            // What facets reflect turns as the mirror's direction does, give or take as much: in the turning
            // frame that moves with the image of what the viewer moves with.
            let (v, change) = (viewer.value(), self.eval.motion_of(viewer));
            let against = change.velocity - turning.rotation.cross(v);
            let image = |x: Vec3| n * (2.0 * n.dot(x)) - x;
            turning.rotation += image(v).cross(image(against));
            turning.guessed += against.length() + change.spread.max(motion.spread);
        }
        turning
    }

    /// `(u_edge - u)·n` over the density of a point of an edge ([`EdgePoint::flow`]); `None` where it
    /// is not seen in the mirrors that count.
    pub fn flow(&self, point: &EdgePoint) -> Option<R> {
        let Field {
            accel, boundaries, ..
        } = self.field;
        let ends = point.ends().map(|i| self.eval.boundary_point(i));
        let Some(seen) = &self.in_mirrors else {
            let warped = direction_along(point.direction, self.following);
            return Some(point.flow(ends, self.viewpoint.position, warped));
        };
        // What lies in a mirror is its own image, and from the horizon comes no light.
        let places = point.ends().map(|i| boundaries.position(i));
        let (position, normal) = (self.vertex.position, self.vertex.face_normal);
        if seen.image.is_in_mirror(places, accel.horizon_distance())
            || self.field.in_horizon(position, point.ends(), normal)
        {
            return None;
        }
        let direction = seen.image.direction(point.direction);
        let ray = accel.surface_ray(seen.position.value(), direction);
        let mirrors = accel.mirrors_along(seen.image, ray, point.distance, seen.events)?;
        // The direction that stays, or follows, is reflected by mirrors that may move.
        let warped = direction_along(direction, seen.following);
        let ray = [seen.position, warped];
        let vertex = |i| self.eval.vertex(i);
        let [apex, warped] = moving_apex(&accel.mesh, &mirrors, ray, vertex);
        Some(point.flow(ends, apex, warped))
    }

    /// True if certainly neither an edge nor directions move.
    pub fn is_stationary(&self, turning: &Turning, edge: u32) -> bool {
        turning.is_still() && !moves(self.eval, self.field.boundaries, edge)
    }
}

/// False if an edge certainly does not move.
pub fn moves<R: Real, W: SceneEval<R>>(eval: &W, boundaries: &Boundaries, edge: u32) -> bool {
    let mut points = boundaries.edge(edge).vertices.into_iter();
    points.any(|point| !eval.motion_of_point(point).is_still())
}

/// An edge listed for sampling.
#[derive(Clone, Copy, Debug)]
pub struct ListedEdge {
    /// Its number.
    pub edge: u32,
    /// Its ends.
    pub ends: [Vec3; 2],
    /// What its sampling weight is multiplied by.
    pub factor: f64,
}

/// Edges cut into pieces with sampling weights, and memory for more.
#[derive(Default)]
pub struct SampledEdges {
    weighed: Vec<Weighed>,
    pieces: SilhouettePieces,
}

/// Length of the longest piece at a vertex, radians: about as long as its narrowest lobe is wide. Facets that are rougher
/// in one direction than in the other count as equally rough.
fn longest_piece(vertex: &Vertex<f64>) -> f64 {
    let bsdf = &vertex.bsdf;
    if bsdf.is_diffuse() {
        return DIFFUSE_PIECE;
    }
    let is_known = |lobe: &Lobe| lobe.has_facets() || !lobe.is_glossy();
    if vertex.transmits || bsdf.is_tilted() || !bsdf.lobes().all(|(_, lobe)| is_known(lobe)) {
        return PIECE;
    }
    // Facets of the roughness α reflect to about 2 α around the mirror direction, times the cosine to the sides.
    let Vec3 { x, y, z } = vertex.wi;
    let (wi, mirror) = (Vec3::new(x, y, z.abs()), Vec3::new(-x, -y, z.abs()));
    let mut alpha2 = f64::INFINITY;
    bsdf.mirrored(wi, mirror, &mut |part, own| {
        if part.max_component() > 0.0 {
            alpha2 = alpha2.min(own);
        }
    });
    add_effort(EFFORT_OF_PIECE);
    match alpha2.is_finite() {
        true => (2.0 * alpha2.sqrt() * wi.z).clamp(PIECE, LONGEST_PIECE),
        false => DIFFUSE_PIECE,
    }
}

/// A piece of an edge.
struct Weighed {
    edge: u32,
    range: [f64; 2],
    /// Radians.
    angle: f64,
    /// What it contributes if all of it is like its middle.
    contribution: f64,
}

impl SampledEdges {
    /// How many pieces there are.
    pub fn count(&self) -> usize {
        self.pieces.count()
    }

    /// Adds edges that are not sampled, but share the discontinuity where they lie on an edge
    /// that is: those that `lie_on` gives for it.
    pub fn push_companions<I: Iterator<Item = u32>>(
        &mut self,
        boundaries: &Boundaries,
        lie_on: impl Fn(u32) -> I,
    ) {
        let Self { weighed, pieces } = self;
        // The pieces of an edge follow each other.
        for edge in weighed.chunk_by(|a, b| a.edge == b.edge) {
            for other in lie_on(edge[0].edge) {
                if !pieces.contains(other) {
                    pieces.push_companion(boundaries, other);
                }
            }
        }
    }

    /// Cuts edges into pieces, in place of those from before, where they are on the inner
    /// sides of planes through the shading point. The sampling weight of a piece is what it
    /// contributes if all of it is like its middle: its angle times the largest channel of
    /// BSDF and cosine times the angular speed across the edge, times `light` in that
    /// direction.
    pub fn weigh<R: Real, W: SceneEval<R>>(
        &mut self,
        at: &ShadingPoint<R, W>,
        listed: impl Iterator<Item = ListedEdge>,
        planes: &[Vec3],
        light: impl Fn(Vec3) -> f64,
    ) {
        let (eval, vertex, turning) = (at.eval, at.vertex, at.motion());
        let Self { weighed, pieces } = self;
        weighed.clear();
        let longest = longest_piece(vertex);
        for ListedEdge { edge, ends, factor } in listed {
            // An edge without relative motion contributes nothing.
            if at.is_stationary(&turning, edge) {
                continue;
            }
            let points = at.field.boundaries.edge(edge).vertices;
            let [a, b] = ends.map(|p| p - vertex.position);
            // Clip the edge; an emitter's own edges, in its planes, count as inside.
            let margin = IN_PLANE * a.length().max(b.length());
            let Some(range) = clip(planes, margin, [a, b]) else {
                continue;
            };
            let normal = a.cross(b).normalized();
            let ends = range.map(|t| a + (b - a) * t);
            let [near, far] = ends.map(Vec3::length);
            let [from, to] = [ends[0] / near, ends[1] / far];
            // Cut it at equal steps on the chord between the directions of its ends.
            let chord = to - from;
            let count = (chord.length() / longest).ceil().clamp(1.0, MOST_PIECES);
            let place = |part| place(range, [near, far], part);
            for i in 0..count as u32 {
                let part = |k: f64| (f64::from(i) + k) / count;
                let middle = (from + chord * part(0.5)).normalized();
                let reflected = vertex.eval(middle).max_component() * light(middle);
                let t = place(part(0.5));
                let offset = a + (b - a) * t;
                let against = turning.at(offset).velocity;
                let apart = at.in_mirrors.as_ref().map_or(0.0, |seen| seen.spread);
                let speed = (eval.speed(points, t, against, normal) + apart) / offset.length();
                let angle = factor * chord.length() / count;
                let contribution = angle * reflected * speed;
                // An edge seen end-on has no middle direction, and no angle.
                if contribution.is_finite() {
                    weighed.push(Weighed {
                        edge,
                        range: [place(part(0.0)), place(part(1.0))],
                        angle,
                        contribution,
                    });
                }
            }
        }
        add_effort(EFFORT_OF_PIECE * weighed.len() as u64);
        // Every piece has a share of its angle, too.
        let sum: f64 = weighed.iter().map(|piece| piece.contribution).sum();
        let angle: f64 = weighed.iter().map(|piece| piece.angle).sum();
        let least = LEAST_WEIGHT * sum / angle + TINY;
        pieces.clear();
        let boundaries = at.field.boundaries;
        for piece in &*weighed {
            let weight = piece.contribution + least * piece.angle;
            pieces.push(boundaries, piece.edge, piece.range, weight);
        }
    }

    /// The sum over the pieces: an estimate from so many points, stratified by `u`, a
    /// number of value zero whose derivative is
    ///
    /// ```text
    /// Σ ∫ [f(behind) - f(before)] (u_edge - u)·n dl
    /// ```
    ///
    /// `f` is radiance times BSDF and cosine, and `discontinuity` gives that difference; `u_edge` is the
    /// angular velocity of an edge, `u` that of directions, zero unless they turn, and `n` the
    /// normal of the edge's projection, from behind to before.
    /// Hidden edges need no visibility test: `f` is the same on both of their sides.
    pub fn term<R: Real, W: SceneEval<R>>(
        &self,
        at: &ShadingPoint<R, W>,
        mut discontinuity: impl FnMut(&EdgePoint) -> Rgb,
        u: f64,
        points: u32,
    ) -> Rgb<R> {
        let mut light = Rgb::zero();
        for i in 0..points {
            // Sample a point on one of the edges.
            let u = (f64::from(i) + u) / f64::from(points);
            let boundaries = at.field.boundaries;
            let Some(point) = self
                .pieces
                .draw(boundaries, at.vertex.position, u, |_, _, _| true)
            else {
                continue;
            };
            // Evaluate (u_edge - u)·n over the density.
            let Some(flow) = at.flow(&point) else {
                continue;
            };
            // Trace rays only where something moves. A shading point on the edge itself
            // gives a NaN, which is not constant and is counted with the sample.
            if !flow.is_constant() {
                light += Rgb::constant(discontinuity(&point) / f64::from(points)) * flow;
            }
        }
        light
    }
}

/// `f(behind) - f(before)` of one emitter's light at a point of an edge.
pub fn discontinuity(
    field: &Field,
    vertex: &Vertex<f64>,
    point: &EdgePoint,
    emitter: EmitterId,
) -> Rgb {
    let accel = field.accel;
    let is_environment = accel.scene.environment() == Some(emitter);
    let is_chosen = |other| other == emitter;
    let [behind, before] = point.sides();
    match point.covered_side(field.boundaries, accel, vertex.position, emitter) {
        // The surface covers one side, and emits nothing there: one ray past the edge shows
        // whether the edge is seen, and what is behind it.
        Some(covered) => {
            let (direction, sign) = match covered {
                0 => (before, -1.0),
                _ => (behind, 1.0),
            };
            let light = match is_environment {
                true => reflected_environment(accel, vertex, direction, emitter),
                false => emitted_past(accel, vertex, direction, point.distance, is_chosen),
            };
            light * sign
        }
        None => {
            let light = |vertex: &Vertex<f64>, side| match is_environment {
                true => reflected_environment(accel, vertex, side, emitter),
                false => emitted_and_reflected(accel, vertex, side, is_chosen),
            };
            let [behind, before] = [behind, before]
                .map(|side| light(&beside_its_face(field, vertex, point, side), side));
            behind - before
        }
    }
}

/// The shading point from which a direction beside an edge is looked in: where the edge is in
/// the plane of the point's face, on that side of the face on which the direction leaves it. A
/// ray within rounding of the plane would hit the face on its way, or not.
pub fn beside_its_face<'v>(
    field: &Field,
    vertex: &'v Vertex<f64>,
    point: &EdgePoint,
    direction: Vec3,
) -> Cow<'v, Vertex<f64>> {
    if !field.in_horizon(vertex.position, point.ends(), vertex.face_normal) {
        return Cow::Borrowed(vertex);
    }
    let side = direction.dot(vertex.face_normal).signum();
    let offset = vertex.face_normal * (side * field.accel.horizon_distance());
    Cow::Owned(Vertex {
        position: vertex.position + offset,
        ..vertex.clone()
    })
}

#[cfg(test)]
mod tests {
    use capwalk_math::Frame;
    use capwalk_scene::bsdf::NormalLimits;
    use capwalk_scene::lobe::{
        Diffuse, Distribution, LocalBsdf, Microfacets, RoughConductor, Tilt,
    };

    use super::*;

    /// Pieces are as long as a lobe is wide: straight from above twice its roughness, and less the flatter it is seen. Of
    /// two lobes the narrower one counts.
    #[test]
    fn pieces_are_as_long_as_lobes_are_wide() {
        let tinted = |alpha, tint| {
            Lobe::RoughConductor(RoughConductor {
                microfacets: Microfacets::isotropic(Distribution::Ggx, alpha),
                eta: Rgb::splat(0.0),
                k: Rgb::splat(1.0),
                specular_reflectance: Rgb::splat(tint),
            })
        };
        let metal = |alpha| tinted(alpha, 0.5);
        let reflectance = Rgb::splat(0.5);
        let longest_of = |bsdf: LocalBsdf, z: f64| {
            let normal = Vec3::new(0.0, 0.0, 1.0);
            let wi = Vec3::new((1.0 - z * z).sqrt(), 0.0, z);
            let frame = Frame::from_normal(normal);
            longest_piece(&Vertex::new(Vec3::zero(), 0, normal, frame, wi, bsdf))
        };
        let longest = |lobes: &[Lobe], z: f64| {
            let mut bsdf = LocalBsdf::default();
            lobes.iter().for_each(|lobe| bsdf.push(0.5, lobe.clone()));
            longest_of(bsdf, z)
        };
        let diffuse = Lobe::Diffuse(Diffuse { reflectance });
        for (lobes, z, expected) in [
            (vec![diffuse.clone()], 0.5, DIFFUSE_PIECE),
            (vec![metal(0.1)], 1.0, 0.2),
            (vec![metal(0.1), diffuse], 0.5, 0.1),
            (vec![metal(0.15), metal(0.05)], 0.8, 0.08),
            (vec![metal(0.01)], 1.0, PIECE),
            (vec![metal(0.7)], 1.0, LONGEST_PIECE),
            (vec![metal(0.1)], 0.1, PIECE),
            (vec![tinted(0.1, 0.0)], 0.5, DIFFUSE_PIECE),
        ] {
            let found = longest(&lobes, z);
            assert!((found - expected).abs() < 1e-12, "{lobes:?}: {found}");
        }
        // The mirror direction of a lobe about a normal of its own is another one.
        let limits = NormalLimits {
            flip_invalid: true,
            shadowing: true,
        };
        let tilt = Tilt::new(Vec3::new(0.2, 0.0, 1.0), limits);
        let mut tilted = LocalBsdf::default();
        tilted.push_tilted(1.0, metal(0.3), Some(tilt));
        assert_eq!(longest_of(tilted, 1.0), PIECE);
    }
}
