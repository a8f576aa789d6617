//! Several sensors: what each sees after changes, and while they take turns.

use super::*;
use capwalk_diff::{GradientOptions, Method, RenderOptions, Unwatched};

/// Two cameras, one to the left and one to the right of a box.
fn views() -> Views {
    let sensor = |id: &str, x: f64| {
        format!(
            "<sensor type=\"perspective\" id=\"{id}\">\
             <transform name=\"to_world\"><translate x=\"{x}\" z=\"-6\"/></transform>\
             <sampler type=\"independent\"><integer name=\"sample_count\" value=\"4\"/></sampler>\
             <film type=\"hdrfilm\"><integer name=\"width\" value=\"8\"/>\
             <integer name=\"height\" value=\"6\"/></film></sensor>"
        )
    };
    let (left, right) = (sensor("left", -1.0), sensor("right", 1.0));
    let text = format!(
        "<scene version=\"3.0.0\"><integrator type=\"path\"/>{left}{right}\
         <emitter type=\"constant\"/><shape type=\"cube\" id=\"box\"/></scene>"
    );
    let loaded = capwalk_scene_io::load_scene_str(&text, "".as_ref(), "text", &[]);
    let loaded = loaded.expect("a scene");
    Views::new(loaded.scene, loaded.sensors).expect("it can be rendered")
}

fn image(views: &Views, sensor: usize) -> capwalk_scene::Image {
    let view = ViewId { sensor, aov: None };
    let prepared = views.prepared(view).expect("it is there");
    let options = RenderOptions::new(4, 1);
    let image = prepared.render(&options, &Unwatched).expect("samples");
    image.value.mean
}

/// With walks and with sampled edges, which have trees of their own.
fn gradient(views: &Views, sensor: usize) -> [capwalk_scene::Image; 2] {
    let view = ViewId { sensor, aov: None };
    let prepared = views.prepared(view).expect("it is there");
    [Method::Walk, Method::EDGES].map(|method| {
        let options = GradientOptions {
            method,
            ..RenderOptions::new(4, 1).into()
        };
        let gradient = prepared.gradient("box.translate.x", &options, &Unwatched);
        gradient.expect("covered").gradient.mean
    })
}

/// A change of the scene is seen from everywhere, that of a sensor by it alone; and what
/// was looked at before answers like what was not.
#[test]
fn changes_are_seen_from_everywhere() {
    let mut views = views();
    let before = [image(&views, 0), image(&views, 1)];
    assert!(before[0] != before[1]);

    let name = "box.bsdf.reflectance.value";
    views.update(&[(name, &[0.9, 0.1, 0.1])]).expect("a colour");
    let mut fresh = self::views();
    fresh.update(&[(name, &[0.9, 0.1, 0.1])]).expect("a colour");
    for i in [0, 1] {
        assert!(image(&views, i) != before[i]);
        assert!(image(&views, i) == image(&fresh, i));
    }

    let old = [image(&views, 0), image(&views, 1)];
    let place = views.values("left.to_world").expect("it has one");
    views
        .update(&[("right.to_world", &place.numbers)])
        .expect("a matrix");
    assert!(image(&views, 0) == old[0]);
    assert!(image(&views, 1) == old[0]);
    let bytes = views.to_bytes().expect("it has bytes");
    let mut copy = Views::from_bytes(&bytes).expect("a scene");
    assert!(image(&copy, 1) == old[0]);
    let bytes = self::views().to_bytes().expect("it has bytes");
    copy.replace_by_bytes(&bytes).expect("a scene");
    assert!(image(&copy, 1) == before[1]);
    assert_eq!(views.values("right.to_world").expect("there"), place);
}

