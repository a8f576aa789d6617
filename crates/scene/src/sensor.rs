//! Sensors, with Mitsuba's conventions.
//!
//! Camera space: `+z` looks forward, `+y` is up, `+x` points to the left of
//! the image. How a film point looks into it is in [`view`].

pub mod view;

use capwalk_geometry::mesh::is_within_reach;
use capwalk_math::{Affine, Vec3};
use serde::{Deserialize, Serialize};

use crate::scene_error::SceneError;

/// A sensor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sensor {
    /// Name, for parameters; `sensor` if none was given.
    pub id: String,
    /// Where it is and how it is turned. Files give cameras with a field of
    /// view a rotation and a translation, orthographic ones a scale, too.
    pub world_from_camera: Affine,
    /// How film points look into camera space.
    pub model: SensorModel,
    /// Depth (camera-space `z`) before which nothing is seen.
    pub near_clip: f64,
    /// Depth beyond which nothing is seen. With parallel rays the distance of
    /// both planes is in world units, whatever the scale, as in Mitsuba.
    pub far_clip: f64,
}

/// How film points look into camera space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum SensorModel {
    /// Through the origin.
    Perspective {
        /// Horizontal field of view of the whole film, radians.
        fov_x: f64,
        /// Offset of the principal point from the centre of the film, in film
        /// widths and heights.
        principal_point_offset: [f64; 2],
    },
    /// Through a disk around the origin, sharp at one depth.
    ThinLens {
        /// Horizontal field of view of the whole film, radians.
        fov_x: f64,
        /// Radius of the disk, camera units.
        aperture_radius: f64,
        /// Depth that is sharp, camera units.
        focus_distance: f64,
    },
    /// Along the view axis; the film is two camera units wide.
    Orthographic,
}

/// A number of the sensor besides its place, as index in
/// [`SensorState::optics`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Optic {
    /// Horizontal field of view, radians.
    FovX,
    /// Radius of the lens, camera units.
    ApertureRadius,
    /// Depth that is sharp, camera units.
    FocusDistance,
}

/// The numbers of a sensor that can move, over any scalar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SensorState<R> {
    /// World-space images of the camera's axes: the columns of
    /// `world_from_camera`.
    pub axes: [Vec3<R>; 3],
    /// Where it stands.
    pub origin: Vec3<R>,
    /// By [`Optic`]; what a model does not have is not read.
    pub optics: Vec3<R>,
}

impl SensorModel {
    /// Name of the plugin.
    pub fn plugin(&self) -> &'static str {
        match self {
            Self::Perspective { .. } => "perspective",
            Self::ThinLens { .. } => "thinlens",
            Self::Orthographic => "orthographic",
        }
    }

    /// The number, if the model has it.
    pub fn optic(&self, optic: Optic) -> Option<f64> {
        { *self }.optic_mut(optic).copied()
    }

    /// The number, to be changed.
    pub fn optic_mut(&mut self, optic: Optic) -> Option<&mut f64> {
        match (self, optic) {
            (Self::Perspective { fov_x, .. } | Self::ThinLens { fov_x, .. }, Optic::FovX) => {
                Some(fov_x)
            }
            (
                Self::ThinLens {
                    aperture_radius, ..
                },
                Optic::ApertureRadius,
            ) => Some(aperture_radius),
            (Self::ThinLens { focus_distance, .. }, Optic::FocusDistance) => Some(focus_distance),
            (Self::Perspective { .. } | Self::Orthographic, _) => None,
        }
    }

    /// True if rays of one film point start at different places of a lens.
    pub fn has_lens(&self) -> bool {
        matches!(self, Self::ThinLens { .. })
    }
}

impl Optic {
    /// All of them, in the order of their numbers.
    pub const ALL: [Self; 3] = [Self::FovX, Self::ApertureRadius, Self::FocusDistance];

    /// What Mitsuba calls it.
    pub fn name(self) -> &'static str {
        match self {
            Self::FovX => "x_fov",
            Self::ApertureRadius => "aperture_radius",
            Self::FocusDistance => "focus_distance",
        }
    }
}

impl Sensor {
    /// Where it stands, in world space.
    pub fn origin(&self) -> Vec3 {
        self.world_from_camera.translation
    }

    /// Its numbers as they are.
    pub fn state(&self) -> SensorState<f64> {
        let [a, b, c] = self.world_from_camera.rows;
        let optic = |optic| self.model.optic(optic).unwrap_or(0.0);
        SensorState {
            axes: [0, 1, 2].map(|i| Vec3::new(a[i], b[i], c[i])),
            origin: self.origin(),
            optics: Vec3::from(Optic::ALL.map(optic)),
        }
    }

    /// True if its numbers are in their range.
    pub fn check(&self) -> Result<(), SceneError> {
        let bad = |name: &str, value: String, expected| {
            let name = format!("{}.{name}", self.id);
            Err(SceneError::BadNumber {
                name,
                value,
                expected,
            })
        };
        if self.world_from_camera.inverse().is_none() || !is_within_reach(self.origin()) {
            return bad(
                "to_world",
                self.world_from_camera.to_string(),
                "a matrix of finite numbers, none above 1e30, that can be inverted",
            );
        }
        let number = |optic| self.model.optic(optic);
        if let Some(fov_x) = number(Optic::FovX)
            && !(fov_x > 0.0 && fov_x < std::f64::consts::PI)
        {
            return bad(
                "fov",
                format!("{} degrees", fov_x.to_degrees()),
                "an angle between 0 and 180 degrees",
            );
        }
        if let Some(radius) = number(Optic::ApertureRadius)
            && !(radius >= 0.0 && radius.is_finite())
        {
            return bad("aperture_radius", radius.to_string(), "0 or more");
        }
        if let Some(distance) = number(Optic::FocusDistance)
            && !(distance > 0.0 && distance.is_finite())
        {
            return bad("focus_distance", distance.to_string(), "a depth above 0");
        }
        if !(self.near_clip >= 0.0 && self.far_clip > self.near_clip) {
            return bad(
                "near_clip",
                format!("{} with far_clip {}", self.near_clip, self.far_clip),
                "0 <= near_clip < far_clip",
            );
        }
        match self.model {
            SensorModel::Perspective {
                principal_point_offset: offset,
                ..
            } if !offset.iter().all(|x| x.is_finite()) => bad(
                "principal_point_offset",
                format!("{offset:?}"),
                "finite numbers",
            ),
            SensorModel::Perspective { .. }
            | SensorModel::ThinLens { .. }
            | SensorModel::Orthographic => Ok(()),
        }
    }
}
