//! A scene as the kernels read it: `layout.rs` says which word is what.

use capwalk_boundary::{Accel, tangents_of_face};
use capwalk_geometry::LocalFrame;
use capwalk_geometry::buffers::{NONE, RayBuffers, TRIANGLE};
use capwalk_geometry::ray::EDGE_ON;
use capwalk_gpu::Precision;
use capwalk_math::Vec3;
use capwalk_render::{Plan, PreparedScene};
use capwalk_scene::{EmitterId, Shape, ShapeId};

use crate::camera_records::CameraRecords;
use crate::emitter_records::emitter_record;
use crate::layout::header::*;
use crate::layout::record;
use crate::layout::shape::*;
use crate::layout::tests::{SELF_DISTANCE, TESTS};
use crate::layout::triangle::TRIANGLE_RECORD;
use crate::lobe_records::add_lobe;
use crate::texture_records::{Shown, TextureRecords, float, two_floats};

/// Which numbers of tests the kernels take, by precision: a triangle that is seen under a smaller
/// part of what its area is summed from is seen edge-on; nothing is larger; distances below this
/// from a surface belong to it (local units; in double precision the CPU's); and the part of
/// the way to an emitter in which anything may be.
const SINGLE_TESTS: [f64; TESTS] = [
    1.0 / (1 << 21) as f64,
    f32::MAX as f64,
    1.0 / (1 << 16) as f64,
    1.0 - 1.0 / (1 << 16) as f64,
];
const DOUBLE_TESTS: [f64; TESTS] = [EDGE_ON, f64::MAX, 0.0, 1.0 - 1e-9];

/// The arrays of a scene.
pub struct SceneRecords {
    /// The coordinates of everything.
    pub frame: LocalFrame,
    /// The nodes of the tree of triangles, where its leaves start, and the number of each triangle.
    pub nodes: Vec<u32>,
    pub leaf_starts: Vec<u32>,
    pub faces: Vec<u32>,
    /// Its triangles, in these coordinates, then the numbers of the camera and those of the tests.
    pub primitives: Vec<f64>,
    /// Everything else.
    pub words: Vec<u32>,
    /// The textures, by their numbers.
    pub textures: Vec<Shown>,
}

impl SceneRecords {
    /// The records of a scene of which nothing is unsupported.
    pub fn new(prepared: &PreparedScene, precision: Precision) -> Self {
        let (scene, accel) = (prepared.scene(), prepared.accel());
        let buffers = accel.rays().buffers();
        let frame = buffers.frame;
        let mut words = vec![0; HEADER];

        // Of each triangle its shape, and its face and vertices there.
        let triangles_at = words.len() as u32;
        for &face in &buffers.faces {
            let shape = accel.shape_of_face[face as usize].0;
            let face = face - accel.first_face[shape as usize];
            let vertices = scene.shapes[shape as usize].mesh.faces[face as usize];
            let [a, b, c] = vertices;
            let triangle: [u32; TRIANGLE_RECORD] = [shape, face, a, b, c];
            words.extend(triangle);
        }
        let triangle_of_face_at = words.len();
        words.resize(triangle_of_face_at + buffers.faces.len(), 0);
        for (triangle, &face) in (0..).zip(&buffers.faces) {
            words[triangle_of_face_at + face as usize] = triangle;
        }
        let mut textures = TextureRecords::default();
        let shapes = (0..scene.shapes.len()).map(|shape| {
            let shape = ShapeId(shape as u32);
            shape_record(accel, shape, &mut textures, &mut words)
        });
        let shapes: Vec<_> = shapes.collect();
        let shapes_at = append(shapes.as_flattened(), &mut words);
        let emitters: Vec<_> = (0..)
            .zip(prepared.emitters())
            .map(|(id, sampler)| {
                let id = EmitterId(id);
                emitter_record(accel, id, sampler, &frame, &mut textures, &mut words)
            })
            .collect();
        let emitters_at = append(emitters.as_flattened(), &mut words);

        let camera = CameraRecords::new(accel, &frame);
        let camera_at = append(&camera.words, &mut words);
        let numbers_of_camera_at = TRIANGLE * buffers.faces.len();

        let plan = Plan::new(scene);
        let sees_emitters = plan.reaches(1) && !plan.hide_emitters;
        let header: [u32; HEADER] = record(&[
            (MAX_DEPTH, plan.max_depth.unwrap_or(u32::MAX)),
            (RR_DEPTH, plan.rr_depth),
            (EMITTER_SAMPLES, plan.sampling.emitter_samples),
            (BSDF_SAMPLES, plan.sampling.bsdf_samples),
            (SEES_EMITTERS, sees_emitters.into()),
            (ALIKE, plan.sampling.alike.into()),
            (EMITTERS, emitters.len() as u32),
            (FIRST_VERTEX, plan.first_vertex),
            (
                ENVIRONMENT,
                scene.environment().map_or(NONE, |emitter| emitter.0),
            ),
            (TRIANGLES_AT, triangles_at),
            (SHAPES_AT, shapes_at),
            (EMITTERS_AT, emitters_at),
            (TRIANGLE_OF_FACE_AT, triangle_of_face_at as u32),
            (CAMERA_AT, camera_at),
            (CAMERA_NUMBERS_AT, numbers_of_camera_at as u32),
            (
                NUMBERS_AT,
                (numbers_of_camera_at + camera.numbers.len()) as u32,
            ),
        ]);
        words[..HEADER].copy_from_slice(&header);

        Self {
            frame,
            nodes: buffers.nodes,
            leaf_starts: buffers.leaf_starts,
            faces: buffers.faces,
            primitives: exact_numbers(accel, &camera, precision),
            words,
            textures: textures.shown,
        }
    }
}

