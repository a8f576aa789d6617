//! Why a run ends before its last iteration.

use std::fs;

use super::{SMALL, examples};
use crate::{Capwalk, assert_has};

#[test]
fn runs_stop_for_a_reason() {
    let capwalk = Capwalk::new("optimize_stops");
    let stop = |name: &str, job: &str, status: i32, parts: &[&str]| {
        capwalk.write(&format!("{name}.toml"), job);
        let finished = capwalk.run(&format!("optimize {name}.toml -o {name}"));
        assert_eq!(finished.status, status, "{name}: {}", finished.stderr);
        assert_has(&finished.stdout, parts);
        capwalk.bytes(&format!("{name}/parameters.npz"));
    };
    let with = |text: &str| format!("{SMALL}{text}");
    stop(
        "below",
        &with("[stop]\nloss_below = 1e9"),
        0,
        &["0 iterations", "at most 1000000000"],
    );
    let patient = "[stop]\npatience = 3";
    let still = with(patient).replace("lr = 0.02", "lr = 1e-300");
    stop(
        "patience",
        &still,
        0,
        &["not become smaller for 3 iterations"],
    );
    // At the optimum, with as many samples as there may be.
    let found = format!("{SMALL}[samples]\nmost = 8").replace("spp = 64", "spp = 4096");
    let one = found
        .split("[[parameter]]\nname = \"floor")
        .next()
        .expect("a parameter");
    let rest = found.split("[optimizer]").nth(1).expect("an optimizer");
    let there = one.replace("bounds = [-1, 1]", "start = 0.2");
    stop(
        "optimum",
        &format!("{there}[optimizer]{rest}").replace("iterations = 40", "iterations = 200"),
        0,
        &[
            "the descent cannot be told from zero",
            "over the last 40 steps",
        ],
    );
    // A floor that reflects less than nothing.
    let outside = SMALL.replace("reparam = \"sigmoid\"", "lr = 10").replace(
        "\"leaf.translate.x\" = 0.2",
        "\"floor.bsdf.reflectance.value\" = 0.01",
    );
    stop(
        "outside",
        &outside,
        1,
        &["leaves what can be rendered", "`bounds`"],
    );
    // A leaf whose corners pass each other.
    let torn = SMALL.replace(
        "name = \"leaf.translate.x\"\nbounds = [-1, 1]",
        "name = \"leaf.positions\"\nvertices = [0]\nalong = [1, 0, 0.7]\nlr = 5",
    );
    stop(
        "torn",
        &torn,
        1,
        &["in the next step face 0 of \"leaf\" turned over"],
    );

    // A leaf that shrinks to nothing and beyond.
    let shrunk = SMALL.replace(
        "name = \"leaf.translate.x\"\nbounds = [-1, 1]",
        "name = \"leaf.scale\"\nlr = 5",
    );
    let shrunk = shrunk.replace("\"leaf.translate.x\" = 0.2", "\"leaf.scale\" = 0.5");
    stop(
        "shrunk",
        &shrunk,
        1,
        &["\"leaf.scale\" would be -", "reparam = \"log\""],
    );

    // Targets take time, too.
    let long = SMALL.replace("spp = 64", "spp = 4000000000");
    capwalk.write("targets.toml", &long);
    let error = capwalk.error("optimize targets.toml --time-limit 1s");
    assert_has(&error, &["ended before the targets were rendered"]);
    // So does what comes before them, whoever gives the limit; a millisecond may be enough for it.
    let is_early = |error: &str| {
        let reasons = ["a sample was taken", "the targets were rendered"];
        let mut words = reasons
            .map(|what| format!("the time limit ended before {what}"))
            .into_iter();
        assert!(words.any(|words| error.contains(&words)), "{error}");
    };
    let error = capwalk.error("optimize targets.toml --time-limit 0.001s");
    is_early(&error);
    capwalk.write("early.toml", &format!("time_limit = \"0.001s\"\n{long}"));
    is_early(&capwalk.error("optimize early.toml"));

    // A target whose light is no number would be black.
    let bright = SMALL.replace(
        "\"leaf.translate.x\" = 0.2",
        "\"lamp.emitter.radiance.value\" = 1e308",
    );
    capwalk.write("bright.toml", &bright);
    let error = capwalk.error("optimize bright.toml -o bright");
    assert_has(
        &error,
        &["the target of view 1", "infinite or NaN", "smaller numbers"],
    );

    // Gradients that cannot be squared.
    let huge = SMALL.replace(
        "leaf.translate.x\"\nbounds",
        "1e308*leaf.translate.x\"\nbounds",
    );
    capwalk.write("huge.toml", &huge);
    let finished = capwalk.run("optimize huge.toml -o huge");
    assert_eq!(finished.status, 4, "{}", finished.stderr);
    assert_has(
        &finished.stdout,
        &["the gradient with respect to unknown 0"],
    );

    let target = "render leaf --size 8x6 --spp 4 -o target.exr";
    assert_eq!(capwalk.run(target).status, 0);
    let rendered = "[target]\nspp = 64\n[target.set]\n\"leaf.translate.x\" = 0.2";
    let limited = SMALL.replace("iterations = 40", "iterations = 100000000");
    let limited = limited.replace(rendered, "target = { image = \"target.exr\" }");
    capwalk.write("limit.toml", &limited);
    let limited = capwalk.run("optimize limit.toml --time-limit 1s");
    assert_eq!(limited.status, 0, "{}", limited.stderr);
    assert_has(&limited.stdout, &["the time limit is over"]);
}

