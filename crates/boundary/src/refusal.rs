//! Why a derivative is refused, and what to do instead.

use std::fmt;

use capwalk_geometry::Halted;
use capwalk_scene::memory::mib;
use capwalk_scene::shown;

/// Why a derivative is refused. Its text says what was found where, and what to do
/// instead.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Refusal {
    /// The watch stopped the preparation of the scene, before the first sample.
    Stopped,
    /// There is no memory for the boundaries of the scene.
    Memory {
        /// Triangles of the scene.
        triangles: u64,
        /// Bytes that their boundaries take, about.
        needed: u64,
        /// Bytes that are free.
        free: u64,
    },
    /// There is no memory for the sums of a gradient.
    GradientMemory {
        /// Numbers that the gradient is with respect to.
        numbers: u64,
        /// Bytes that all sums take, about.
        needed: u64,
        /// Bytes that are free.
        free: u64,
    },
    /// A walk of no steps: its field is not continuous.
    NoSteps,
    /// The largest angle of a walk, radians, is not in (0, π].
    MaxAngle(f64),
    /// A custom field cannot be had.
    Custom {
        /// What was found where, without a full stop.
        reason: String,
        /// What to do instead, without a full stop; `None` where the reason says what was expected.
        instead: Option<String>,
    },
    /// Something moves beside an emitter without extent, and the method misses the edges of
    /// its shadows, which lie on surfaces (METHOD 7).
    HardShadows {
        /// Name of the emitter.
        emitter: String,
        /// Its kind, by Mitsuba's name.
        plugin: &'static str,
        /// Name of the method.
        method: &'static str,
    },
    /// Something moves beside an emitter that projects an image with borders.
    ImageBorders {
        /// Name of the emitter.
        emitter: String,
        /// Its kind, by Mitsuba's name.
        plugin: &'static str,
    },
    /// The edges of hard shadows consist of too many segments.
    ManyShadowLines {
        /// Most that are accepted.
        most: usize,
    },
    /// Something moves before the parallel rays of an orthographic sensor, and the
    /// method has fields around points only.
    ParallelRays {
        /// Name of the method.
        method: &'static str,
    },
    /// Something moves beside a texture with discontinuities whose motion the method
    /// misses.
    TextureDiscontinuities {
        /// Name of the texture.
        texture: String,
        /// Name of the shape.
        shape: String,
        /// Name of the method.
        method: &'static str,
    },
    /// A texture is discontinuous along too many lines.
    ManyTextureLines {
        /// Name of the texture.
        texture: String,
        /// Name of the shape.
        shape: String,
        /// Lines on the shape.
        count: f64,
        /// Most that are accepted.
        most: f64,
    },
    /// A smooth surface depends on how its material is turned about the normal, and
    /// its mesh does not say how.
    UnknownTangents {
        /// Name of the shape.
        shape: String,
        /// True if it has a map of normals, false if it is anisotropic.
        has_map: bool,
        /// The face, from 0, without extent in texture space; `None` if the mesh has
        /// no texture coordinates.
        face: Option<usize>,
    },
    /// A map of normals cuts light off along curves inside faces, and these move.
    CutNormals {
        /// Name of the material.
        material: String,
        /// Its kind, by Mitsuba's name.
        plugin: &'static str,
        /// The option that must be true.
        flag: &'static str,
    },
    /// A clip plane of the camera cuts a shape within the image, and one of them moves.
    Clipped {
        /// Name of the shape.
        shape: String,
        /// Name of the plane: `near_clip` or `far_clip`.
        plane: &'static str,
        /// Its depth, world units.
        depth: f64,
    },
    /// The derivative with respect to a number of a material is infinite.
    InfiniteDerivative {
        /// Name of the material.
        material: String,
        /// The number, by Mitsuba's name.
        slot: &'static str,
        /// Why it is infinite where the number is 0.
        why: &'static str,
    },
    /// Silhouettes move that are seen by specular reflection or refraction, and the method's field
    /// does not cover them.
    SpecularMotion {
        /// The method.
        method: &'static str,
    },
    /// A blend refracts or reflects light in two directions at once, and a field along a chain follows one.
    TwoImages {
        /// Name of the material.
        material: String,
    },
    /// The adjoint image has another size than the image.
    AdjointSize {
        /// Its width and height, pixels.
        found: [usize; 2],
        /// Width and height of the image.
        expected: [usize; 2],
    },
    /// The adjoint image has a pixel that is infinite or NaN.
    AdjointNotFinite {
        /// Column and row, from 0 at the upper left.
        pixel: [usize; 2],
        /// Its channels.
        value: [f64; 3],
    },
    /// A finite difference changes no number of the scene: rounding swallows its step.
    StepTooSmall {
        /// The step to either side, in units of the parameter.
        step: f64,
    },
    /// A finite difference leaves the scenes that can be rendered, whichever side is taken.
    InvalidStep {
        /// The step to either side, in units of the parameter.
        step: f64,
        /// What is wrong with the scene there.
        reason: String,
    },
}

