//! Rays that leave a surface after a perfectly specular event. About an interpolated or mapped normal a ray can be reflected
//! or refracted to the wrong side of its face: it dips. The smooth surface that the mesh stands for has no such rays. So
//! one that dips passes through the far side of its own shape, and goes on behind it: what is seen in a convex mirror is
//! then continuous up to its silhouette (method 6).

use capwalk_geometry::{Hit, Ray};
use capwalk_math::Vec3;
use capwalk_scene::lobe::Event;
use capwalk_scene::outside;

use crate::Accel;

/// The most coplanar faces that are followed.
const MOST_FACES: u32 = 16;
/// The largest sine of the angle between faces in one plane.
const COPLANAR: f64 = 1e-9;

/// The face that a ray leaves, and to which side.
#[derive(Clone, Copy, Debug)]
pub struct Leaving {
    face: u32,
    /// Unit normal of the face on that side.
    normal: Vec3,
}

impl Leaving {
    /// How a ray leaves a face after an event there. `face_normal` is its unit normal on the viewer's side.
    #[inline]
    pub fn after(event: Event, face: u32, face_normal: Vec3) -> Self {
        let normal = match event {
            Event::Reflect => face_normal,
            Event::Transmit | Event::Pass => -face_normal,
        };
        Self { face, normal }
    }

    /// The unit normal of the face on the side that it leaves to.
    pub fn normal(&self) -> Vec3 {
        self.normal
    }

    /// True if a ray in this direction is on the wrong side of the face.
    #[inline]
    pub fn dips(&self, direction: Vec3) -> bool {
        self.normal.dot(direction) <= 0.0
    }
}

impl Accel {
    /// The ray from a point of the face, which begins behind the far side of its shape if it dips and passes through that.
    #[inline]
    pub fn ray_leaving(&self, leaving: &Leaving, origin: Vec3, direction: Vec3) -> Ray {
        let ray = self.surface_ray(origin, direction);
        match leaving.dips(direction) {
            true => self.passing(leaving, ray),
            false => ray,
        }
    }

    /// [`Self::surface_sees`] along a ray that leaves a face.
    pub fn sees_leaving(
        &self,
        leaving: &Leaving,
        from: Vec3,
        direction: Vec3,
        distance: f64,
    ) -> bool {
        self.is_free(self.ray_leaving(leaving, from, direction), distance)
    }

    /// A ray that dips, from behind the far side of its shape if that is what it meets first.
    fn passing(&self, leaving: &Leaving, ray: Ray) -> Ray {
        match self.first_hit_within(&ray) {
            Some(hit) if self.is_far_side(leaving, &hit, ray.direction) => Ray {
                t_min: hit.t + ray.t_min,
                ..ray
            },
            _ => ray,
        }
    }

    /// True if the ray comes back there, through its own shape, to the side to which it leaves the face.
    fn is_far_side(&self, leaving: &Leaving, hit: &Hit, direction: Vec3) -> bool {
        let shape_of = |face: u32| self.shape_of_face[face as usize];
        let side = leaving.normal.dot(self.outward(leaving.face));
        shape_of(hit.face) == shape_of(leaving.face)
            && direction.dot(self.outward(hit.face)) * side > 0.0
    }

    /// True if a ray that dips sees the same as rays beside it that do not, as far as is known: if nothing but the far side
    /// of its shape is before it, and the shape does not rise where a ray along the face leaves this.
    pub fn dips_continuously(&self, leaving: &Leaving, origin: Vec3, direction: Vec3) -> bool {
        let hit = self.first_hit(origin, direction);
        hit.is_none_or(|hit| self.is_far_side(leaving, &hit, direction))
            && self.falls_away(leaving, origin, direction)
    }

    /// True if the shape goes on below the plane of the face, or ends, where a ray along the face leaves this.
    fn falls_away(&self, leaving: &Leaving, origin: Vec3, direction: Vec3) -> bool {
        let way = direction.reject_from(leaving.normal);
        let (mut face, mut origin) = (leaving.face, origin);
        for _ in 0..MOST_FACES {
            let Some((place, ends)) = self.leaves_at(face, leaving.normal, origin, way) else {
                return false;
            };
            let Some((next, opposite)) = self.neighbour(face, ends) else {
                return true;
            };
            let height = (opposite - place).dot(leaving.normal);
            if height.abs() > COPLANAR * (opposite - place).length() {
                return height < 0.0;
            }
            (face, origin) = (next, place);
        }
        false
    }

    /// Where a ray in the plane of a face leaves this, and the ends of the edge there.
    fn leaves_at(
        &self,
        face: u32,
        normal: Vec3,
        origin: Vec3,
        way: Vec3,
    ) -> Option<(Vec3, [Vec3; 2])> {
        let corners = self.mesh.corners(face as usize);
        let edges = [0, 1, 2].map(|i| [corners[i], corners[(i + 1) % 3]]);
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        let distance = |&[a, b]: &[Vec3; 2]| {
            let across = (b - a).cross(normal);
            let outward = across * (a - middle).dot(across).signum();
            let speed = way.dot(outward);
            (speed > 0.0).then(|| (a - origin).dot(outward) / speed)
        };
        let crossed = edges
            .iter()
            .filter_map(|edge| Some((distance(edge)?, edge)));
        let (t, &ends) = crossed.min_by(|(a, _), (b, _)| a.total_cmp(b))?;
        Some((origin + way * t, ends))
    }

    /// Another face of the same shape with an edge, and its other corner.
    fn neighbour(&self, face: u32, ends: [Vec3; 2]) -> Option<(u32, Vec3)> {
        let id = self.shape_of_face[face as usize].0 as usize;
        let first = self.first_face[id];
        let count = self.scene.shapes[id].mesh.faces.len() as u32;
        (first..first + count).filter(|&i| i != face).find_map(|i| {
            let corners = self.mesh.corners(i as usize);
            let mut others = corners.into_iter().filter(|corner| !ends.contains(corner));
            let other = others.next()?;
            others.next().is_none().then_some((i, other))
        })
    }

    /// The normal of a face on the outside of its shape, with the length of twice its area: normals given with a mesh
    /// say which side that is, even against the winding.
    fn outward(&self, face: u32) -> Vec3 {
        let cross = self.mesh.face_cross(face as usize);
        let id = self.shape_of_face[face as usize];
        let Some(normals) = self.scene.shape(id).normals.per_vertex() else {
            return cross;
        };
        let first = self.first_vertex[id.0 as usize];
        let corners = self.mesh.faces[face as usize];
        cross * outside(corners.map(|i| normals[(i - first) as usize]), cross)
    }
}
