//! What lobes do where the normal turns away from the viewer.

use capwalk_math::Rgb;
use capwalk_scene::lobe::*;

use crate::table;
use crate::tools::direction;

/// Opaque lobes are continuous where `wi` passes the horizon.
#[test]
fn one_sided_lobes_are_continuous_across_the_horizon() {
    for (name, lobe) in table::smooth() {
        if lobe.is_two_sided() {
            continue;
        }
        let bsdf = LocalBsdf::from(lobe);
        let wo = direction(0.5, 1.0);
        let [above, below] = [1e-9, -1e-9].map(|cos| direction(cos, 2.0));
        let (a, b) = (bsdf.eval(above, wo), bsdf.eval(below, wo));
        assert!(a.r > 0.0, "{name}");
        assert!((a - b).length() < 1e-6 * a.length(), "{name}: {a:?} {b:?}");
        let (a, b) = (bsdf.pdf(above, wo), bsdf.pdf(below, wo));
        assert!((a - b).abs() < 1e-6 * a, "{name}: {a:?} {b:?}");
    }
}

/// The face decides: two-sided lobes answer for the side they are told.
#[test]
fn the_side_that_is_seen_can_be_told() {
    let (inside, outside) = (direction(-0.2, 2.0), direction(0.2, 2.0));
    for (name, lobe) in table::smooth() {
        let front = LocalBsdf::from(lobe.clone()).seen_from(Side::Front);
        let back = LocalBsdf::from(lobe.clone()).seen_from(Side::Back);
        for wo in [direction(0.5, 1.0), direction(-0.4, 5.0)] {
            assert_eq!(front.eval(inside, wo), lobe.eval(outside, wo), "{name}");
            assert_eq!(front.pdf(inside, wo), lobe.pdf(outside, wo), "{name}");
            if lobe.is_two_sided() {
                assert_eq!(back.eval(outside, wo), lobe.eval(inside, wo), "{name}");
                assert_eq!(back.pdf(outside, wo), lobe.pdf(inside, wo), "{name}");
            } else {
                assert_eq!(back.eval(inside, wo), Rgb::zero(), "{name}");
                assert_eq!(back.pdf(inside, wo), 0.0, "{name}");
                assert_eq!(back.sample(inside, 0.5, [0.5, 0.5]), None, "{name}");
                assert!(!back.has_smooth(), "{name}");
            }
        }
    }
}

/// Nothing is reflected below the surface by lobes that do not transmit.
#[test]
fn one_sided_lobes_are_black_below() {
    for (name, lobe) in table::smooth() {
        if !lobe.is_two_sided() {
            for wi in table::views(&lobe) {
                assert_eq!(lobe.eval(wi, direction(-0.1, 0.3)), Rgb::zero(), "{name}");
                assert_eq!(lobe.pdf(wi, direction(-0.1, 0.3)), 0.0, "{name}");
            }
        }
    }
}
