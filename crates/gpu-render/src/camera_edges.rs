//! The boundary term of the edges that the camera sees (METHOD 8), for derivatives with respect to
//! what moves.
//!
//! The processor draws points on edges with its own code, in double precision, and follows the rays
//! beside them to their first hits. The device follows the paths that go on from there, with the
//! kernels of images.

use capwalk_diff::Forward;
use capwalk_geometry::buffers::NONE;
use capwalk_geometry::ray::Ray;
use capwalk_math::Rgb;
use capwalk_render::tiles::SamplePlace;
use capwalk_render::{SceneEval, Tracer, Watch};
use capwalk_scene::sensor::view::ViewRay;
use rayon::prelude::*;

use crate::device_error::DeviceError;
use crate::device_scene::DeviceScene;
use crate::lobe_records::only_diffuse;
use crate::paths::Followed;
use crate::render_kernels::{DIFFUSE_IMAGE_FROM_HITS, IMAGE_FROM_HITS, PathKernels};
use crate::texture_records::float;
use crate::unsupported::Unsupported;

/// Words of a hit, as `hits.slang` reads them.
const HIT_WORDS: usize = 8;

/// The edges that the camera sees of a scene that moves.
pub struct CameraEdges<'a> {
    tracer: &'a Tracer<'a>,
    eval: &'a Forward<'a>,
    kernels: &'static PathKernels,
}

/// One that a sample has drawn.
struct DrawnEdge {
    /// The number of the sample.
    sample: usize,
    /// What the light behind the edge less that before it is multiplied by.
    factors: [f64; 2],
    /// What the rays behind it and before it hit.
    hits: [[u32; HIT_WORDS]; 2],
}

impl<'a> CameraEdges<'a> {
    /// Those that move; `None` if nothing moves against the camera's rays.
    pub fn new(tracer: &'a Tracer<'a>, eval: &'a Forward<'a>) -> Option<Self> {
        eval.moves().then(|| Self {
            tracer,
            eval,
            kernels: match only_diffuse(&tracer.accel.scene) {
                true => &DIFFUSE_IMAGE_FROM_HITS,
                false => &IMAGE_FROM_HITS,
            },
        })
    }

    /// What each of some samples adds to its derivative, with at most so many paths on the device at
    /// a time, at least two; `None` if the watch stopped the work.
    pub fn terms(
        &self,
        scene: &DeviceScene,
        places: &[SamplePlace],
        room: usize,
        watch: &dyn Watch,
    ) -> Result<Option<Vec<[f64; 3]>>, DeviceError> {
        // Draw the edges, and keep the samples that have one.
        let drawn = places.par_iter().enumerate();
        let drawn = drawn.filter_map(|(sample, place)| self.draw(sample, place).transpose());
        let drawn: Vec<DrawnEdge> = drawn.collect::<Result<_, Unsupported>>()?;
        let mut terms = vec![[0.0; 3]; places.len()];
        if drawn.is_empty() {
            return Ok(Some(terms));
        }
        // Follow the paths on both sides of as many as there is room for.
        let most = (room / 2).clamp(1, drawn.len());
        let paths = scene.paths(self.kernels, [2 * most, 0], &[], 0)?;
        for some in drawn.chunks(most) {
            let hits: Vec<_> = some.iter().flat_map(|edge| edge.hits).collect();
            let Followed::ToTheEnd(_) = paths.follow(hits.as_flattened(), watch)? else {
                return Ok(None);
            };
            let light = paths.numbers::<3>(2 * some.len())?;
            for (edge, sides) in some.iter().zip(light.as_chunks::<2>().0) {
                let [behind, before] = sides.map(|light| Rgb::from(light.map(f64::from)));
                let [weight, flow] = edge.factors;
                terms[edge.sample] = ((behind - before) * weight * flow).to_array();
            }
        }
        Ok(Some(terms))
    }

    /// Draws the edge of a sample, if it has one.
    fn draw(&self, sample: usize, place: &SamplePlace) -> Result<Option<DrawnEdge>, Unsupported> {
        let edge = self
            .tracer
            .camera_edge(self.eval, place.pixel, &place.stream);
        let edge = edge.map_err(|_| Unsupported {
            what: "mirrors have too many images".to_owned(),
        })?;
        Ok(edge.map(|edge| DrawnEdge {
            sample,
            factors: [edge.weight, edge.flow.tangent[0]],
            hits: edge.sides.map(|ray| self.hit(&ray, place)),
        }))
    }

    /// What a ray hits. The processor finds it, in double precision: both rays beside an edge have the
    /// same direction in single precision, so the device would see one surface along both.
    fn hit(&self, ray: &ViewRay<f64>, place: &SamplePlace) -> [u32; HIT_WORDS] {
        let [t_min, t_max] = ray.range;
        let hit = self.tracer.accel.first_hit_within(&Ray {
            origin: ray.origin,
            direction: ray.direction,
            t_min,
            t_max,
        });
        let (face, [v, w]) = hit.map_or((NONE, [0.0; 2]), |hit| (hit.face, hit.barycentric));
        let [x, y, z] = ray.direction.to_array().map(float);
        // The random numbers of the sample, on both sides: their noise cancels.
        let key = place.stream.independent_key().unwrap_or_default();
        [
            face,
            float(v),
            float(w),
            x,
            y,
            z,
            key as u32,
            (key >> 32) as u32,
        ]
    }
}
