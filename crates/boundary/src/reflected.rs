//! What is seen in flat mirrors and through panes (METHOD 6): edges seen there
//! are boundaries around the viewpoint, too, in the directions of their images.
//!
//! An image stays on the sphere around the viewpoint. From behind the mirror, where
//! the viewpoint's own image is, the edge itself is seen in the reflected direction
//! and at the image's distance: the query is the same with another viewpoint. Which
//! mirrors are looked into is decided by the direction; images that are seen
//! in other mirrors lie behind these mirrors' silhouettes, which are boundaries.

use capwalk_geometry::topology::COPLANAR;
use capwalk_geometry::{ConeQuery, HalfSpace, Hit, Ray, SilhouettePoint};
use capwalk_math::{Real, Vec3};
use capwalk_scene::lobe::Event;
use capwalk_walk::{Domain, Nearest, Sphere};

use crate::accel::Accel;
use crate::boundary_sample::Seen;
use crate::field::Field;
use crate::mirror::{MAX_EVENTS, Mirror, Mirrors};
use crate::viewpoint::{Viewpoint, Visibility};

/// The sphere of directions around a viewpoint, bounded by edges and their images.
pub struct ReflectedSphere<'a, R, F> {
    /// The edges that are seen without mirrors.
    pub direct: Sphere<'a, F>,
    /// The edges.
    pub field: &'a Field<'a>,
    /// Where they start.
    pub viewpoint: &'a Viewpoint<R>,
}

/// A ray on its way from a viewpoint through flat specular surfaces.
#[derive(Clone, Copy)]
struct SpecularRay {
    ray: Ray,
    /// The image of the viewpoint from where the ray seems to come, and in which direction
    /// of the edges' space.
    viewpoint: Vec3,
    axis: Vec3,
    events: [Event; MAX_EVENTS as usize],
    mirrors: Mirrors,
    count: u32,
}

impl SpecularRay {
    fn events(&self) -> &[Event] {
        &self.events[..self.count as usize]
    }

    /// The ray behind an event.
    fn after(&self, accel: &Accel, hit: &Hit, event: Event) -> Self {
        let mut next = *self;
        next.events[self.count as usize] = event;
        next.count += 1;
        let mut direction = self.ray.direction;
        if event == Event::Reflect {
            let mirror = Mirror::new(&accel.mesh, hit.face);
            direction = mirror.direction(direction);
            next.axis = direction;
            next.viewpoint = mirror.point(self.viewpoint);
            next.mirrors.push(hit.face);
        }
        next.ray = accel.surface_ray(self.ray.at(hit.t), direction);
        next
    }
}

/// Fraction of its distance by which each mirror may make the image of a point miss
/// the point, seen in another face of the same mirror: twice the angle between
/// faces without an edge between them, and as much again for rounding.
const SAME_MIRROR: f64 = 4.0 * COPLANAR;

impl<R: Real, F: Fn(&SilhouettePoint) -> bool> ReflectedSphere<'_, R, F> {
    fn first_ray(&self, direction: Vec3) -> SpecularRay {
        let viewpoint = self.viewpoint.position.value();
        SpecularRay {
            ray: match self.viewpoint.visibility {
                Visibility::Camera => self.field.accel.camera_ray(viewpoint, direction),
                Visibility::Surface | Visibility::All => {
                    self.field.accel.surface_ray(viewpoint, direction)
                }
            },
            viewpoint: self.direct.origin,
            axis: direction,
            events: [Event::Pass; MAX_EVENTS as usize],
            mirrors: Mirrors::default(),
            count: 0,
        }
    }

    /// Looks for images closer to a direction than the best point so far, behind
    /// what a ray hits.
    fn look_behind(&self, sight: &SpecularRay, limit: f64, best: &mut Option<Nearest<Seen, Vec3>>) {
        let accel = self.field.accel;
        let Some(hit) = accel.first_hit_within(&sight.ray) else {
            return;
        };
        for event in accel.flat_events(&hit).iter() {
            let is_parallel = self.viewpoint.axes.is_some();
            if is_parallel && event == Event::Reflect {
                continue; // What moves there is refused.
            }
            let behind = sight.after(accel, &hit, event);
            // Only what lies before a mirror is seen in it.
            let normal = accel.mesh.face_cross(hit.face as usize);
            let side = normal.dot(behind.ray.direction).signum();
            let query = ConeQuery {
                apex: behind.viewpoint,
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
            let is_seen = |point: &SilhouettePoint| self.mirrors_before(&behind, point).is_some();
            if let Some(point) = self.direct.tree.closest_where(&query, is_seen) {
                let mirrors = self.mirrors_before(&behind, &point);
                let direction = self.unfolded(&behind, point.direction);
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
            if behind.count < self.viewpoint.events {
                self.look_behind(&behind, limit, best);
            }
        }
    }

    /// A direction from the viewpoint's image as the viewpoint sees it.
    fn unfolded(&self, sight: &SpecularRay, direction: Vec3) -> Vec3 {
        let faces = sight.mirrors.faces().iter().rev();
        faces.fold(direction, |direction, &face| {
            Mirror::new(&self.field.accel.mesh, face).direction(direction)
        })
    }

    /// The mirrors in which a point found from the viewpoint's image is seen by the viewpoint:
    /// faces of the planes that were looked into. `None` if it is hidden.
    fn mirrors_before(&self, sight: &SpecularRay, point: &SilhouettePoint) -> Option<Mirrors> {
        let accel = self.field.accel;
        let direction = self.unfolded(sight, point.direction);
        // What lies in the plane of the viewpoint's own face is seen edge-on: nothing jumps,
        // and whether a ray along the plane meets something is a matter of rounding.
        let height = |normal: Vec3| (direction.dot(normal) * point.distance).abs();
        let horizon = self.viewpoint.face_normal.map(height);
        if horizon.is_some_and(|height| height <= accel.horizon_distance()) {
            return None;
        }
        let (target, distance) = self.field.located(self.viewpoint, sight.viewpoint, point);
        let mut trace = self.first_ray(direction);
        let mut left = distance;
        for &event in sight.events() {
            let hit = accel.first_hit_within(&trace.ray)?;
            if hit.t >= left || !accel.flat_events(&hit).contains(event) {
                return None;
            }
            left -= hit.t;
            trace = trace.after(accel, &hit, event);
        }
        let miss = trace.ray.at(left) - target;
        // Without mirrors it is there up to rounding.
        let reflections = trace.mirrors.faces().len().max(1) as f64;
        let is_there = miss.length() < SAME_MIRROR * reflections * distance;
        let sees = || accel.surface_sees(trace.ray.origin, trace.ray.direction, left);
        (is_there && sees()).then_some(trace.mirrors)
    }
}

impl<R: Real, F: Fn(&SilhouettePoint) -> bool> Domain for ReflectedSphere<'_, R, F> {
    type Vector = Vec3;
    type Site = Seen;

    fn closest(&self, q: Vec3, limit: f64) -> Option<Nearest<Seen, Vec3>> {
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
        if self.viewpoint.events > 0 {
            self.look_behind(&self.first_ray(q), limit, &mut best);
        }
        best
    }

    #[inline]
    fn distance(&self, q: Vec3, y: Vec3) -> f64 {
        self.direct.distance(q, y)
    }
    #[inline]
    fn towards(&self, q: Vec3, y: Vec3) -> Vec3 {
        self.direct.towards(q, y)
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