impl Refusal {
    /// What was found where, and what is not differentiated; without a full stop.
    pub fn reason(&self) -> String {
        self.sentences().0
    }

    /// What to do instead, without a full stop; `None` where the reason says what was expected.
    pub fn instead(&self) -> Option<String> {
        self.sentences().1
    }

    /// [`Refusal::reason`] and [`Refusal::instead`].
    fn sentences(&self) -> (String, Option<String>) {
        let instead = |text: &str| Some(text.into());
        match self {
            Self::Stopped => ("stopped before a sample was taken".into(), None),
            Self::Memory {
                triangles,
                needed,
                free,
            } => (
                format!(
                    "the boundaries of {triangles} triangles need about {} MiB of memory, and {} MiB \
                     are free",
                    mib(*needed),
                    mib(*free)
                ),
                instead("Leave shapes out, or take meshes of fewer triangles"),
            ),
            Self::GradientMemory {
                numbers,
                needed,
                free,
            } => (
                format!(
                    "a gradient with respect to {numbers} numbers needs about {} MiB of memory, and \
                     {} MiB are free",
                    mib(*needed),
                    mib(*free)
                ),
                instead(
                    "Ask for fewer arrays at a time, take smaller textures, or use fewer threads",
                ),
            ),
            Self::NoSteps => (
                "a walk of 0 steps gives a discontinuous velocity field, and with it a wrong \
                 derivative"
                    .into(),
                instead("Use at least 1 step"),
            ),
            Self::MaxAngle(angle) => (
                format!(
                    "the largest angle of a walk is {}; expected radians above 0 and at most π",
                    shown(*angle)
                ),
                None,
            ),
            Self::Custom { reason, instead } => (reason.clone(), instead.clone()),
            Self::HardShadows {
                emitter,
                plugin,
                method,
            } => (
                format!(
                    "the emitter \"{emitter}\" ({plugin}) has no extent, so its shadows have hard \
                     edges, whose motion is not differentiated by the method `{method}`"
                ),
                instead("Use the default method, a small area emitter, or finite differences"),
            ),
            Self::ImageBorders { emitter, plugin } => (
                format!(
                    "the image that the emitter \"{emitter}\" ({plugin}) projects is discontinuous, at its \
                     border or inside, and the motion of this on surfaces is not differentiated"
                ),
                instead(
                    "Use a spot light with a `bilinear` texture, an area emitter, or finite \
                     differences",
                ),
            ),
            Self::ManyShadowLines { most } => (
                format!(
                    "the edges of the hard shadows of emitters without extent consist of more than \
                     {most} segments: one for each face on which the shadow of an edge falls"
                ),
                instead("Use small area emitters, coarser meshes, or finite differences"),
            ),
            Self::ParallelRays { method } => (
                format!(
                    "the method `{method}` has no velocity field for the parallel rays of an \
                     orthographic sensor"
                ),
                instead(
                    "Use the default method, or a perspective sensor far away with a small fov",
                ),
            ),
            Self::TextureDiscontinuities {
                texture,
                shape,
                method,
            } => (
                format!(
                    "the texture \"{texture}\" on the shape \"{shape}\" is discontinuous between \
                     texels, and the method `{method}` does not differentiate how these \
                     discontinuities move"
                ),
                instead("Use the filter `bilinear`, the default method, or finite differences"),
            ),
            Self::ManyTextureLines {
                texture,
                shape,
                count,
                most,
            } => (
                format!(
                    "the texture \"{texture}\" on the shape \"{shape}\" is discontinuous between \
                     texels, along {count:.0} lines; expected at most {most:.0}"
                ),
                instead("Use the filter `bilinear`, or finite differences"),
            ),
            Self::UnknownTangents {
                shape,
                has_map,
                face,
            } => {
                let material = match has_map {
                    true => "has a map of normals",
                    false => "is anisotropic",
                };
                let lack = match face {
                    None => "no texture coordinates".into(),
                    Some(face) => {
                        format!("texture coordinates without extent in face {face} (from 0)")
                    }
                };
                (
                    format!(
                        "the material of the shape \"{shape}\" {material}, and its mesh has {lack} \
                         that would give its tangents. Tangents made up without them are \
                         discontinuous on smooth surfaces"
                    ),
                    instead("Add texture coordinates to the mesh that span every face"),
                )
            }
            Self::CutNormals {
                material,
                plugin,
                flag,
            } => (
                format!(
                    "without `{flag}` the {plugin} \"{material}\" cuts off light along curves \
                     inside faces, and the motion of these is not differentiated"
                ),
                Some(format!("Set `{flag}` to true, or use finite differences")),
            ),
            Self::Clipped {
                shape,
                plane,
                depth,
            } => (
                format!(
                    "the camera's {plane} of {depth} cuts through the shape \"{shape}\" within the \
                     image, and the motion of the cut is not differentiated"
                ),
                Some(format!("Choose another {plane}, or move the camera")),
            ),
            Self::InfiniteDerivative {
                material,
                slot,
                why,
            } => (
                format!(
                    "the derivative with respect to \"{slot}\" of the principled material \
                     \"{material}\" is infinite where it is 0: {why}"
                ),
                instead("Raise such values a little, for example to 0.001"),
            ),
            Self::SpecularMotion { method } => (
                format!(
                    "objects move that are seen in mirrors or through transparent surfaces, and the \
                     fields of the method `{method}` do not cover the silhouettes seen there"
                ),
                instead("Use fields on the sphere, the default, which do"),
            ),
            Self::TwoImages { material } => (
                format!(
                    "the material \"{material}\" blends two that refract or reflect light in different \
                     directions, and what moves there has two images"
                ),
                instead("Use one of them, or two surfaces"),
            ),
            Self::AdjointSize {
                found: [width, height],
                expected: [right_width, right_height],
            } => (
                format!(
                    "the adjoint has {width} x {height} pixels; expected {right_width} x \
                     {right_height}, as the image has"
                ),
                None,
            ),
            Self::AdjointNotFinite {
                pixel: [x, y],
                value: [r, g, b],
            } => (
                format!(
                    "the adjoint is ({r}, {g}, {b}) in column {x}, row {y}, counted from 0 at the \
                     upper left; expected finite numbers"
                ),
                None,
            ),
            Self::StepTooSmall { step } => (
                format!(
                    "a finite difference over {step:e} changes nothing: the step is lost to \
                     rounding"
                ),
                instead("Choose a larger step, or leave it out"),
            ),
            Self::InvalidStep { step, reason } => (
                format!(
                    "a finite difference over {} gives invalid scenes on both sides, for \
                     example: {reason}",
                    shown(*step)
                ),
                instead(
                    "Choose a smaller step; or, if numbers are at both ends of their range, such as \
                     a texel of 0 beside one of 1, ask for one of them at a time",
                ),
            ),
        }
    }
}

impl From<Halted> for Refusal {
    fn from(_: Halted) -> Self {
        Self::Stopped
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (reason, instead) = self.sentences();
        f.write_str(&reason)?;
        match instead {
            Some(instead) => write!(f, ". {instead}"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for Refusal {}
