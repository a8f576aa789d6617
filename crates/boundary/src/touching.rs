//! Edges of a shape that lie on a face of another one and move off it, or off its border within its
//! plane: there, an image has no derivative. To one side of the motion a gap opens, to the other the
//! shapes cross or overlap.

use std::collections::BTreeSet;

use capwalk_geometry::Halt;
use capwalk_math::Vec3;
use capwalk_scene::{ShapeId, Tangent};
use rayon::prelude::*;

use crate::accel::Accel;
use crate::beside::surfaces_at;
use crate::boundaries::Boundaries;

/// Where on an edge it is looked at, as parts of its length.
const PLACES: [f64; 3] = [0.2, 0.5, 0.8];
/// How far around an edge, as a part of its length.
const AROUND: f64 = 1e-5;
/// Cosine of the angle between two directions that are one up to rounding.
const ALONG: f64 = 1.0 - 1e-9;
/// Part of the largest velocity by which something moves that is no rounding.
const MOVES: f64 = 1e-6;

/// Pairs of shapes, by their indices: an edge of the first lies on the second and moves off it or, in
/// one plane, off its border; some of them if the work is given up.
pub fn touching(
    accel: &Accel,
    boundaries: &Boundaries,
    tangent: &Tangent,
    halt: &Halt,
) -> BTreeSet<[usize; 2]> {
    let edges = (0..boundaries.edges().len() as u32).into_par_iter();
    edges
        .filter(|_| !halt.now())
        .flat_map_iter(|edge| left_by(accel, boundaries, tangent, edge))
        .collect()
}

/// The pairs of one edge: the shape that it belongs to, and another one that it lies on and leaves.
fn left_by(
    accel: &Accel,
    boundaries: &Boundaries,
    tangent: &Tangent,
    edge: u32,
) -> Vec<[usize; 2]> {
    let vertices = boundaries.edge(edge).vertices;
    let mesh = &accel.mesh;
    // Lines of textures and shadows, and crossings, are no edges of a mesh.
    if vertices.iter().any(|&i| i as usize >= mesh.positions.len()) {
        return Vec::new();
    }
    let own = accel.shape_of_vertex(vertices[0]);
    let velocity = |vertex: u32| {
        let shape = accel.shape_of_vertex(vertex).0 as usize;
        let local = (vertex - accel.first_vertex[shape]) as usize;
        let moving = tangent.shapes[shape].as_ref();
        moving.map_or(Vec3::zero(), |vectors| vectors.vertices[local])
    };
    let [a, b] = boundaries.ends(edge);
    let ends = vertices.map(velocity);
    let mut found = Vec::new();
    for part in PLACES {
        let point = a + (b - a) * part;
        let reach = AROUND * (b - a).length();
        let surfaces = surfaces_at(accel, point, b - a, reach);
        let leaves = |shape: ShapeId| {
            let of_shape = surfaces
                .iter()
                .filter(move |(face, _)| accel.shape_of_face[*face as usize] == shape);
            of_shape.map(|&(_, direction)| direction)
        };
        for &(face, direction) in &surfaces {
            let other = accel.shape_of_face[face as usize];
            if other == own {
                continue;
            }
            let normal = mesh.face_cross(face as usize).normalized();
            let lies = [a, b].map(|end| normal.dot(end - point).abs());
            let weights = mesh.weights_on_face(face as usize, point);
            let corners = mesh.faces[face as usize].map(velocity);
            let below = corners.iter().zip(weights);
            let below = below.fold(Vec3::zero(), |sum, (&v, weight)| sum + v * weight);
            let above = ends[0] * (1.0 - part) + ends[1] * part;
            let speeds = corners.iter().chain(&ends).map(|v| v.length());
            let fastest = speeds.fold(0.0, f64::max);
            let moves = |axis: Vec3| axis.dot(above - below).abs() > MOVES * fastest;
            // Of two borders in one plane, one goes on where the other ends.
            let goes_on = |shape| leaves(shape).any(|d| d.dot(direction) < -ALONG);
            let is_border = goes_on(own) && !goes_on(other);
            if lies
                .iter()
                .all(|&height| height <= accel.horizon_distance())
                && (moves(normal) || (is_border && moves(direction)))
            {
                found.push([own, other].map(|shape| shape.0 as usize));
            }
        }
    }
    found
}
