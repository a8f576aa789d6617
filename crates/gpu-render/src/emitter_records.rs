//! Emitters as the kernels read them: `layout.rs` says which word is what.

use capwalk_boundary::Accel;
use capwalk_geometry::LocalFrame;
use capwalk_geometry::buffers::NONE;
use capwalk_math::Vec3;
use capwalk_render::{DirectionSampler, EmitterSampler, RectangleSampler, TriangleSampler};
use capwalk_scene::{Emitter, EmitterId};

use crate::environment_records::add_environment_map;
use crate::layout::emitter::*;
use crate::layout::emitter_kind::*;
use crate::layout::emitter_node::NODE;
use crate::layout::record;
use crate::texture_records::{TextureRecords, float};

/// The record of an emitter; what it refers to is appended to `words`.
pub fn emitter_record(
    accel: &Accel,
    id: EmitterId,
    sampler: &EmitterSampler,
    frame: &LocalFrame,
    textures: &mut TextureRecords,
    words: &mut Vec<u32>,
) -> [u32; EMITTER_RECORD] {
    let scene = &accel.scene;
    let emitter: &Emitter = scene.emitter(id);
    let shape = emitter.shape().map(|shape| scene.shape(shape));
    let brightness = float(sampler.brightness);
    let surroundings = |kind: usize, radiance| {
        let mut words = [0; EMITTER_RECORD];
        words[EMITTER_KIND] = kind as u32;
        words[RADIANCE] = radiance;
        words[BRIGHTNESS] = brightness;
        words[RECTANGLE] = NONE;
        words
    };
    if let (
        Emitter::EnvironmentMap {
            map, data, scale, ..
        },
        DirectionSampler::Environment(table),
    ) = (emitter, &sampler.directions)
    {
        let texels = [*data, *scale];
        let map = add_environment_map(scene, map, texels, table, textures, words);
        return surroundings(ENVIRONMENT_MAP, map);
    }
    let radiance = textures.add(scene, emitter.radiance(), shape, words);
    let DirectionSampler::Area(triangles) = &sampler.directions else {
        return surroundings(CONSTANT_EMITTER, radiance);
    };
    let rectangle = triangles.rectangle();
    let rectangle = rectangle.map_or(NONE, |rectangle| add_rectangle(rectangle, frame, words));
    let nodes = add_nodes(triangles, frame, words);
    let order = words.len() as u32;
    words.extend(triangles.order());
    let rank = words.len();
    words.resize(rank + triangles.order().len(), 0);
    for (place, &face) in (0..).zip(triangles.order()) {
        words[rank + face as usize] = place;
    }
    let (centre, radius) = triangles.ball();
    let [x, y, z] = local(frame, centre);
    let first_face = accel.emitter_face(id, 0);
    let radius = float(radius * frame.inverse_scale);
    let rank = rank as u32;
    record(&[
        (EMITTER_KIND, AREA_EMITTER as u32),
        (RADIANCE, radiance),
        (BRIGHTNESS, brightness),
        (FIRST_FACE, first_face),
        (RECTANGLE, rectangle),
        (NODES, nodes),
        (ORDER, order),
        (RANK, rank),
        (CENTRE, x),
        (CENTRE + 1, y),
        (CENTRE + 2, z),
        (RADIUS, radius),
    ])
}

/// A place in the tree's coordinates.
fn local(frame: &LocalFrame, point: Vec3) -> [u32; 3] {
    frame.local_from_world(point).to_array().map(float)
}

fn add_rectangle(sampler: &RectangleSampler, frame: &LocalFrame, words: &mut Vec<u32>) -> u32 {
    let at = words.len() as u32;
    let rectangle = &sampler.rectangle;
    words.extend(local(frame, rectangle.corner));
    for v in rectangle.sides.into_iter().chain([rectangle.normal]) {
        words.extend(v.to_array().map(float));
    }
    words.extend(
        rectangle
            .lengths
            .map(|length| float(length * frame.inverse_scale)),
    );
    for [c, a, b] in sampler.weights.into_iter().flatten() {
        words.extend([c, a * frame.scale, b * frame.scale].map(float));
    }
    at
}

fn add_nodes(triangles: &TriangleSampler, frame: &LocalFrame, words: &mut Vec<u32>) -> u32 {
    let at = words.len() as u32;
    let to_area = frame.inverse_scale * frame.inverse_scale;
    for node in triangles.nodes() {
        let start = words.len();
        words.extend([node.places.start, node.places.end].map(|place| place as u32));
        words.extend(
            node.halves
                .map_or([NONE; 2], |halves| halves.map(|half| half as u32)),
        );
        words.extend(local(frame, node.centre));
        words.push(float(node.radius * frame.inverse_scale));
        words.extend((node.vector_area * to_area).to_array().map(float));
        words.push(float(node.area * to_area));
        words.extend(node.axis.to_array().map(float));
        words.extend([node.cos_spread, node.sin_spread].map(float));
        debug_assert_eq!(words.len(), start + NODE);
    }
    at
}
