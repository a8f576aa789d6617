//! Reflected boundaries (METHOD 6): edges seen in flat mirrors and through panes are
//! boundaries of the field around the viewpoint, in the directions of their mirror images.
//!
//! The mirror image of an edge is not built. Instead the viewpoint is reflected: from its
//! mirror image, the edge itself is seen in the reflected direction and at the same
//! distance, so the same query in the same tree finds it from another apex. The specular
//! chains that are searched are those of the ray in the direction `q`. Images seen in
//! other mirrors are beyond the silhouettes of these mirrors, which are boundaries
//! themselves, so the field stays continuous.

use capwalk_geometry::topology::COPLANAR;
use capwalk_geometry::{ConeQuery, HalfSpace, Hit, Ray, Sight, SilhouettePoint};
use capwalk_math::{Real, Vec3, sphere};
use capwalk_scene::lobe::Event;
use capwalk_walk::{Domain, Nearest, Sphere};

use crate::accel::Accel;
use crate::boundary_sample::Seen;
use crate::field::Field;
use crate::mirror::{MAX_EVENTS, Mirror, Mirrors};
use crate::viewpoint::{Viewpoint, Visibility};

/// The sphere of directions around a viewpoint, bounded by edges and by their mirror
/// images.
pub struct ReflectedSphere<'a, R, F> {
    /// The sphere without mirror images.
    pub direct: Sphere<'a, F>,
    /// The scene and its boundaries.
    pub field: &'a Field<'a>,
    /// Its centre.
    pub viewpoint: &'a Viewpoint<R>,
}

/// A ray from a viewpoint, after the first events of a specular chain.
#[derive(Clone, Copy)]
struct SpecularRay {
    /// From the last event on.
    ray: Ray,
    /// The viewpoint, reflected at all mirrors of the chain; in the space of the tree.
    apex: Vec3,
    /// The direction `q`, reflected likewise.
    axis: Vec3,
    events: [Event; MAX_EVENTS as usize],
    mirrors: Mirrors,
    count: u32,
}

impl SpecularRay {
    fn events(&self) -> &[Event] {
        &self.events[..self.count as usize]
    }

    /// The ray after one more event at `hit`.
    fn after(&self, accel: &Accel, hit: &Hit, event: Event) -> Self {
        let mut next = *self;
        next.events[self.count as usize] = event;
        next.count += 1;
        let mut direction = self.ray.direction;
        if event == Event::Reflect {
            let mirror = Mirror::new(&accel.mesh, hit.face);
            direction = mirror.direction(direction);
            next.axis = direction;
            next.apex = mirror.point(self.apex);
            next.mirrors.push(hit.face);
        }
        next.ray = accel.surface_ray(self.ray.at(hit.t), direction);
        next
    }
}

/// How far, per mirror and as a fraction of the distance, a path traced to a point may
/// miss it and still arrive. Neighbouring faces of one mirror differ by up to
/// [`COPLANAR`], which turns the reflected ray by twice as much; as much again is for
/// rounding.
pub const SAME_MIRROR: f64 = 4.0 * COPLANAR;

