//! Warped-area sampling as a method: of directions, and in path space.

use capwalk_boundary::{Accel, Boundaries, CustomField, Flow, Method, Numbers, Refusal, Viewpoint};
use capwalk_math::Vec3;
use capwalk_walk::WalkSettings;

use super::was_settings::WasSettings;
use super::{psdr_was as path_space, was as directions};

/// Warped-area sampling. Biased, less with more auxiliary rays; what is seen in mirrors is not
/// covered.
pub fn was(settings: WasSettings) -> Method {
    method(Space::Directions, settings)
}

/// Warped-area sampling in path space. Biased like [`was`].
pub fn psdr_was(settings: WasSettings) -> Method {
    method(Space::Paths, settings)
}

fn method(space: Space, settings: WasSettings) -> Method {
    // Methods live as long as the program, which makes few of them.
    Method::Custom(Box::leak(Box::new(WarpedArea { space, settings })))
}

/// Where the weighted mean is.
#[derive(Debug)]
enum Space {
    Directions,
    Paths,
}

#[derive(Debug)]
struct WarpedArea {
    space: Space,
    settings: WasSettings,
}

impl CustomField for WarpedArea {
    fn name(&self) -> &'static str {
        match self.space {
            Space::Directions => "was",
            Space::Paths => "psdr-was",
        }
    }

    fn is_unbiased(&self) -> bool {
        false
    }

    fn walks(&self) -> bool {
        false
    }

    fn check(&self, _: &Boundaries, _: &WalkSettings) -> Result<(), Refusal> {
        self.settings.check()
    }

    fn flow(
        &self,
        accel: &Accel,
        _: &Boundaries,
        viewpoint: &Viewpoint<f64>,
        q: Vec3,
        _: &WalkSettings,
        random: Numbers,
    ) -> Option<Flow> {
        let flow = match self.space {
            Space::Directions => directions::flow,
            Space::Paths => path_space::flow,
        };
        Some(flow(accel, viewpoint, q, &self.settings, &random.branch()))
    }
}
