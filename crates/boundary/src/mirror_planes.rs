//! The planes of the flat mirrors of a scene: faces of one plane make one image.

use std::collections::HashMap;

use capwalk_geometry::Mesh;
use capwalk_math::Vec3;

use crate::mirror::Mirror;
use crate::motion::Motion;

/// The most planes of mirrors of which images are made: all of them are looked at in each pixel.
const MOST_PLANES: usize = 256;

/// Faces whose normals differ by less are one mirror, if their heights differ by less of their
/// coordinates than [`SAME_HEIGHT`]: more than rounding, and far less than rays beside an edge are
/// apart. Those that are not, make images by each.
const SAME_PLANE: f64 = 1e-12;
const SAME_HEIGHT: f64 = 1e-13;

/// No plane.
const NONE: u32 = u32::MAX;

/// The planes of all flat mirrors of a scene.
#[derive(Clone, Debug)]
pub struct MirrorPlanes {
    pub(crate) planes: Vec<Plane>,
    /// The plane of each face, or [`NONE`].
    plane_of_face: Vec<u32>,
}

/// The plane of some flat mirrors.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    /// One of its faces.
    pub(crate) face: u32,
    /// That face as a mirror.
    pub(crate) mirror: Mirror,
    /// The box around its mirrors.
    pub(crate) bounds: [Vec3; 2],
}

impl Plane {
    /// True if no part of the box is on the inner side of the plane through a point.
    pub(crate) fn is_outside(&self, point: Vec3, inner: Vec3) -> bool {
        let [low, high] = self.bounds;
        let (centre, half) = ((low + high) * 0.5, (high - low) * 0.5);
        let reach = half.x * inner.x.abs() + half.y * inner.y.abs() + half.z * inner.z.abs();
        let margin = SAME_PLANE * (centre - point).length();
        inner.dot(centre - point) + reach < -margin
    }

    /// False if a cone around an axis, with this cosine and sine of its half angle, which is at most a right
    /// one, certainly has no direction to its mirrors; tested by the ball around their box.
    pub(crate) fn may_be_in_cone(&self, apex: Vec3, axis: Vec3, [cos, sin]: [f64; 2]) -> bool {
        let [low, high] = self.bounds;
        let offset = (low + high) * 0.5 - apex;
        // Larger by what faces of one mirror may differ. Rounding is less than by what cones are wider than asked for.
        let radius = 0.5 * (high - low).length() + SAME_PLANE * offset.length();
        // The ball is seen in a cone of its own, whose cosine and sine these are times the distance. Outside is what
        // is seen under more than the sum of both angles.
        let own_cos = (offset.length_squared() - radius * radius).sqrt();
        let is_outside = axis.dot(offset) < cos * own_cos - sin * radius;
        !is_outside
    }

    /// How large its mirrors look from a point, roughly: at most 1, above 0.
    pub(crate) fn size_from(&self, point: Vec3) -> f64 {
        let [low, high] = self.bounds;
        let squared = 0.25 * (high - low).length_squared();
        squared / (squared + ((low + high) * 0.5 - point).length_squared())
    }
}

impl MirrorPlanes {
    /// How many there are.
    pub fn count(&self) -> usize {
        self.planes.len()
    }

    /// True if a face lies in the plane of this number.
    pub(crate) fn has(&self, plane: u32, face: u32) -> bool {
        self.plane_of_face[face as usize] == plane
    }

    /// The planes of the faces that reflect; `None` if there are very many.
    pub(crate) fn new(mesh: &Mesh, reflects: impl Fn(u32) -> bool) -> Option<Self> {
        let mut planes: Vec<Plane> = Vec::new();
        let mut plane_of_face = vec![NONE; mesh.faces.len()];
        // Most faces lie in a plane of those before them: look in the cell of the first normal.
        let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
        for face in 0..mesh.faces.len() as u32 {
            let cross = mesh.face_cross(face as usize);
            if !reflects(face) || cross == Vec3::zero() {
                continue;
            }
            let mirror = Mirror::new(mesh, face);
            let corners = mesh.corners(face as usize);
            // Both sides of a mirror are one plane: of both normals, that one is looked up of which
            // the first coordinate that is not small is positive.
            let coordinates = [mirror.normal.x, mirror.normal.y, mirror.normal.z];
            let first = coordinates.into_iter().find(|x| x.abs() > 1e-3);
            let side = first.unwrap_or_default().signum();
            let key = coordinates.map(|x| (side * x * CELLS).round() as i64);
            let is_same = |&&plane: &&u32| {
                let plane = &planes[plane as usize].mirror;
                let turned = plane.normal.cross(mirror.normal).length() < SAME_PLANE;
                let is_near = |&p: &Vec3| plane.height(p).abs() <= SAME_HEIGHT * p.length();
                turned && corners.iter().all(is_near)
            };
            let known = cells.get(&key).and_then(|known| known.iter().find(is_same));
            let plane = match known {
                Some(&plane) => plane,
                None if planes.len() == MOST_PLANES => return None,
                None => {
                    let plane = planes.len() as u32;
                    planes.push(Plane {
                        face,
                        mirror,
                        bounds: [corners[0]; 2],
                    });
                    cells.entry(key).or_default().push(plane);
                    plane
                }
            };
            plane_of_face[face as usize] = plane;
            let bounds = &mut planes[plane as usize].bounds;
            for corner in corners {
                *bounds = [bounds[0].min(corner), bounds[1].max(corner)];
            }
        }
        Some(Self {
            planes,
            plane_of_face,
        })
    }

    /// How fast, at most, vertices of each plane leave the plane against how the one of its faces
    /// moves that stands for it, as far as sampling weights know: faces of one plane may move
    /// apart, and be of several shapes.
    pub fn spreads(&self, mesh: &Mesh, vertex: impl Fn(u32) -> Motion) -> Vec<f64> {
        let mut spreads = vec![0.0_f64; self.planes.len()];
        for (face, &number) in self.plane_of_face.iter().enumerate() {
            let Some(plane) = self.planes.get(number as usize) else {
                continue;
            };
            // The velocity of the face that stands for the plane along its normal is linear.
            let (own, normal) = (mesh.faces[plane.face as usize], plane.mirror.normal);
            let height = |p: Vec3| {
                let weights = own.iter().zip(mesh.weights_on_face(plane.face as usize, p));
                let speeds = weights.map(|(&i, weight)| weight * vertex(i).velocity.dot(normal));
                speeds.sum::<f64>()
            };
            let spread = &mut spreads[number as usize];
            for (i, p) in mesh.faces[face].into_iter().zip(mesh.corners(face)) {
                let motion = vertex(i);
                let apart = (motion.velocity.dot(normal) - height(p)).abs();
                // Rounding is no motion.
                let is_apart = apart > ROUNDING * motion.velocity.length();
                let apart = if is_apart { apart } else { 0.0 };
                *spread = spread.max(apart + motion.spread);
            }
        }
        spreads
    }
}

/// Speeds that differ by less of themselves are equal.
const ROUNDING: f64 = 1e-9;

/// Cells of normals per unit: two normals of one plane may be in different ones, and make a
/// plane twice.
const CELLS: f64 = 1e3;
