//! The disk and the flower of figure 12, and how far a shape is from the flower.

use std::f64::consts::TAU;

use capwalk_geometry::Mesh;
use capwalk_math::Vec3;
use capwalk_scene::{Film, Filter, Scene, ShadingNormals, builtin};

use crate::settings::Failure;

/// Vertices of the rim; each has two unknowns.
pub const RIM: usize = 25;
/// Radius of the disk, and how far the flower's contour is from it.
const RADIUS: f64 = 0.45;
const PETALS: f64 = 0.13;

/// The middle of the disk.
const CENTRE: Vec3 = Vec3::new(0.02, 1.6, 0.03);

/// The contour at a vertex: a disk, or a flower with five petals.
fn radius(vertex: usize, flower: bool) -> f64 {
    let angle = TAU * vertex as f64 / RIM as f64;
    match flower {
        true => RADIUS + PETALS * (5.0 * angle).cos(),
        false => RADIUS,
    }
}

/// The scene `leaf` with a fan of triangles in the leaf's place, level above the
/// floor.
pub fn scene(flower: bool, size: [u32; 2]) -> Result<Scene, Failure> {
    let missing = || Failure::Unusable("the built-in scene leaf has no leaf".into());
    let mut scene = builtin::scene("leaf").ok_or_else(missing)?;
    let leaf = scene.shapes_mut().find(|shape| shape.id == "leaf");
    let rim = (0..RIM).map(|i| {
        let (sin, cos) = (TAU * (i as f64 + 0.2) / RIM as f64).sin_cos();
        CENTRE + Vec3::new(cos, 0.0, sin) * radius(i, flower)
    });
    let last = RIM as u32;
    let shape = leaf.ok_or_else(missing)?;
    shape.mesh = Mesh {
        positions: rim.chain([CENTRE]).collect(),
        faces: (0..last).map(|i| [last, (i + 1) % last, i]).collect(),
    };
    shape.normals = ShadingNormals::Face;
    scene.film = Film::new(size[0], size[1], Filter::Box);
    Ok(scene)
}

/// Points along each axis at which contours are compared.
const RASTER: usize = 512;

/// The area that only one of two contours encloses, of the found shape and the
/// flower, over the same for the disk and the flower. Vertices that slide along
/// the contour leave the shape as it is.
pub fn shape_error(found: &Scene, size: [u32; 2]) -> Result<f64, Failure> {
    let flower = rim(&scene(true, size)?);
    let apart = |contour: &[[f64; 2]]| {
        let side = |i: usize| 4.0 * RADIUS * ((i as f64 + 0.5) / RASTER as f64 - 0.5);
        let points = (0..RASTER * RASTER).map(|i| [side(i % RASTER), side(i / RASTER)]);
        points
            .filter(|&p| encloses(contour, p) != encloses(&flower, p))
            .count() as f64
    };
    Ok(apart(&rim(found)) / apart(&rim(&scene(false, size)?)))
}

/// The rim of the leaf seen from above, around the middle of the disk.
fn rim(scene: &Scene) -> Vec<[f64; 2]> {
    let leaf = scene.shapes.iter().find(|shape| shape.id == "leaf");
    let positions = leaf.map_or(&[][..], |leaf| &leaf.mesh.positions[..RIM]);
    positions
        .iter()
        .map(|p| [p.x - CENTRE.x, p.z - CENTRE.z])
        .collect()
}

/// The mean distance of the rim's vertices from the flower's, over that of the disk's.
/// It does not vanish where a shape does not depend on where along its contour the
/// vertices are.
pub fn vertex_distance(found: &Scene, size: [u32; 2]) -> Result<f64, Failure> {
    let flower = rim(&scene(true, size)?);
    let sum = |contour: &[[f64; 2]]| -> f64 {
        let pairs = contour.iter().zip(&flower);
        pairs.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1])).sum()
    };
    Ok(sum(&rim(found)) / sum(&rim(&scene(false, size)?)))
}

/// True if a closed contour runs around a point, an odd number of times.
fn encloses(contour: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let next = contour.iter().cycle().skip(1);
    let crossed = contour.iter().zip(next).filter(|&(a, b)| {
        (a[1] > y) != (b[1] > y) && x < a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1])
    });
    crossed.count() % 2 == 1
}
