//! Textures: the home of every number of a material or an emitter. A colour
//! that is the same everywhere is a texture with one texel.

mod bitmap;

pub(crate) use bitmap::bilinear;
pub use bitmap::{Bitmap, TexelFilter, UvTransform, Wrap, between};

use capwalk_math::elementary::floor;
use capwalk_math::{Real, Rgb};
use serde::{Deserialize, Serialize};

use crate::scene_error::SceneError;
use capwalk_geometry::shown;

/// Numbers, and how they cover a surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Texture {
    /// Its name; parameters are `<id>.value` and so on. That of a texture that
    /// stands in a material is `<material>.<slot>`, such as
    /// `floor.bsdf.reflectance`.
    pub id: String,
    /// Numbers per texel: 3 (red, green, blue) or 1 (a grey, or no colour).
    pub channels: usize,
    /// The texels one after the other, each with all its channels. Linear.
    pub data: Vec<f64>,
    /// Where on a surface the texels are.
    pub pattern: Pattern,
}

/// How texels cover a surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Pattern {
    /// The one texel is everywhere.
    Constant,
    /// Rows of texels over the unit square of texture coordinates.
    Bitmap(Bitmap),
    /// Two texels that alternate in squares of side 1/2: the first where `u`
    /// and `v` are in the same half of their period.
    Checkerboard {
        /// Acts on texture coordinates first.
        to_uv: UvTransform,
    },
    /// What the shape says of itself: one of its attributes.
    MeshAttribute {
        /// The attribute, such as `vertex_color`.
        name: String,
        /// Factor.
        scale: f64,
    },
    /// An attribute of a shape with one texel per vertex, interpolated.
    PerVertex,
    /// An attribute of a shape with one texel per triangle.
    PerFace,
    /// Texels of all directions, [`crate::emitter::EnvironmentMap`].
    Environment,
}

/// Part of the data of a texture that has a name of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NamedTexels {
    /// What stands behind the texture's id and a dot; empty for nothing.
    pub name: &'static str,
    /// The first texel of it.
    pub first: usize,
    /// How many texels it has.
    pub count: usize,
}

impl Texture {
    /// A texture with the same colour everywhere.
    pub fn colour(id: impl Into<String>, colour: Rgb) -> Self {
        Self {
            id: id.into(),
            channels: 3,
            data: colour.to_array().to_vec(),
            pattern: Pattern::Constant,
        }
    }

    /// A texture with the same number everywhere.
    pub fn number(id: impl Into<String>, number: f64) -> Self {
        Self {
            id: id.into(),
            channels: 1,
            data: vec![number],
            pattern: Pattern::Constant,
        }
    }

    /// How many texels it has.
    pub fn texels(&self) -> usize {
        self.data.len() / self.channels
    }

    /// A texel; greys have three equal channels.
    #[inline]
    pub fn texel(&self, index: usize) -> Rgb {
        texel(&self.data, self.channels, index)
    }

    /// A texel as one number: the luminance of a colour.
    pub fn texel_as_number(&self, index: usize) -> f64 {
        self.as_number(self.texel(index))
    }

    /// A value, or a change of it, as one number.
    #[inline]
    pub fn as_number<R: Real>(&self, value: Rgb<R>) -> R {
        match self.channels {
            1 => value.r,
            _ => value.luminance(),
        }
    }

    /// True if it is the same everywhere.
    pub fn is_constant(&self) -> bool {
        matches!(self.pattern, Pattern::Constant)
    }

    /// True if it depends on texture coordinates.
    pub fn needs_uv(&self) -> bool {
        match self.pattern {
            Pattern::Bitmap(_) | Pattern::Checkerboard { .. } => true,
            Pattern::Constant
            | Pattern::MeshAttribute { .. }
            | Pattern::PerVertex
            | Pattern::PerFace
            | Pattern::Environment => false,
        }
    }

    /// True if its derivatives along the surface are known: if it is a bitmap of
    /// interpolated texels.
    pub fn has_derivatives(&self) -> bool {
        match &self.pattern {
            Pattern::Bitmap(bitmap) => bitmap.filter == TexelFilter::Bilinear,
            Pattern::Constant
            | Pattern::Checkerboard { .. }
            | Pattern::MeshAttribute { .. }
            | Pattern::PerVertex
            | Pattern::PerFace
            | Pattern::Environment => false,
        }
    }

