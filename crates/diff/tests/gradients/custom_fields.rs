//! Velocity fields of one's own: in both modes, against finite differences, in parts, and what they
//! refuse.

use std::borrow::Cow;

use crate::common::agree::{Case, agree_by, tangent};
use crate::common::both_modes::{self, everything, small};
use crate::common::refused::refusals_with;
use crate::common::stages::*;
use capwalk_boundary::{
    Accel, Boundaries, CustomField, Flow, FlowSource, Numbers, Refusal, Viewpoint,
};
use capwalk_diff::{
    GradientOptions, GradientWork, Method, Part, PreparedScene, RenderOptions, Unwatched,
    WalkSettings, gradient,
};
use capwalk_math::Vec3;

/// Directions move with the points of the plane z = 0 that they meet, which move like its first
/// vertex: where nothing else is to be seen, as everything is.
#[derive(Debug)]
struct OnePlane {
    /// All of the motion but for tests.
    part: f64,
}

impl CustomField for OnePlane {
    fn name(&self) -> &'static str {
        "one plane"
    }

    fn is_unbiased(&self) -> bool {
        true
    }

    fn walks(&self) -> bool {
        false
    }

    fn flow(
        &self,
        _: &Accel,
        _: &Boundaries,
        viewpoint: &Viewpoint<f64>,
        q: Vec3,
        _: &WalkSettings,
        _: Numbers,
    ) -> Option<Flow> {
        // A velocity v of the plane turns q by P_q v / r, where 1 / r = -q.z / h and h is the
        // viewpoint's height over the plane.
        let z = Vec3::new(0.0, 0.0, 1.0);
        let scale = -self.part / viewpoint.position.z;
        let axes: [Vec3; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
        let columns = axes.map(|axis| axis.reject_from(q) * (q.z * scale));
        let divergence = (z - q * (3.0 * q.z)) * scale;
        let mut flow = Flow::default();
        flow.add(FlowSource::Point(0), columns, divergence);
        flow.add(
            FlowSource::Viewpoint,
            columns.map(|column| -column),
            -divergence,
        );
        Some(flow)
    }
}

const ONE_PLANE: Method = Method::Custom(&OnePlane { part: 1.0 });

/// A field without a flow anywhere, which refuses walks of seven steps.
#[derive(Debug)]
struct Nowhere;

impl CustomField for Nowhere {
    fn name(&self) -> &'static str {
        "nowhere"
    }

    fn is_unbiased(&self) -> bool {
        true
    }

    fn walks(&self) -> bool {
        true
    }

    fn check(&self, boundaries: &Boundaries, settings: &WalkSettings) -> Result<(), Refusal> {
        match settings.steps {
            7 => Err(Refusal::Custom {
                reason: format!("seven steps among {} edges", boundaries.edges().len()),
                instead: Some("Use six".into()),
            }),
            _ => Ok(()),
        }
    }

    fn flow(
        &self,
        _: &Accel,
        _: &Boundaries,
        _: &Viewpoint<f64>,
        _: Vec3,
        _: &WalkSettings,
        _: Numbers,
    ) -> Option<Flow> {
        None
    }
}

const NOWHERE: Method = Method::Custom(&Nowhere);

/// A card and the camera move, along the card and along the view: by a flow, and where there is
/// none along the walk among all silhouettes.
#[test]
fn fields_agree_with_differences() {
    for (motion, step) in [
        ("thing.translate.x - 0.4*sensor.translate.y", 2e-3),
        ("thing.translate.z - 0.5*sensor.translate.z", 0.1),
    ] {
        let scene = card();
        let moves = tangent(&scene, motion);
        let case = Case {
            size: 14,
            step,
            reference_spp: 8000,
            min_pixels: 50,
            ..Case::default()
        };
        let methods = [(ONE_PLANE, 1000), (NOWHERE, 1000)];
        agree_by(&methods, motion, scene, &moves, case);
    }
}

#[test]
fn both_modes_have_the_same_fields() {
    let mut scene = visible_cube();
    small(&mut scene, 3);
    let moves = everything(&scene, 11);
    let prepared = PreparedScene::new(scene);
    for method in [ONE_PLANE, NOWHERE] {
        let options = GradientOptions {
            method,
            ..both_modes::settings(6)
        };
        both_modes::agree_by(method.name(), &prepared, &moves, &options);
    }
}

#[test]
fn fields_refuse_what_they_cannot_have() {
    let scene = with(triangle());
    let moves = tangent(&scene, "thing.translate.x");
    let method = NOWHERE;
    assert_eq!(refusals_with(&scene, &moves, method), [None, None]);
    let mut options = GradientOptions {
        method,
        ..GradientOptions::new(RenderOptions::new(2, 1))
    };
    options.walk.steps = 7;
    let prepared = PreparedScene::new(scene);
    let refusal = gradient(&prepared, &moves, &options, &Unwatched).expect_err("refused");
    let text = refusal.to_string();
    assert!(text.starts_with("seven steps among "), "{text}");
    assert!(text.ends_with(" edges. Use six"), "{text}");
    // It says that it walks, so that no steps are refused, too.
    options.walk.steps = 0;
    let refusal = gradient(&prepared, &moves, &options, &Unwatched);
    assert_eq!(refusal.expect_err("refused"), Refusal::NoSteps);
}

/// Parts are of a field and its settings: those of another do not complete a work.
#[test]
fn parts_know_their_field() {
    let prepared = PreparedScene::new(card());
    let moves = tangent(prepared.scene(), "thing.translate.x");
    let work = |method| {
        let options = GradientOptions {
            method,
            ..GradientOptions::new(RenderOptions::new(8, 3))
        };
        GradientWork::new(&prepared, Cow::Borrowed(&moves), options)
    };
    let part = |method| {
        let work = work(method);
        let part = work.part(&Part::whole(work.grid()), &Unwatched);
        part.expect("a part")
    };
    let whole = work(ONE_PLANE).whole(&Unwatched).expect("covered");
    let again = Method::Custom(&OnePlane { part: 1.0 });
    assert_eq!(again, ONE_PLANE);
    let found = work(ONE_PLANE).finish(part(again)).expect("all of it");
    assert_eq!(found.gradient, whole.gradient);
    let other = Method::Custom(&OnePlane { part: 0.5 });
    for method in [other, NOWHERE, Method::Walk] {
        assert_ne!(method, ONE_PLANE);
        let refused = work(ONE_PLANE).finish(part(method));
        assert!(refused.is_err(), "{method:?}");
    }
}
