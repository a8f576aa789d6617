//! Derivative images from a device, in forward mode.

use std::borrow::Cow;

use capwalk_diff::{GradientOptions, GradientWork, Wanted};
use capwalk_geometry::buffers::NONE;
use capwalk_render::{GradientImage, Watch};
use capwalk_scene::Tangent;

use crate::averages::{MOST_PATHS, Task};
use crate::device_error::DeviceError;
use crate::device_scene::DeviceScene;
use crate::render_kernels::FORWARD;
use crate::texture_records::{Shown, float};
use crate::unsupported::unsupported_motion;

impl DeviceScene<'_> {
    /// The derivative of the image for a unit change along `tangent`, with the image, as
    /// [`capwalk_diff::gradient`] has them: of its samples, with its refusals. An error if anything
    /// moves. If `watch` stops the work, what was done is returned.
    pub fn gradient(
        &self,
        tangent: &Tangent,
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<GradientImage, DeviceError> {
        self.gradient_in_parts(tangent, options, MOST_PATHS, watch)
    }

    /// The same with so many samples on the device at a time at most, which changes no bit.
    pub fn gradient_in_parts(
        &self,
        tangent: &Tangent,
        options: &GradientOptions,
        most: usize,
        watch: &dyn Watch,
    ) -> Result<GradientImage, DeviceError> {
        GradientWork::new(self.prepared, Cow::Borrowed(tangent), *options).check()?;
        let wanted = Wanted::by(tangent);
        if let Some(unsupported) = unsupported_motion(self.prepared, &wanted, &self.gpu) {
            return Err(unsupported.into());
        }
        let edges = wanted.geometry().then(|| self.edges(tangent)).transpose()?;
        let changes = changes(&self.textures, tangent);
        self.check_room_of_numbers(changes.len())?;
        let task = Task {
            kernels: &FORWARD,
            changes: &changes,
            most,
            edges: edges.as_ref(),
        };
        let averages = self.average::<6>(task, &options.sampling(), watch)?;
        let scene = self.prepared.scene();
        Ok(GradientImage {
            value: averages.estimate(scene, 0),
            gradient: averages.estimate(scene, 3),
            missing: None,
            statistics: averages.statistics,
        })
    }
}

/// How the texels of each texture change, as `colours.slang` reads it.
fn changes(textures: &[Shown], tangent: &Tangent) -> Vec<u32> {
    let mut words = vec![NONE; 2 * textures.len()];
    for (number, shown) in textures.iter().enumerate() {
        if let Some(change) = &tangent.textures[shown.numbers.0 as usize] {
            words[2 * number] = words.len() as u32;
            words.extend(change.iter().map(|x| float(shown.scale * x)));
        }
    }
    words
}
