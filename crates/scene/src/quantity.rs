//! What the numbers of a texture mean where it stands.

/// What the numbers of a texture are, and which are allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Emitted radiance.
    Radiance,
    /// Power per solid angle.
    Intensity,
    /// Power per area.
    Irradiance,
    /// A factor of any size.
    Factor,
    /// A factor of any size and either sign.
    SignedFactor,
    /// Fraction of light reflected.
    Reflectance,
    /// Fraction of light transmitted.
    Transmittance,
    /// Roughness of a surface of microfacets.
    Roughness,
    /// A refractive index.
    RefractiveIndex {
        /// True if clear images are seen through it, which it moves.
        bends: bool,
    },
    /// Real part of the refractive index of a metal.
    MetalIndex,
    /// Imaginary part of a refractive index.
    Extinction,
    /// A number from 0 to 1.
    Fraction,
    /// Twice a fraction: a number from 0 to 2.
    TwiceFraction,
    /// An angle of a light.
    Angle,
    /// Normals, `(n + 1) / 2`.
    Normal,
    /// Heights of a bumpy surface.
    Height,
    /// Something that comes with a mesh; its use decides what it means.
    Attribute,
}

impl Quantity {
    /// True if rays that leave a surface move with it.
    pub fn moves_rays(self) -> bool {
        matches!(
            self,
            Self::RefractiveIndex { bends: true } | Self::Normal | Self::Height
        )
    }

    /// True if it is one number in all materials: of a colour its luminance.
    pub fn is_number(self) -> bool {
        matches!(
            self,
            Self::Roughness | Self::RefractiveIndex { .. } | Self::Fraction | Self::TwiceFraction
        )
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Radiance => "radiance",
            Self::Intensity => "intensity",
            Self::Irradiance => "irradiance",
            Self::Factor | Self::SignedFactor => "factor",
            Self::Reflectance => "reflectance",
            Self::Transmittance => "transmittance",
            Self::Roughness => "roughness",
            Self::RefractiveIndex { .. } | Self::MetalIndex => "refractive index",
            Self::Extinction => "extinction",
            Self::Fraction => "fraction",
            Self::TwiceFraction => "twice a fraction",
            Self::Angle => "angle",
            Self::Normal => "normals",
            Self::Height => "heights",
            Self::Attribute => "attribute",
        }
    }

    /// Its unit.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Radiance => "radiance",
            Self::Intensity => "intensity",
            Self::Irradiance => "irradiance",
            Self::Factor | Self::SignedFactor => "times what it is",
            Self::Reflectance => "fraction reflected",
            Self::Transmittance => "fraction transmitted",
            Self::Roughness => "root mean square slope times √2",
            Self::RefractiveIndex { .. } | Self::MetalIndex => "refractive index",
            Self::Extinction => "extinction",
            Self::Fraction => "fraction",
            Self::TwiceFraction => "twice a fraction",
            Self::Angle => "degrees",
            Self::Normal => "(n + 1) / 2",
            Self::Height => "world units before scaling",
            Self::Attribute => "as in the mesh",
        }
    }

    /// Which numbers are allowed, in words.
    pub fn expected(self) -> &'static str {
        match self {
            Self::Radiance
            | Self::Intensity
            | Self::Irradiance
            | Self::Factor
            | Self::Reflectance
            | Self::Transmittance
            | Self::Roughness
            | Self::MetalIndex
            | Self::Extinction => "finite numbers of at least 0",
            Self::RefractiveIndex { .. } => "finite numbers above 0",
            Self::Fraction => "numbers from 0 to 1",
            Self::TwiceFraction => "numbers from 0 to 2",
            Self::Angle => "numbers from 0 to 180",
            Self::SignedFactor | Self::Normal | Self::Height | Self::Attribute => "finite numbers",
        }
    }

    /// True if a number is allowed.
    pub fn allows(self, number: f64) -> bool {
        match self {
            Self::Radiance
            | Self::Intensity
            | Self::Irradiance
            | Self::Factor
            | Self::Reflectance
            | Self::Transmittance
            | Self::Roughness
            | Self::MetalIndex
            | Self::Extinction => number >= 0.0,
            Self::RefractiveIndex { .. } => number > 0.0,
            Self::Fraction => (0.0..=1.0).contains(&number),
            Self::TwiceFraction => (0.0..=2.0).contains(&number),
            Self::Angle => (0.0..=180.0).contains(&number),
            Self::SignedFactor | Self::Normal | Self::Height | Self::Attribute => {
                number.is_finite()
            }
        }
    }

    /// True if a change moves edges: what is seen through clear glass moves. (What
    /// is seen in a mirror with a map of normals is found while it is sampled.)
    pub fn moves_edges(self) -> bool {
        match self {
            Self::RefractiveIndex { bends } => bends,
            Self::Radiance
            | Self::Intensity
            | Self::Irradiance
            | Self::Factor
            | Self::SignedFactor
            | Self::Reflectance
            | Self::Transmittance
            | Self::Roughness
            | Self::MetalIndex
            | Self::Extinction
            | Self::Fraction
            | Self::TwiceFraction
            | Self::Angle
            | Self::Normal
            | Self::Height
            | Self::Attribute => false,
        }
    }
}