/// A sheet that crosses itself is refused before the first step, unless the guard is
/// off.
#[test]
fn meshes_that_cross_themselves_are_refused() {
    let capwalk = Capwalk::new("optimize_crossing");
    let scene = fs::read(examples().join("flower/scene.xml")).expect("the example");
    fs::write(capwalk.path("scene.xml"), scene).expect("writable");
    let crossing = "v -0.5 1.5 0\nv 0.5 1.5 0\nv 0 1.5 0.5\nv 0 1.2 0.2\nv 0 1.8 0.2\n\
                    v 0.1 1.5 -1\nf 1 2 3\nf 4 5 6\n";
    capwalk.write("crossing.obj", crossing);
    let job = r#"
scene = "scene.xml"
defines = { occluder = "crossing.obj" }
size = [8, 6]
iterations = 1
spp = 4
target = { set = { "sheet.translate.x" = 0.1 } }
parameter = [{ name = "sheet.positions", along = "normals" }]
optimizer = { lr = 1e-3 }
"#;
    capwalk.write("job.toml", job);
    let error = capwalk.error("optimize job.toml");
    let parts = [
        "job.toml:8:",
        "before the first step",
        "faces 0 and 1 of \"sheet\" cross",
    ];
    assert_has(&error, &parts);
    capwalk.write(
        "job.toml",
        &format!("{job}guards = {{ self_intersection = false }}\n"),
    );
    let json = capwalk.json("optimize job.toml --json");
    assert_eq!(json["unknowns"], 6);
}

#[cfg(unix)]
#[test]
fn ctrl_c_writes_what_is_done() {
    let capwalk = Capwalk::new("optimize_ctrl_c");
    capwalk.write(
        "job.toml",
        &SMALL.replace("iterations = 40", "iterations = 100000000"),
    );
    let finished = capwalk.interrupt(
        "-INT",
        "optimize job.toml --json -v",
        "iteration 0: loss",
        || {
            // Nobody else may write there meanwhile.
            let second = capwalk.error("optimize job.toml --resume");
            assert_has(&second, &["another run is writing"]);
        },
    );
    assert_eq!(finished.status, 5, "{}", finished.stderr);
    let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
    assert_eq!(json["stopped"], "interrupted");
    capwalk.bytes("out/parameters.npz");
}
