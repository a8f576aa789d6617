//! The boundary estimators by name, and what each of them covers.

use serde::{Deserialize, Serialize};

use crate::custom_field::CustomField;

/// How the derivative of a discontinuous integrand is estimated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Method {
    /// The one of [`Method::Walk`] and [`Method::Edges`] with the least variance × time: each
    /// kind of segment is tried in a short pilot before the work, with the walk's angular
    /// cutoff. Unbiased.
    #[default]
    Auto,
    /// A velocity field around every shading point and the camera, estimated by walks on
    /// spherical caps. Unbiased.
    Walk,
    /// The walks of [`Method::Walk`], with the angular cutoff narrowed if a short pilot before the work
    /// finds less variance × time. Unbiased.
    FittedWalk,
    /// Boundary terms along some segments of paths, with points sampled on the edges there,
    /// and directions that do not move; elsewhere as [`Method::Walk`], also for a camera that
    /// has parallel rays or may see hundreds of flat mirrors. Unbiased.
    Edges(Gathers),
    /// A field of your own, to be compared with these.
    #[serde(skip_deserializing)]
    Custom(&'static dyn CustomField),
}

/// The segments of paths along which edges are gathered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Gathers {
    /// Edges in each pixel.
    pub camera: bool,
    /// Edges in front of area emitters.
    pub emitters: bool,
    /// Edges in front of the environment: few of them at a time, of subtrees chosen at
    /// random.
    pub environment: bool,
    /// The same edges and all others in front of surfaces that reflect light.
    pub indirect: bool,
    /// Points on the `n` pieces of the edges in front of an area emitter: so many times `√n`.
    /// Gathering is paid once for all of them.
    pub points: u32,
    /// The most edges in front of an area emitter that are listed at the later vertices of a path, and an eighth
    /// of those at the first. Of more, subtrees are sampled, except on devices.
    pub listed: u32,
    /// Points on the edges in a pixel, where it has any.
    pub camera_points: u32,
    /// True if what facets reflect follows their half vector where edges are gathered around
    /// surfaces; else it stays, or turns with the normal, as on devices.
    pub half_vector: bool,
    /// True if film points are drawn beside silhouettes of smooth surfaces, too, where edges in pixels
    /// are gathered; else by the filter alone, as on devices.
    pub beside_silhouettes: bool,
}

impl Gathers {
    /// Wherever it can be done.
    pub const ALL: Self = Self {
        camera: true,
        emitters: true,
        environment: true,
        indirect: true,
        points: Self::POINTS,
        listed: Self::LISTED,
        camera_points: Self::CAMERA_POINTS,
        half_vector: true,
        beside_silhouettes: true,
    };
    /// Nowhere.
    pub const NONE: Self = Self {
        camera: false,
        emitters: false,
        environment: false,
        indirect: false,
        ..Self::ALL
    };

    /// The names of the segments.
    pub fn names(self) -> Vec<&'static str> {
        let all = [
            ("camera", self.camera),
            ("emitters", self.emitters),
            ("environment", self.environment),
            ("indirect", self.indirect),
        ];
        let gathered = all.iter().filter(|(_, gathered)| *gathered);
        gathered.map(|(name, _)| *name).collect()
    }

    /// Points where nothing says how many are best.
    pub const POINTS: u32 = 4;
    /// More edges than these take longer to list than they are worth at the later vertices of paths in rooms.
    pub const LISTED: u32 = 512;
    /// Likewise in a pixel.
    pub const CAMERA_POINTS: u32 = 1;

    /// Only along segments of the other, too.
    #[must_use]
    pub fn within(self, other: Self) -> Self {
        self.without(self.without(other))
    }

    /// True if edges are gathered along no segment.
    pub fn is_nowhere(self) -> bool {
        !self.along(Self::ALL)
    }

    /// True if this also gathers along a segment of the other.
    pub fn along(self, other: Self) -> bool {
        self.without(other) != self
    }

    /// These segments without the segments of the other.
    #[must_use]
    pub fn without(self, other: Self) -> Self {
        Self {
            camera: self.camera && !other.camera,
            emitters: self.emitters && !other.emitters,
            environment: self.environment && !other.environment,
            indirect: self.indirect && !other.indirect,
            ..self
        }
    }
}

/// The properties of a method: every method states all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MethodTraits {
    /// Its name in files and messages.
    pub name: &'static str,
    /// True if it is unbiased: what it does not cover is refused.
    pub is_unbiased: bool,
    /// True if it walks: its settings must give a continuous field.
    pub walks: bool,
    /// Along which segments directions do not move, and edges are gathered.
    pub gathers: Gathers,
    /// True if its fields have reflected boundaries, lines of textures, parallel rays,
    /// and run over the edges of emitters, whose term is then added: the fields of
    /// [`crate::Field`] on the sphere of directions.
    pub is_spherical: bool,
}

impl Method {
    /// Edges gathered wherever that can be done.
    pub const EDGES: Self = Self::Edges(Gathers::ALL);

    /// Its properties.
    pub fn traits(&self) -> MethodTraits {
        let spherical = MethodTraits {
            name: "walk",
            is_unbiased: true,
            walks: true,
            gathers: Gathers::NONE,
            is_spherical: true,
        };
        match self {
            Self::Auto => MethodTraits {
                name: "auto",
                ..spherical
            },
            Self::Walk | Self::FittedWalk => spherical,
            Self::Edges(gathers) => MethodTraits {
                name: "edges",
                gathers: *gathers,
                ..spherical
            },
            Self::Custom(field) => MethodTraits {
                name: field.name(),
                is_unbiased: field.is_unbiased(),
                walks: field.walks(),
                gathers: Gathers::NONE,
                is_spherical: false,
            },
        }
    }

    /// True if a pilot has to settle it before the work.
    pub fn is_open(&self) -> bool {
        matches!(self, Self::Auto | Self::FittedWalk)
    }

    /// Its name in files and messages.
    pub fn name(&self) -> &'static str {
        self.traits().name
    }
}
