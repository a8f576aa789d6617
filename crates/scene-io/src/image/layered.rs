//! Images of one view with their names.

use capwalk_scene::Image;

/// Images of the same size, by name, and what is known about them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LayeredImage {
    /// The images: `value`, `gradient`, `stderr` and so on.
    pub layers: Vec<Layer>,
    /// Keys and values: `scene`, `parameter`, `seed`, `spp`, `version`.
    pub metadata: Vec<(String, String)>,
    /// Samples taken in each pixel, row by row, if they are known.
    pub samples: Option<Vec<u32>>,
}

/// An image and its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// Its name. [`VALUE`] is the primal image; all others are shown in
    /// false colours.
    pub name: String,
    /// Linear values.
    pub image: Image,
}

/// The name of the layer that is the primal image.
pub const VALUE: &str = "value";
/// The name of the layer that is a derivative.
pub const GRADIENT: &str = "gradient";

impl LayeredImage {
    /// Adds a layer behind the others.
    pub fn push(&mut self, name: &str, image: Image) {
        self.layers.push(Layer {
            name: name.into(),
            image,
        });
    }

    /// The first layer with this name.
    pub fn layer(&self, name: &str) -> Option<&Image> {
        let layer = self.layers.iter().find(|layer| layer.name == name)?;
        Some(&layer.image)
    }

    /// Width and height, or a reason why the layers do not belong together.
    pub(super) fn size(&self) -> Result<[usize; 2], String> {
        let first = self.layers.first().ok_or("the image has no layers")?;
        let [width, height] = [first.image.width, first.image.height];
        if width == 0 || height == 0 {
            return Err(format!("the image has no pixels: it is {width} x {height}"));
        }
        for Layer { name, image } in &self.layers {
            if [image.width, image.height] != [width, height] {
                return Err(format!(
                    "\"{}\" has {width} x {height} pixels, but \"{name}\" has {} x {}",
                    first.name, image.width, image.height
                ));
            }
        }
        let samples = self.samples.as_ref().map(Vec::len);
        match samples.is_none_or(|count| count == width * height) {
            true => Ok([width, height]),
            false => Err("there are not as many sample counts as pixels".into()),
        }
    }
}
