//! The boundary term of the edges that the camera sees (METHOD 8), for derivatives with respect to
//! what moves.
//!
//! The CPU draws points on edges with its own code, in double precision, and follows the rays
//! beside them to their first hits. The device follows the paths that go on from there, with the
//! kernels of images.

use capwalk_geometry::buffers::NONE;
use capwalk_geometry::ray::Ray;
use capwalk_math::Rgb;
use capwalk_render::SamplePlace;
use capwalk_render::{CameraEdge, SampleRange, TooManyImages, Tracer, Watch};
use capwalk_scene::sensor::view::ViewRay;
use rayon::prelude::*;

use crate::device_error::DeviceError;
use crate::device_scene::DeviceScene;
use crate::layout::hit::*;
use crate::layout::record;
use crate::lobe_records::only_diffuse;
use crate::paths::Followed;
use crate::render_kernels::{DIFFUSE_IMAGE_FROM_HITS, IMAGE_FROM_HITS, PathKernels};
use crate::texture_records::two_floats;
use crate::unsupported::Unsupported;

/// The edges that the camera sees of a scene that moves.
pub struct CameraEdges<'a> {
    tracer: &'a Tracer<'a>,
    kernels: &'static PathKernels,
}

/// One that a sample has drawn.
pub struct DrawnEdge<T> {
    /// The number of the sample.
    pub sample: usize,
    /// How the flow across it changes.
    pub flow: T,
    /// The light behind the edge less that before it, times the weight of the point in the pixel.
    pub discontinuity: Rgb,
}

impl<'a> CameraEdges<'a> {
    /// Those that rays of a tracer see.
    pub fn new(tracer: &'a Tracer<'a>) -> Self {
        Self {
            tracer,
            kernels: match only_diffuse(&tracer.accel.scene) {
                true => &DIFFUSE_IMAGE_FROM_HITS,
                false => &IMAGE_FROM_HITS,
            },
        }
    }

    /// The edges of some samples, of each one or none, with at most so many paths on the device at a
    /// time, at least two; `None` if the watch stopped the work. `draw` draws the edge of a sample,
    /// and says how its flow changes.
    pub fn of<T: Send>(
        &self,
        scene: &DeviceScene,
        samples: &SampleRange,
        draw: impl Fn(&SamplePlace) -> Result<Option<CameraEdge<T>>, TooManyImages> + Sync,
        capacity: usize,
        watch: &dyn Watch,
    ) -> Result<Option<Vec<DrawnEdge<T>>>, DeviceError> {
        // Draw the edges, and keep the samples that have one.
        let drawn = samples.places().enumerate().filter_map(|(sample, place)| {
            let edge = draw(&place).transpose()?;
            Some(edge.map(|edge| {
                let hits = edge.sides.map(|ray| self.hit(&ray, &place));
                (sample, edge.flow, edge.weight, hits)
            }))
        });
        let drawn = drawn.collect::<Result<Vec<_>, TooManyImages>>();
        let drawn = drawn.map_err(|_| Unsupported {
            what: "a pixel shows too many images, or edges in them, by flat mirrors and panes"
                .to_owned(),
        })?;
        if drawn.is_empty() {
            return Ok(Some(Vec::new()));
        }
        // Follow the paths on both sides of as many as fit.
        let most = (capacity / 2).clamp(1, drawn.len());
        let paths = scene.paths(self.kernels, [2 * most, 0], &[], 0, None)?;
        let hits: Vec<_> = drawn.iter().flat_map(|&(.., hits)| hits).collect();
        let mut light: Vec<[f32; 3]> = Vec::with_capacity(hits.len());
        for some in hits.chunks(2 * most) {
            let Followed::ToTheEnd(_) = paths.follow(some.len(), some.as_flattened(), watch)?
            else {
                return Ok(None);
            };
            light.extend(paths.numbers::<3>(some.len())?);
        }
        let pairs = drawn.into_iter().zip(light.as_chunks::<2>().0);
        let edges = pairs.map(|((sample, flow, weight, _), sides)| {
            let [behind, before] = sides.map(|light| Rgb::from(light.map(f64::from)));
            DrawnEdge {
                sample,
                flow,
                discontinuity: (behind - before) * weight,
            }
        });
        Ok(Some(edges.collect()))
    }

    /// What a ray hits. The CPU finds it, in double precision: both rays beside an edge have the
    /// same direction in single precision, so the device would see one surface along both.
    fn hit(&self, ray: &ViewRay<f64>, place: &SamplePlace) -> [u32; HIT_WORDS] {
        let [t_min, t_max] = ray.range;
        let hit = self.tracer.accel.first_hit_within(&Ray {
            origin: ray.origin,
            direction: ray.direction,
            t_min,
            t_max,
        });
        let (face, weights) = hit.map_or((NONE, [0.0; 2]), |hit| (hit.face, hit.barycentric));
        let [[v, v_rest], [w, w_rest]] = weights.map(two_floats);
        let [x, y, z] = ray.direction.to_array().map(two_floats);
        // The random numbers of the sample, on both sides: their noise cancels.
        let key = place.stream.independent_key().unwrap_or_default();
        let [low, high] = [key as u32, (key >> 32) as u32];
        record(&[
            (HIT_FACE, face),
            (HIT_WEIGHTS, v),
            (HIT_WEIGHTS + 1, v_rest),
            (HIT_WEIGHTS + 2, w),
            (HIT_WEIGHTS + 3, w_rest),
            (HIT_DIRECTION, x[0]),
            (HIT_DIRECTION + 1, y[0]),
            (HIT_DIRECTION + 2, z[0]),
            (HIT_DIRECTION_REST, x[1]),
            (HIT_DIRECTION_REST + 1, y[1]),
            (HIT_DIRECTION_REST + 2, z[1]),
            (HIT_KEY, low),
            (HIT_KEY + 1, high),
        ])
    }
}
