//! What a user reads about a parameter.

use crate::quantity::Quantity;

/// A number of the scene, or three that change together.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// What it is called in expressions.
    pub name: String,
    /// What sort of change it is.
    pub kind: ParameterKind,
    /// What it is now: 0 for translations and rotations, 1 for scales, a
    /// colour (three numbers) or one channel of it. Empty for the texels of a
    /// bitmap and for attributes of meshes.
    pub value: Vec<f64>,
    /// Unit of the value, and of the derivative's denominator.
    pub unit: &'static str,
    /// True if edges move, seen from somewhere: the derivative then has a
    /// boundary part.
    pub moves_discontinuities: bool,
    /// What changes, in a few words.
    pub description: String,
    /// The name under which the same parameter is listed first, if this is
    /// only another name for it.
    pub alias_of: Option<String>,
}

/// Sorts of parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterKind {
    /// Position of a shape along a world axis.
    Translation,
    /// Angle of a shape about a world axis through its centre.
    Rotation,
    /// Size of a shape relative to what it is.
    Scale,
    /// What an emitter emits.
    Radiance,
    /// What a light without extent emits, per solid angle.
    Intensity,
    /// What parallel light brings, per area.
    Irradiance,
    /// A factor.
    Factor,
    /// How much a material reflects.
    Reflectance,
    /// Vertices of a shape.
    Positions,
    /// Shading normals given with a shape.
    Normals,
    /// Something that comes with a mesh, per vertex or per face.
    Attribute,
    /// How much a material transmits.
    Transmittance,
    /// How rough a surface is.
    Roughness,
    /// A refractive index, or the real part of one.
    RefractiveIndex,
    /// The imaginary part of a refractive index.
    Extinction,
    /// A number from 0 to 1 (or 0 to 2: `diff_trans`): opacity, weight, metallic ...
    Fraction,
    /// An angle of a light.
    Angle,
    /// Normals from a texture.
    Normal,
    /// Heights from a texture.
    Height,
    /// Position of a light without extent along a world axis.
    LightTranslation,
    /// Angle of a light without extent about a world axis through it.
    LightRotation,
    /// Position of a light without extent.
    LightPosition,
    /// Position of the sensor along a world axis.
    SensorTranslation,
    /// Angle of the sensor about a world axis through its origin.
    SensorRotation,
    /// The matrix that puts a shape in the world.
    ToWorld,
    /// The matrix that puts the sensor in the world.
    SensorToWorld,
    /// Horizontal field of view of the sensor.
    FieldOfView,
    /// Radius of the sensor's lens.
    ApertureRadius,
    /// Depth at which the sensor is sharp.
    FocusDistance,
}

impl ParameterKind {
    /// True if it changes the sensor.
    pub fn is_of_sensor(self) -> bool {
        matches!(
            self,
            Self::SensorTranslation
                | Self::SensorRotation
                | Self::SensorToWorld
                | Self::FieldOfView
                | Self::ApertureRadius
                | Self::FocusDistance
        )
    }
}

impl From<Quantity> for ParameterKind {
    fn from(quantity: Quantity) -> Self {
        match quantity {
            Quantity::Radiance => Self::Radiance,
            Quantity::Intensity => Self::Intensity,
            Quantity::Irradiance => Self::Irradiance,
            Quantity::Factor | Quantity::SignedFactor => Self::Factor,
            Quantity::Reflectance => Self::Reflectance,
            Quantity::Attribute => Self::Attribute,
            Quantity::Transmittance => Self::Transmittance,
            Quantity::Roughness => Self::Roughness,
            Quantity::RefractiveIndex { .. } | Quantity::MetalIndex => Self::RefractiveIndex,
            Quantity::Extinction => Self::Extinction,
            Quantity::Fraction | Quantity::TwiceFraction => Self::Fraction,
            Quantity::Angle => Self::Angle,
            Quantity::Normal => Self::Normal,
            Quantity::Height => Self::Height,
        }
    }
}
