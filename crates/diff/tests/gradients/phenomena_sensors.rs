//! Gradients against finite differences, one scene per phenomenon: sensors
//! other than pinholes, and the numbers of sensors.
//!
//! What must hold is that of `phenomena_visible.rs`.

use crate::common::agree::*;
use crate::common::stages::*;
use capwalk_scene::*;

/// A ball 4.3 away, seen through a lens: its silhouettes are three pixels wide.
fn blurred_ball(filter: Filter) -> Scene {
    through_lens(visible_ball(filter), 0.12, 2.9)
}

#[test]
fn ball_out_of_focus() {
    let scene = blurred_ball(Filter::Box);
    let tangent = tangent(&scene, "ball.translate.x");
    let case = Case {
        gradient_spp: 80,
        reference_spp: 300,
        ..primary()
    };
    agree("ball out of focus", scene, &tangent, case);
}

#[test]
fn moving_lens() {
    let scene = through_lens(visible_cube(), 0.12, 2.9);
    let tangent = tangent(&scene, "sensor.translate.x");
    let case = Case {
        step: 1e-3,
        reference_spp: 1000,
        patience: 3.0,
        ..primary()
    };
    agree("lens moves", scene, &tangent, case);
}

/// Turning about its middle moves the other points of the lens.
#[test]
fn turning_lens() {
    let case = Case {
        step: 2.5e-4,
        reference_spp: 1000,
        ..primary()
    };
    let scene = through_lens(visible_cube(), 0.3, 2.9);
    let tangent = tangent(&scene, "sensor.rotate.y");
    agree("lens turns", scene, &tangent, case);
}

/// A shadow out of focus.
#[test]
fn shadow_through_lens() {
    let scene = through_lens(with(triangle()), 0.3, 4.0);
    let tangent = tangent(&scene, "thing.translate.x");
    agree("shadow through a lens", scene, &tangent, Case::default());
}

#[test]
fn opening_lens() {
    let scene = blurred_ball(Filter::Gaussian { stddev: 0.5 });
    let tangent = tangent(&scene, "sensor.aperture_radius");
    let case = Case {
        step: 4e-3,
        gradient_spp: 106,
        reference_spp: 520,
        patience: 5.0,
        ..primary()
    };
    agree("aperture", scene, &tangent, case);
}

#[test]
fn focusing_lens() {
    let scene = blurred_ball(Filter::Tent { radius: 1.0 });
    let tangent = tangent(&scene, "sensor.focus_distance");
    let case = Case {
        step: 0.08,
        ..primary()
    };
    agree("focus", scene, &tangent, case);
}

/// The film moves under the image: everywhere, so that the pixel-border term
/// counts.
#[test]
fn zooming() {
    let scene = visible_cube();
    let tangent = tangent(&scene, "sensor.x_fov");
    let case = Case {
        step: 1.5e-2,
        reference_spp: 1000,
        ..primary()
    };
    agree("field of view", scene, &tangent, case);
}

/// Every entry of the matrix: the camera shears, scales, turns and moves.
#[test]
fn camera_of_any_matrix() {
    let scene = visible_cube();
    let tangent = tangent(
        &scene,
        "0.4*sensor.to_world[0,0] - sensor.to_world[0,1] + 0.5*sensor.to_world[2,1] \
         + sensor.to_world[1,2] + sensor.to_world[2,3]",
    );
    let case = Case {
        step: 2.5e-4,
        reference_spp: 1000,
        ..primary()
    };
    agree("any matrix", scene, &tangent, case);
}