    /// Its value at texture coordinates `uv`. `texel` gives its texels, with
    /// or without derivatives. Rows of bitmaps begin at `v = 0`, the top of the
    /// image, as in Mitsuba.
    ///
    /// # Panics
    /// If it depends on more than texture coordinates ([`Scene::lookup`](crate::Scene::lookup)).
    pub fn lookup<R: Real>(&self, uv: [R; 2], mut texel: impl FnMut(usize) -> Rgb<R>) -> Rgb<R> {
        match &self.pattern {
            Pattern::Constant => texel(0),
            Pattern::Bitmap(bitmap) => bitmap.lookup(uv, texel),
            Pattern::Checkerboard { to_uv } => {
                let second_half = to_uv.apply(uv).map(|x| {
                    let x = x.value();
                    x - floor(x) > 0.5
                });
                texel(usize::from(second_half[0] != second_half[1]))
            }
            Pattern::MeshAttribute { .. }
            | Pattern::PerVertex
            | Pattern::PerFace
            | Pattern::Environment => {
                panic!("{} depends on more than texture coordinates", self.id)
            }
        }
    }

    /// The parts of its data that have names. An attribute that is looked up
    /// by name has none: its numbers are the shape's.
    pub fn parts(&self) -> Vec<NamedTexels> {
        let part = |name, first, count| NamedTexels { name, first, count };
        match self.pattern {
            Pattern::Constant => vec![part("value", 0, 1)],
            Pattern::Bitmap(_) | Pattern::Environment => vec![part("data", 0, self.texels())],
            Pattern::Checkerboard { .. } => {
                vec![part("color0.value", 0, 1), part("color1.value", 1, 1)]
            }
            Pattern::PerVertex | Pattern::PerFace => vec![part("", 0, self.texels())],
            Pattern::MeshAttribute { .. } => Vec::new(),
        }
    }

    /// The name of a part as a parameter.
    pub fn part_name(&self, part: NamedTexels) -> String {
        match part.name {
            "" => self.id.clone(),
            name => format!("{}.{name}", self.id),
        }
    }

    /// The error for a texel that is not what it should be.
    pub(crate) fn bad_number(
        &self,
        part: NamedTexels,
        index: usize,
        expected: &'static str,
    ) -> SceneError {
        let value = self.texel(index);
        let mut name = self.part_name(part);
        if part.count > 1 {
            name += &format!(", texel {index}");
        }
        SceneError::BadNumber {
            name,
            value: format!(
                "({}, {}, {})",
                shown(value.r),
                shown(value.g),
                shown(value.b)
            ),
            expected,
        }
    }

    /// An error if it has not as many numbers as so many texels need.
    pub(crate) fn check_length(&self, texels: usize) -> Result<(), SceneError> {
        let expected = texels * self.channels;
        if self.data.len() == expected {
            return Ok(());
        }
        Err(SceneError::TextureLength {
            texture: self.id.clone(),
            numbers: self.data.len(),
            expected,
        })
    }

    pub(crate) fn check(&self) -> Result<(), SceneError> {
        if !matches!(self.channels, 1 | 3) {
            return Err(SceneError::BadNumber {
                name: format!("{}.channels", self.id),
                value: self.channels.to_string(),
                expected: "1 or 3",
            });
        }
        let texels = match &self.pattern {
            Pattern::Constant => 1,
            Pattern::Bitmap(bitmap) => bitmap.width as usize * bitmap.height as usize,
            Pattern::Checkerboard { .. } => 2,
            // How many there are is the shape's, or the map's, to say.
            Pattern::MeshAttribute { .. }
            | Pattern::PerVertex
            | Pattern::PerFace
            | Pattern::Environment => self.texels(),
        };
        self.check_length(texels)?;
        self.check_numbers(f64::is_finite, "finite numbers")
    }

    /// An error for the first texel with a number that is not allowed.
    pub(crate) fn check_numbers(
        &self,
        allows: impl Fn(f64) -> bool,
        expected: &'static str,
    ) -> Result<(), SceneError> {
        // Mostly all are, which is known soonest without looking for texels.
        if self.data.iter().fold(true, |all, &x| all & allows(x)) {
            return Ok(());
        }
        for part in self.parts() {
            for index in part.first..part.first + part.count {
                if !self.texel(index).to_array().into_iter().all(&allows) {
                    return Err(self.bad_number(part, index, expected));
                }
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

#[cfg(test)]
mod tests;