/// Sensors that take turns with one set of trees see what each sees with its own, also after
/// changes, in another size and along derivatives.
#[test]
fn sensors_take_turns() {
    let turning = |views: &mut Views, sensor: usize| {
        let view = ViewId { sensor, aov: None };
        views.turn(view).expect("it can be rendered");
        gradient(views, sensor)
    };
    let (mut turned, mut apart) = (views(), views());
    let gradients = [0, 1].map(|sensor| gradient(&apart, sensor));
    assert!(gradients[0] != gradients[1]);
    for sensor in [0, 1, 1, 0, 1] {
        assert!(turning(&mut turned, sensor) == gradients[sensor]);
        let ready = turned.prepared.iter().filter(|view| view.get().is_some());
        assert_eq!(ready.count(), 1);
    }
    for views in [&mut turned, &mut apart] {
        let numbers = views.values("box.positions").expect("there").numbers;
        let moved: Vec<f64> = numbers.iter().map(|x| 1.1 * x + 0.2).collect();
        views
            .update(&[("box.positions", &moved)])
            .expect("a motion");
    }
    for sensor in [0, 1] {
        assert!(turning(&mut turned, sensor) == gradient(&apart, sensor));
    }
    for views in [&mut turned, &mut apart] {
        views.resize([5, 7]).expect("a size");
    }
    for sensor in [0, 1] {
        assert!(turning(&mut turned, sensor) == gradient(&apart, sensor));
    }
    // What shows something else keeps its own trees.
    let mask = ViewId {
        sensor: 0,
        aov: Some(Aov::Mask),
    };
    turned.turn(mask).expect("nothing to turn");
    assert!(turned.prepared[mask.place()].get().is_none());
    assert!(image(&turned, 1) == image(&apart, 1));
}

/// Parameters would have two meanings.
#[test]
fn ids_are_not_shared() {
    let views = views();
    for (sensor, id) in [(1, "left"), (1, "box"), (0, "box")] {
        let mut sensors = views.sensors().to_vec();
        sensors[sensor].sensor.id = id.into();
        let error = Views::new(views.scene().clone(), sensors).expect_err("it is taken");
        let text = format!("{error:?}");
        assert!(
            text.contains(&format!("DuplicateId {{ id: \"{id}\"")),
            "{text}"
        );
    }
}

/// Each view has its own place, in the order of all of them.
#[test]
fn places_are_in_order() {
    assert!(
        ViewId::all(3)
            .map(ViewId::place)
            .eq(0..3 * (1 + Aov::ALL.len()))
    );
}

/// What was relative to the scene as it was is so again.
#[test]
fn scenes_are_restored() {
    let (was, mut views) = (views(), views());
    for x in [0.5, 0.5] {
        let changes: [(&str, &[f64]); 1] = [("left.translate", &[x, 0.0, 0.0])];
        views.restore(&was, &changes).expect("a motion");
    }
    let mut once = self::views();
    once.update(&[("left.translate", &[0.5, 0.0, 0.0])])
        .expect("a motion");
    assert_eq!(
        views.values("left.to_world").ok(),
        once.values("left.to_world").ok()
    );
    assert!(image(&views, 0) == image(&once, 0));
}

#[test]
fn sensors_are_named() {
    let mut views = views();
    let names: Vec<String> = views.arrays().into_iter().map(|a| a.name).collect();
    assert!(names.contains(&"left.to_world".into()) && names.contains(&"right.to_world".into()));
    let error = views.values("sensor.to_world").expect_err("two are meant");
    assert!(error.to_string().contains("left, right"), "{error}");
    let error = views
        .prepared(ViewId {
            sensor: 2,
            aov: None,
        })
        .expect_err("two");
    assert!(error.to_string().contains("it has 2"), "{error}");
    // Of what another sensor has, it is said so.
    let view = ViewId {
        sensor: 0,
        aov: None,
    };
    let left = views.prepared(view).expect("it is there");
    let options = RenderOptions::new(4, 1).into();
    let error = |name: &str| {
        let error = left
            .gradient(name, &options, &Unwatched)
            .expect_err("not its own");
        views.explain(view, error).to_string()
    };
    let text = error("left.translate.x - right.translate.x");
    assert!(text.contains("the image of left does not"), "{text}");
    for typo in ["rihgt.translate.x", "right.translat.x", "left.translat.x"] {
        let text = error(typo);
        assert!(
            text.contains("no parameter") && text.contains("mean"),
            "{text}"
        );
    }
    // Nothing is changed if something is wrong.
    let old = views.values("box.positions").expect("there").numbers;
    let moved: Vec<f64> = old.iter().map(|x| x + 1.0).collect();
    let changes: [(&str, &[f64]); 2] = [("box.positions", &moved), ("left.to_world", &[1.0])];
    assert!(views.update(&changes).is_err());
    assert_eq!(views.values("box.positions").expect("there").numbers, old);
}
