//! `to_world`: matrices of four rows that put shapes and the sensor in the world.

use capwalk_math::{Affine, Vec3};

use crate::scene_vector::{SensorVectors, ShapeVectors};
use crate::shape::{ShadingNormals, Shape, vertex_normals};

/// The numbers of a matrix, row by row.
pub(super) fn numbers(map: &Affine) -> Vec<f64> {
    let mut numbers = rows(map.rows, map.translation);
    numbers[15] = 1.0;
    numbers
}

/// Three rows of numbers that each end with one of the translation's, and a row
/// of zeros.
fn rows(rows: [Vec3; 3], translation: Vec3) -> Vec<f64> {
    let mut numbers = Vec::with_capacity(16);
    for (i, row) in rows.iter().enumerate() {
        numbers.extend([row.x, row.y, row.z, translation[i]]);
    }
    numbers.extend([0.0; 4]);
    numbers
}

/// The first three rows of a matrix.
pub(super) fn affine(numbers: &[f64]) -> Affine {
    let row = |i: usize| Vec3::new(numbers[4 * i], numbers[4 * i + 1], numbers[4 * i + 2]);
    Affine {
        rows: [row(0), row(1), row(2)],
        translation: Vec3::new(numbers[3], numbers[7], numbers[11]),
    }
}

/// Which of the numbers cannot be, and what is expected instead: the last row is
/// `0 0 0 1`, the matrix can be inverted and mirrors only if `old` does.
pub(super) fn refusal(numbers: &[f64], old: &Affine) -> Option<(usize, &'static str)> {
    let last = [0.0, 0.0, 0.0, 1.0];
    if let Some(i) = (0..4).find(|&i| numbers[12 + i] != last[i]) {
        return Some((12 + i, "a last row of 0, 0, 0, 1"));
    }
    let determinant = affine(numbers).determinant();
    let is_right = determinant * old.determinant() > 0.0 && determinant.is_finite();
    (!is_right).then_some((
        0,
        "a matrix that can be inverted, and mirrors if the old one does",
    ))
}

/// The motion of a shape whose matrix changes at these velocities: its vertices
/// stay where they are in the space that it is put into the world from.
pub(super) fn shape_vectors(shape: &Shape, velocities: &[f64]) -> ShapeVectors {
    let (rate, object_from_world) = (affine(velocities), object_from_world(shape));
    let positions = shape.mesh.positions.iter();
    ShapeVectors {
        vertices: positions
            .map(|&p| rate.point(object_from_world.point(p)))
            .collect(),
        normals: match &shape.normals {
            ShadingNormals::Given(normals) => {
                // A normal n goes with the inverse transpose: ṅ = -(Ṁ M⁻¹)ᵀ n, and
                // stays unit.
                let turn = |&n: &Vec3| {
                    let rows = rate.rows.iter().enumerate();
                    let pulled = rows.fold(Vec3::zero(), |sum, (i, &row)| sum + row * n[i]);
                    let [a, b, c] = object_from_world.rows;
                    let moved = a * pulled.x + b * pulled.y + c * pulled.z;
                    (-moved).reject_from(n)
                };
                Some(normals.iter().map(turn).collect())
            }
            ShadingNormals::Face | ShadingNormals::Computed(_) => None,
        },
    }
}

/// The transpose of [`shape_vectors`].
pub(super) fn shape_gradient(shape: &Shape, covectors: &ShapeVectors) -> Vec<f64> {
    let object_from_world = object_from_world(shape);
    let (mut linear, mut translation) = ([Vec3::zero(); 3], Vec3::zero());
    for (&p, &covector) in shape.mesh.positions.iter().zip(&covectors.vertices) {
        let local = object_from_world.point(p);
        for (i, row) in linear.iter_mut().enumerate() {
            *row += local * covector[i];
        }
        translation += covector;
    }
    if let (ShadingNormals::Given(normals), Some(covectors)) = (&shape.normals, &covectors.normals)
    {
        for (&n, covector) in normals.iter().zip(covectors) {
            let local = object_from_world.vector(covector.reject_from(n));
            for (i, row) in linear.iter_mut().enumerate() {
                *row += local * -n[i];
            }
        }
    }
    rows(linear, translation)
}

/// Puts a shape into the world by another matrix.
pub(super) fn place(shape: &mut Shape, world_from_object: Affine) {
    let change = world_from_object * object_from_world(shape);
    for position in &mut shape.mesh.positions {
        *position = change.point(*position);
    }
    match &mut shape.normals {
        ShadingNormals::Face => {}
        ShadingNormals::Given(normals) => normals
            .iter_mut()
            .for_each(|n| *n = change.normal(*n).normalized()),
        ShadingNormals::Computed(normals) => {
            *normals = vertex_normals(&shape.mesh.positions, &shape.mesh.faces);
        }
    }
    shape.world_from_object = world_from_object;
}

fn object_from_world(shape: &Shape) -> Affine {
    let inverse = shape.world_from_object.inverse();
    inverse.expect("checked with the scene, and whenever it is set")
}

/// The motion of a sensor whose matrix changes at these velocities.
pub(super) fn sensor_vectors(velocities: &[f64]) -> SensorVectors {
    let rate = affine(velocities);
    SensorVectors {
        translation: rate.translation,
        axes: [0, 1, 2].map(|i| Vec3::from(rate.rows.map(|row| row[i]))),
        ..SensorVectors::default()
    }
}

/// The transpose of [`sensor_vectors`].
pub(super) fn sensor_gradient(covectors: &SensorVectors) -> Vec<f64> {
    let row = |i: usize| Vec3::from(covectors.axes.map(|axis| axis[i]));
    rows([row(0), row(1), row(2)], covectors.translation)
}
