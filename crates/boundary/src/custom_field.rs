//! Velocity fields that are not capwalk's own: what they must answer to be compared with those.

use std::fmt::Debug;

use capwalk_math::Vec3;
use capwalk_walk::WalkSettings;
use serde::{Serialize, Serializer};

use crate::accel::Accel;
use crate::boundaries::Boundaries;
use crate::draw::Numbers;
use crate::flow::Flow;
use crate::refusal::Refusal;
use crate::viewpoint::Viewpoint;

/// A velocity field of your own. As [`Method::Custom`](crate::Method::Custom) it differentiates
/// images in forward mode and losses in reverse mode, with all else that the renderer has: paths,
/// materials, filters, finite differences to check against, standard errors, work in parts.
///
/// The field says how each direction around a point moves while the scene does. The derivative is
/// unbiased if the field is continuous, moves with every silhouette where it meets one, and has the
/// divergence that it states. Where it is constant beside a silhouette that moves, as this one is,
/// what moves there is missing:
///
/// ```
/// use capwalk_boundary::{Accel, Boundaries, CustomField, Flow, Method, Numbers, Viewpoint};
/// use capwalk_math::Vec3;
/// use capwalk_walk::WalkSettings;
///
/// /// No direction moves: derivatives of what is seen, without those of silhouettes.
/// #[derive(Debug)]
/// struct Still;
///
/// impl CustomField for Still {
///     fn name(&self) -> &'static str {
///         "still"
///     }
///     fn is_unbiased(&self) -> bool {
///         false
///     }
///     fn walks(&self) -> bool {
///         false
///     }
///     fn flow(
///         &self,
///         _: &Accel,
///         _: &Boundaries,
///         _: &Viewpoint<f64>,
///         _: Vec3,
///         _: &WalkSettings,
///         _: Numbers,
///     ) -> Option<Flow> {
///         Some(Flow::default())
///     }
/// }
///
/// let method = Method::Custom(&Still);
/// assert_eq!(method.name(), "still");
/// ```
///
/// A custom field is one around points: scenes with parallel rays, hard shadows or discontinuous
/// textures in which something moves are refused. Silhouettes behind specular events are not
/// covered; they are refused if the field is unbiased, and missing otherwise.
///
/// Its name and what `Debug` says of it are its identity: by them methods are compared, and parts
/// of a work told from those of another. So all settings must be in the text, as derived ones are.
pub trait CustomField: Debug + Sync {
    /// Its name in files and messages.
    fn name(&self) -> &'static str;

    /// True if it is unbiased: what it does not cover is refused.
    fn is_unbiased(&self) -> bool;

    /// True if it walks as `settings` say: these must then give a continuous field.
    fn walks(&self) -> bool;

    /// A refusal if the field cannot be had among these boundaries, or with these settings.
    /// [`Refusal::Custom`] is for reasons of its own.
    fn check(&self, _boundaries: &Boundaries, _settings: &WalkSettings) -> Result<(), Refusal> {
        Ok(())
    }

    /// A sample of the velocity of the unit direction `q` from a viewpoint, and of the divergence
    /// of the field there, as a linear map from the velocities of boundary points and of the
    /// viewpoint. `None` where the field is that of [`Method::Walk`](crate::Method::Walk) among
    /// all silhouettes, those of emitters included.
    ///
    /// Uses the numbers of `random` from its first dimension on, or a stream of its own
    /// ([`Numbers::branch`]), and no other random numbers: equal seeds give equal bits.
    fn flow(
        &self,
        accel: &Accel,
        boundaries: &Boundaries,
        viewpoint: &Viewpoint<f64>,
        q: Vec3,
        settings: &WalkSettings,
        random: Numbers,
    ) -> Option<Flow>;
}

impl dyn CustomField {
    /// What tells it from other fields.
    fn identity(&self) -> (&'static str, String) {
        (self.name(), format!("{self:?}"))
    }
}

impl PartialEq for dyn CustomField {
    fn eq(&self, other: &Self) -> bool {
        self.identity() == other.identity()
    }
}

/// What tells it from other fields: enough for a fingerprint, not to make it again.
impl Serialize for dyn CustomField {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.identity().serialize(serializer)
    }
}