impl<R: Real, F: Sight> ReflectedSphere<'_, R, F> {
    /// The ray before any event.
    fn first_ray(&self, direction: Vec3) -> SpecularRay {
        let viewpoint = self.viewpoint.position.value();
        SpecularRay {
            ray: match self.viewpoint.visibility {
                Visibility::Camera => self.field.accel.camera_ray(viewpoint, direction),
                Visibility::Surface | Visibility::All => {
                    self.field.accel.surface_ray(viewpoint, direction)
                }
            },
            apex: self.direct.origin,
            axis: direction,
            events: [Event::Pass; MAX_EVENTS as usize],
            mirrors: Mirrors::default(),
            count: 0,
        }
    }

    /// Replaces `best` by a boundary point that is closer to the direction `q` if there is
    /// one beyond the next specular surface of the chain, or beyond those after it. `limit`
    /// is in radians.
    fn search_behind(
        &self,
        specular: &SpecularRay,
        limit: f64,
        best: &mut Option<Nearest<Seen, Vec3>>,
    ) {
        let accel = self.field.accel;
        // Extend the chain by each specular event that the next surface has.
        let Some(hit) = accel.first_hit_within(&specular.ray) else {
            return;
        };
        for event in accel.flat_events(&hit).iter() {
            let is_parallel = self.viewpoint.axes.is_some();
            if is_parallel && event == Event::Reflect {
                continue; // such derivatives are refused
            }
            let behind = specular.after(accel, &hit, event);
            // Search around the reflected direction, on that side of the surface to which the
            // ray continues: only what is in front of a mirror is seen in it.
            let normal = accel.mesh.face_cross(hit.face as usize);
            let side = normal.dot(behind.ray.direction).signum();
            let query = ConeQuery {
                apex: behind.apex,
                axis: behind.axis,
                max_angle: best.map_or(limit, |nearest| nearest.distance),
                edges: self.direct.edges,
                groups: self.direct.groups,
                in_front_of: (!is_parallel).then_some(HalfSpace {
                    point: behind.ray.origin,
                    normal: normal * side,
                }),
            };
            self.direct.queries.set(self.direct.queries.get() + 1);
            let is_seen = |point: &SilhouettePoint| self.mirrors_towards(&behind, point).is_some();
            // Keep the closest edge point to which the specular chain leads.
            if let Some(point) = self.direct.tree.closest_where(&query, &is_seen) {
                let mirrors = self.mirrors_towards(&behind, &point);
                let direction = self.reflected_back(&behind, point.direction);
                *best = Some(Nearest {
                    site: Seen {
                        point: SilhouettePoint { direction, ..point },
                        mirrors: mirrors.expect("what is found is seen"),
                        is_direct: false,
                    },
                    point: direction,
                    distance: point.angle,
                });
            }
            // Follow the chain to the surface after this one.
            if behind.count < self.viewpoint.events {
                self.search_behind(&behind, limit, best);
            }
        }
    }

    /// A direction from the reflected apex as the viewpoint sees it: reflected at the mirrors
    /// of the chain, last to first.
    fn reflected_back(&self, specular: &SpecularRay, direction: Vec3) -> Vec3 {
        let faces = specular.mirrors.faces().iter().rev();
        faces.fold(direction, |direction, &face| {
            Mirror::new(&self.field.accel.mesh, face).direction(direction)
        })
    }

    /// The mirrors in which the viewpoint sees a point that was found from the reflected apex,
    /// possibly other faces of the same planes. `None` if no path with the events of this
    /// chain arrives there.
    fn mirrors_towards(&self, specular: &SpecularRay, point: &SilhouettePoint) -> Option<Mirrors> {
        let accel = self.field.accel;
        let direction = self.reflected_back(specular, point.direction);
        // Leave out what lies in the plane of the viewpoint's own face: seen edge-on it is no
        // discontinuity, and what a ray along the plane hits is decided by rounding.
        let height = |normal: Vec3| (direction.dot(normal) * point.distance).abs();
        let horizon = self.viewpoint.face_normal.map(height);
        if horizon.is_some_and(|height| height <= accel.horizon_distance()) {
            return None;
        }
        // Trace the path: each surface on the way must be hit before the point's distance is
        // used up, and must have the event of the chain.
        let (target, distance) = self.field.located(self.viewpoint, specular.apex, point);
        let mut trace = self.first_ray(direction);
        let mut left = distance;
        for &event in specular.events() {
            let hit = accel.first_hit_within(&trace.ray)?;
            if hit.t >= left || !accel.flat_events(&hit).contains(event) {
                return None;
            }
            left -= hit.t;
            trace = trace.after(accel, &hit, event);
        }
        // It must end at the point, and nothing may hide the point after the last event.
        let miss = trace.ray.at(left) - target;
        // Without mirrors the margin is for rounding alone.
        let reflections = trace.mirrors.faces().len().max(1) as f64;
        let arrives = miss.length() < SAME_MIRROR * reflections * distance;
        let sees = || accel.surface_sees(trace.ray.origin, trace.ray.direction, left);
        (arrives && sees()).then_some(trace.mirrors)
    }
}

impl<R: Real, F: Sight> Domain for ReflectedSphere<'_, R, F> {
    type Vector = Vec3;
    type Site = Seen;

    fn closest(&self, q: Vec3, limit: f64) -> Option<Nearest<Seen, Vec3>> {
        // The closest edge that is seen directly.
        let direct = self.direct.closest(q, limit);
        let mut best = direct.map(|nearest| Nearest {
            site: Seen {
                point: nearest.site,
                mirrors: Mirrors::default(),
                is_direct: true,
            },
            point: nearest.point,
            distance: nearest.distance,
        });
        // A reflected one takes its place if it is closer.
        if self.viewpoint.events > 0 {
            self.search_behind(&self.first_ray(q), limit, &mut best);
        }
        best
    }

    #[inline]
    fn radius_at(&self, q: Vec3, known: &Nearest<Seen, Vec3>) -> Option<f64> {
        Some(sphere::angle_between(q, known.point))
    }
    #[inline]
    fn growth(&self, q: Vec3, nearest: &Nearest<Seen, Vec3>) -> Vec3 {
        -sphere::tangent_towards(q, nearest.point)
    }
    #[inline]
    fn tangent(&self, q: Vec3, azimuth: f64) -> Vec3 {
        self.direct.tangent(q, azimuth)
    }
    #[inline]
    fn walk(&self, q: Vec3, e: Vec3, angle: f64) -> Vec3 {
        self.direct.walk(q, e, angle)
    }
    #[inline]
    fn radius_inside(&self, half_angle: f64, u: f64) -> f64 {
        self.direct.radius_inside(half_angle, u)
    }
    #[inline]
    fn rim_over_ball(&self, half_angle: f64) -> f64 {
        self.direct.rim_over_ball(half_angle)
    }
    #[inline]
    fn curvature(&self, q: Vec3) -> Vec3 {
        self.direct.curvature(q)
    }
}
