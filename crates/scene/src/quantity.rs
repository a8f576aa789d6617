//! What the numbers of a texture mean where it stands.

/// What the numbers of a texture are, and which are allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Emitted radiance.
    Radiance,
    /// Fraction of light reflected.
    Reflectance,
    /// Something that comes with a mesh; its use decides what it means.
    Attribute,
}

impl Quantity {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Radiance => "radiance",
            Self::Reflectance => "reflectance",
            Self::Attribute => "attribute",
        }
    }

    /// Its unit.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Radiance => "radiance",
            Self::Reflectance => "fraction reflected",
            Self::Attribute => "as in the mesh",
        }
    }

    /// Which numbers are allowed, in words.
    pub fn expected(self) -> &'static str {
        match self {
            Self::Radiance | Self::Reflectance => "finite numbers of at least 0",
            Self::Attribute => "finite numbers",
        }
    }

    /// True if a number is allowed.
    pub fn allows(self, number: f64) -> bool {
        match self {
            Self::Radiance | Self::Reflectance => number >= 0.0,
            Self::Attribute => true,
        }
    }
}
