//! Textures: the home of every number of a material or an emitter. A colour
//! that is the same everywhere is a texture with one texel.

use capwalk_math::Rgb;

use crate::scene::{Scene, SceneError};

/// Index into [`Scene::textures`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TextureId(pub u32);

/// Numbers, and how they cover a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// Its name; parameters are `<id>.value` and so on. That of a texture that
    /// stands in a material is `<material>.<slot>`, such as
    /// `floor.bsdf.reflectance`.
    pub id: String,
    /// Numbers per texel: 3 (red, green, blue) or 1 (a grey, or no colour).
    pub channels: usize,
    /// The texels one after the other, each with all its channels.
    pub data: Vec<f64>,
    /// Where on a surface the texels are.
    pub pattern: Pattern,
}

/// How texels cover a surface.
#[derive(Clone, Debug, PartialEq)]
pub enum Pattern {
    /// The one texel is everywhere.
    Constant,
}

impl Texture {
    /// The same colour everywhere.
    pub fn colour(id: impl Into<String>, colour: Rgb) -> Self {
        Self {
            id: id.into(),
            channels: 3,
            data: colour.to_array().to_vec(),
            pattern: Pattern::Constant,
        }
    }

    /// The same number everywhere.
    pub fn number(id: impl Into<String>, number: f64) -> Self {
        Self {
            id: id.into(),
            channels: 1,
            data: vec![number],
            pattern: Pattern::Constant,
        }
    }

    /// A texel; greys have three equal channels.
    #[inline]
    pub fn texel(&self, index: usize) -> Rgb {
        texel(&self.data, self.channels, index)
    }

    /// The name of its numbers as a parameter.
    pub fn parameter_name(&self) -> String {
        match self.pattern {
            Pattern::Constant => format!("{}.value", self.id),
        }
    }

    pub(crate) fn check(&self) -> Result<(), SceneError> {
        debug_assert!(matches!(self.channels, 1 | 3));
        debug_assert_eq!(self.data.len() % self.channels, 0);
        let texels = 0..self.data.len() / self.channels;
        for value in texels.map(|i| self.texel(i)) {
            if !value.is_finite() || value.min(Rgb::zero()) != Rgb::zero() {
                return Err(SceneError::BadNumber {
                    name: self.parameter_name(),
                    value: format!("({}, {}, {})", value.x, value.y, value.z),
                    expected: "finite numbers of at least 0",
                });
            }
        }
        Ok(())
    }
}

/// A texel of the data of a texture, or of velocities of the same form.
#[inline]
pub fn texel(data: &[f64], channels: usize, index: usize) -> Rgb {
    match channels {
        1 => Rgb::splat(data[index]),
        _ => Rgb::new(data[3 * index], data[3 * index + 1], data[3 * index + 2]),
    }
}

impl Scene {
    /// The texture with this id.
    #[inline]
    pub fn texture(&self, id: TextureId) -> &Texture {
        &self.textures[id.0 as usize]
    }

    /// The texture with this id, to be changed.
    pub fn texture_mut(&mut self, id: TextureId) -> &mut Texture {
        &mut self.textures[id.0 as usize]
    }

    /// Adds a texture.
    pub fn add_texture(&mut self, texture: Texture) -> TextureId {
        self.textures.push(texture);
        TextureId(self.textures.len() as u32 - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn greys_have_three_equal_channels() {
        assert_eq!(Texture::number("a", 0.3).texel(0), Rgb::splat(0.3));
        let colour = Rgb::new(0.1, 0.2, 0.3);
        assert_eq!(Texture::colour("b", colour).texel(0), colour);
        assert_eq!(
            texel(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0], 3, 1),
            Rgb::new(4.0, 5.0, 6.0)
        );
        assert_eq!(texel(&[1.0, 2.0], 1, 1), Rgb::splat(2.0));
    }

    #[test]
    fn bad_numbers_are_named() {
        for (number, shown) in [(-1.0, "(-1, -1, -1)"), (f64::NAN, "(NaN, NaN, NaN)")] {
            let error = Texture::number("a.alpha", number).check().expect_err(shown);
            let message = error.to_string();
            assert!(
                message.starts_with(&format!("a.alpha.value is {shown}")),
                "{message}"
            );
        }
    }
}