/// The corners of all triangles, in the order of the tree's leaves and in its coordinates, the
/// numbers of the camera, and those of the tests.
pub fn exact_numbers(accel: &Accel, camera: &CameraRecords, precision: Precision) -> Vec<f64> {
    let RayBuffers {
        frame, triangles, ..
    } = accel.rays().buffers();
    let corners = triangles.as_chunks::<3>().0.iter();
    let corners = corners.flat_map(|&p| frame.local_from_world(p.into()).to_array());
    let mut numbers: Vec<f64> = corners.collect();
    numbers.extend(&camera.numbers);
    numbers.extend(match precision {
        Precision::Single => SINGLE_TESTS,
        Precision::Double => {
            let mut tests = DOUBLE_TESTS;
            tests[SELF_DISTANCE] = accel.horizon_distance() * frame.inverse_scale;
            tests
        }
    });
    numbers
}

/// Appends words, and returns where they start.
fn append(array: &[u32], words: &mut Vec<u32>) -> u32 {
    let at = words.len() as u32;
    words.extend(array);
    at
}

/// The record of a shape; what it refers to is appended.
fn shape_record(
    accel: &Accel,
    id: ShapeId,
    textures: &mut TextureRecords,
    words: &mut Vec<u32>,
) -> [u32; SHAPE_RECORD] {
    let shape = accel.scene.shape(id);
    let mut add = |numbers: &mut dyn Iterator<Item = u32>| {
        let at = words.len() as u32;
        words.extend(numbers);
        at
    };
    let normals = shape.normals.per_vertex().map_or(NONE, |normals| {
        add(&mut normals
            .iter()
            .flat_map(|normal| normal.to_array().map(float)))
    });
    let uvs = shape.uvs.as_ref().map_or(NONE, |uvs| {
        let numbers = uvs.as_flattened().as_flattened().iter();
        add(&mut numbers.copied().flat_map(two_floats))
    });
    let tangents = match accel.needs_tangent[id.0 as usize] {
        true => add(&mut tangents(shape).flat_map(|tangent| tangent.to_array().map(float))),
        false => NONE,
    };
    let [front, back] =
        [true, false].map(|is_front| add_lobe(accel, shape, is_front, textures, words));
    let emitter = shape.emitter.map_or(NONE, |emitter| emitter.0);
    let is_mirror = accel.is_flat_mirror(id).into();
    record(&[
        (NORMALS, normals),
        (UVS, uvs),
        (FRONT, front),
        (BACK, back),
        (EMITTER, emitter),
        (TANGENTS, tangents),
        (IS_MIRROR, is_mirror),
    ])
}

/// A unit vector along the first texture coordinate on each face; zero without usable ones.
fn tangents(shape: &Shape) -> impl Iterator<Item = Vec3> {
    (0..shape.mesh.faces.len()).map(|face| {
        let [a, b, c] = shape.mesh.corners(face);
        let along = tangents_of_face(shape, face, [b - a, c - a]);
        let unit = along.map(|[along_u, _]| along_u.normalized());
        unit.filter(|unit| unit.is_finite()).unwrap_or(Vec3::zero())
    })
}
