//! What a caller chooses about a gradient.

use capwalk_boundary::Method;
use capwalk_render::{Device, Grid, RenderOptions};
use capwalk_scene::Scene;
use capwalk_walk::WalkSettings;
use serde::{Deserialize, Serialize};

/// How a gradient is estimated.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct GradientOptions {
    /// Samples per pixel, at least 1; at least 2 for standard errors.
    pub spp: u32,
    /// True if pixels of a derivative image get more or fewer samples by how noisy they are, in
    /// the time of `spp` of each, see [`adaptive`](capwalk_render::adaptive). Not in reverse
    /// mode.
    pub adaptive: bool,
    /// Seed of all random numbers.
    pub seed: u64,
    /// How the discontinuities of the integrand are accounted for.
    pub method: Method,
    /// The cells that the samples are cut into. In reverse mode the spread of its batches
    /// gives the standard errors.
    pub grid: Grid,
    /// True if sampling in forward mode may not use how fast edges move, as in reverse
    /// mode, so that both take the same samples: for comparisons of the two.
    pub blind: bool,
    /// The walk that builds the velocity field, for methods that walk.
    pub walk: WalkSettings,
    /// Where `Prepared` in the crate `capwalk` computes; the functions of this crate compute on the
    /// CPU. Neither in fingerprints nor in stored bytes.
    #[serde(skip)]
    pub device: Device,
}

impl Default for GradientOptions {
    /// 64 samples per pixel, the seed 0, and the method that chooses, on the CPU.
    fn default() -> Self {
        RenderOptions::default().into()
    }
}

impl From<RenderOptions> for GradientOptions {
    /// The default method, sampled like this.
    fn from(sampling: RenderOptions) -> Self {
        let RenderOptions {
            spp,
            adaptive,
            seed,
            grid,
            device,
        } = sampling;
        Self {
            spp,
            adaptive,
            seed,
            grid,
            blind: false,
            method: Method::default(),
            walk: WalkSettings::default(),
            device,
        }
    }
}

impl GradientOptions {
    /// The default method, sampled like this.
    pub fn new(sampling: RenderOptions) -> Self {
        sampling.into()
    }

    /// What the scene says of itself, with the default method.
    pub fn of(scene: &Scene) -> Self {
        RenderOptions::of(scene).into()
    }

    /// How an image with as many samples and the same seed is rendered.
    pub fn sampling(&self) -> RenderOptions {
        RenderOptions {
            spp: self.spp,
            adaptive: self.adaptive,
            seed: self.seed,
            grid: self.grid,
            device: self.device,
        }
    }
}

#[cfg(test)]
mod tests {
    use capwalk_scene::{fingerprint, pack, unpack};

    use super::*;

    /// Work that was begun before options had a device goes on.
    #[test]
    fn devices_are_no_part_of_what_is_kept() {
        let on = |device| GradientOptions {
            device,
            ..GradientOptions::default()
        };
        let [cpu, gpu] = [Device::Cpu, Device::Gpu].map(on);
        // As of the fields that there were then.
        let RenderOptions {
            spp,
            adaptive,
            seed,
            grid,
            ..
        } = gpu.sampling();
        let images = fingerprint(&(spp, adaptive, seed, grid));
        assert_eq!(fingerprint(&gpu.sampling()), images);
        let (method, walk) = (gpu.method, gpu.walk);
        let before = (spp, adaptive, seed, method, grid, gpu.blind, walk);
        assert_eq!(fingerprint(&gpu), fingerprint(&before));
        let bytes = [pack(&gpu), pack(&before)].map(|bytes| bytes.expect("they can be written"));
        assert_eq!(bytes[0], bytes[1]);
        let read: GradientOptions = unpack(&bytes[1]).expect("they are options");
        assert_eq!(read, cpu);
    }
}
