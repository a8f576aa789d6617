//! `capwalk optimize`: what it finds, what it writes, how it stops, and that a run
//! which is killed at any moment ends in the same bits.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::time::{Duration, Instant};

use capwalk_scene_io::arrays::{self, Arrays};

use crate::{Capwalk, assert_has};

/// Milliseconds of work per iteration.
const SMALL: &str = r#"
scene = "leaf"
size = [8, 6]
output = "out"
iterations = 40
spp = 4
seed = 5
pictures = 7

[target]
spp = 64
[target.set]
"leaf.translate.x" = 0.2

[[parameter]]
name = "leaf.translate.x"
bounds = [-1, 1]

[[parameter]]
name = "floor.bsdf.reflectance.value"
reparam = "sigmoid"

[[parameter]]
name = "lamp.emitter.radiance.value.g"
reparam = "log"

[optimizer]
lr = 0.02
"#;

fn arrays_of(path: &Path) -> Arrays {
    arrays::read(path).expect("readable")
}

/// All files below a folder that two equal runs share, with their bytes.
fn files(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(next).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if !path.ends_with("timing.csv") {
                let name = path.strip_prefix(folder).expect("it is below").to_owned();
                found.push((name, fs::read(path).expect("readable")));
            }
        }
    }
    found.sort();
    found
}

#[track_caller]
fn assert_same_files(a: &Path, b: &Path) {
    let (a, b) = (files(a), files(b));
    let names = |files: &[(PathBuf, Vec<u8>)]| -> Vec<PathBuf> {
        files.iter().map(|(name, _)| name.clone()).collect()
    };
    assert_eq!(names(&a), names(&b));
    for ((name, a), (_, b)) in a.iter().zip(&b) {
        assert!(a == b, "{} differs", name.display());
    }
}

/// The kills must hit runs at work, and there must be twenty of them. The moments
/// are those of a fixed sequence, scaled by how long a run takes.
#[test]
fn a_run_killed_twenty_times_ends_in_the_same_bits() {
    const KILLS: usize = 20;
    let capwalk = Capwalk::new("optimize_killed");
    // Long enough for twenty kills, most of them after some iterations.
    let job = SMALL.replace("iterations = 40", "iterations = 400");
    capwalk.write("job.toml", &job);
    let started = Instant::now();
    let whole = capwalk.run("optimize job.toml -o whole -t 1");
    let duration = started.elapsed();
    assert_eq!(whole.status, 0, "{}", whole.stderr);
    // How long it takes to start, read the job and render the target.
    let none = job.replace("iterations = 400", "iterations = 0");
    capwalk.write("none.toml", &none);
    let started = Instant::now();
    assert_eq!(capwalk.run("optimize none.toml -o none").status, 0);
    let start = started.elapsed();

    let (mut kills, mut resumed, mut state) = (0, 0, 12345_u64);
    while kills < KILLS {
        // A number in [0, 1) that looks random.
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        let random = (state >> 33) as f64 / (1_u64 << 31) as f64;
        let share = duration.saturating_sub(start) / KILLS as u32;
        let moment = start.mul_f64(0.7) + (share + start.mul_f64(0.3)).mul_f64(random);
        let mut command = capwalk.command("optimize job.toml -o killed --resume -t 2");
        let child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn();
        let mut child = child.expect("it starts");
        std::thread::sleep(moment);
        match child.try_wait().expect("it can be asked") {
            Some(_) => {
                let finished = crate::Finished::from(child.wait_with_output().expect("it ended"));
                panic!("it ended before {kills} kills: {}", finished.stderr);
            }
            None => {
                child.kill().expect("it can be killed"); // SIGKILL
                child.wait().expect("it ends");
                kills += 1;
            }
        }
        let checkpoint = capwalk.path("killed/checkpoint.npz");
        if checkpoint.exists() {
            let counts = arrays_of(&checkpoint);
            let done = counts.get("iterations").expect("counts").numbers[0];
            resumed += usize::from(done > 0.0);
        }
    }
    assert!(
        resumed > KILLS / 2,
        "{resumed} kills after the first iteration"
    );
    let last = capwalk.run("optimize job.toml -o killed --resume");
    assert_eq!(last.status, 0, "{}", last.stderr);
    assert_same_files(&capwalk.path("whole"), &capwalk.path("killed"));
    // Once more, when all is done.
    assert_eq!(
        capwalk.run("optimize job.toml -o killed --resume").status,
        0
    );
    assert_same_files(&capwalk.path("whole"), &capwalk.path("killed"));
}

/// What is left when a run is cut off between any two things that it writes.
#[test]
fn every_order_of_writing_can_be_resumed() {
    let capwalk = Capwalk::new("optimize_torn");
    capwalk.write("job.toml", SMALL);
    assert_eq!(capwalk.run("optimize job.toml -o whole").status, 0);
    let whole = String::from_utf8(capwalk.bytes("whole/record.csv")).expect("text");
    let short = SMALL.replace("iterations = 40", "iterations = 12");
    for (case, rows) in [("torn_row", 12), ("more_rows", 20), ("exact", 12)] {
        capwalk.write("short.toml", &short);
        assert_eq!(
            capwalk
                .run(&format!("optimize short.toml -o {case}"))
                .status,
            0
        );
        // As if the run had been cut off after `rows` rows and 12 checkpoints.
        let mut text: String = whole.split_inclusive('\n').take(1 + rows).collect();
        if case == "torn_row" {
            text += "12,0.03";
        }
        capwalk.write(&format!("{case}/record.csv"), &text);
        capwalk.write(&format!("{case}/.parameters.npz.99.tmp"), "half");
        let resumed = capwalk.run(&format!("optimize job.toml -o {case} --resume"));
        assert_eq!(resumed.status, 0, "{case}: {}", resumed.stderr);
        assert_has(&resumed.stderr, &["going on after iteration 12"]);
        // The short run drew its last picture, which the whole one did not.
        fs::remove_file(capwalk.path(&format!("{case}/pictures/000012.png"))).expect("there");
        assert_same_files(&capwalk.path("whole"), &capwalk.path(case));
    }
    // Fewer rows than the checkpoint knows cannot be made up.
    let text: String = whole.split_inclusive('\n').take(6).collect();
    capwalk.write("exact/record.csv", &text);
    let error = capwalk.error("optimize job.toml -o exact --resume");
    assert_has(&error, &["record.csv", "does not have the rows of the 40"]);
}

/// The same bits with any number of threads, and the numbers that were hidden.
#[test]
fn hidden_numbers_are_found() {
    let capwalk = Capwalk::new("optimize_found");
    let job = fs::read_to_string(examples().join("lamp_and_leaf.toml")).expect("the example");
    let documented = fs::read_to_string(examples().join("../../docs/optimize.md")).expect("a page");
    let documented = documented.split("```toml\n").nth(1).expect("an example");
    let documented = documented.split("```").next().expect("its end");
    assert!(
        job.ends_with(documented),
        "docs/optimize.md shows another job"
    );
    let job = job.replace("size = [40, 30]", "size = [24, 18]");
    for seed in [3, 4, 5] {
        let job = job.replace("seed = 3", &format!("seed = {seed}"));
        capwalk.write("job.toml", &job);
        let json = capwalk.json(&format!("optimize job.toml -o found{seed} --json"));
        assert_eq!(json["iterations"], 80);
        assert_eq!(json["unknowns"], 4);
        assert_eq!(json["stopped"], "all iterations are done");
        let found = arrays_of(&capwalk.path(&format!("found{seed}/parameters.npz")));
        let numbers = |name: &str| found.get(name).expect(name).numbers.clone();
        let x = numbers("leaf.translate.x")[0];
        assert!((x - 0.2).abs() < 0.02, "{seed}: {x}");
        let floor = numbers("floor.bsdf.reflectance.value");
        for (found, hidden) in floor.iter().zip([0.5, 0.6, 0.3]) {
            assert!((found - hidden).abs() < 0.01, "{seed}: {floor:?}");
        }
    }
    // Another seed, another way.
    let record = |seed: u32| capwalk.bytes(&format!("found{seed}/record.csv"));
    assert_ne!(record(3), record(4));
    // The exported scene has them.
    let info = capwalk.json("info found5/scene.xml --json");
    let listed = info["parameters"].as_array().expect("a list");
    let floor = listed
        .iter()
        .find(|p| p["name"] == "floor.bsdf.reflectance.value");
    let red = floor.expect("there")["value"][0]
        .as_f64()
        .expect("a number");
    assert!((red - 0.5).abs() < 0.01, "{red}");
}

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/jobs")
}

/// The example of figure 12 is read, has its fifty unknowns, and gets better.
#[test]
fn the_flower_has_fifty_unknowns() {
    let capwalk = Capwalk::new("optimize_flower");
    for file in ["scene.xml", "disk.obj", "flower.obj"] {
        let bytes = fs::read(examples().join("flower").join(file)).expect("the example");
        fs::write(capwalk.path(file), bytes).expect("writable");
    }
    let job = fs::read_to_string(examples().join("flower/job.toml")).expect("the example");
    let job = job.replace("iterations = 150", "iterations = 12\nsize = [24, 18]");
    capwalk.write("job.toml", &job.replace("spp = 1024", "spp = 64"));
    let json = capwalk.json("optimize job.toml --json");
    assert_eq!(json["unknowns"], 50);
    let record = String::from_utf8(capwalk.bytes("out/record.csv")).expect("text");
    let loss = |row: usize| -> f64 {
        let row = record.lines().nth(1 + row).expect("a row");
        row.split(',')
            .nth(1)
            .expect("a loss")
            .parse()
            .expect("a number")
    };
    assert!(loss(12) < 0.5 * loss(0), "{} {}", loss(0), loss(12));
    let positions = arrays_of(&capwalk.path("out/parameters.npz"));
    let positions = positions.get("sheet.positions").expect("there");
    assert_eq!(positions.shape, [26, 3]);
    assert!(
        positions
            .numbers
            .iter()
            .skip(1)
            .step_by(3)
            .all(|&y| y == 1.5)
    );
    capwalk.bytes("out/pictures/000000.png");
    capwalk.bytes("out/pictures/000012.png");
}

/// A view of its own sensor and mask with a target from a file, beside another.
#[test]
fn several_views_with_masks_and_files() {
    let capwalk = Capwalk::new("optimize_views");
    assert_eq!(
        capwalk
            .run("render leaf --size 8x6 --spp 64 -o target.exr")
            .status,
        0
    );
    let mut mask = capwalk_scene::Image::new(8, 6);
    mask.pixels[..24].fill(capwalk_math::Rgb::splat(1.0));
    let mut picture = capwalk_scene_io::image::Picture::default();
    picture.push("value", mask);
    let preview = capwalk_scene_io::image::Preview::default();
    capwalk_scene_io::image::write(&capwalk.path("mask.npz"), &picture, &preview).expect("fine");
    let views = r#"
[[view]]
mask = "mask.npz"
target = { picture = "target.exr" }
weight = 2

[[view]]
x_fov = 30
to_world = [[-1, 0, 0, 0.1], [0, 0.8, -0.6, 2], [0, -0.6, -0.8, 2.5], [0, 0, 0, 1]]
"#;
    let job = SMALL.replace("iterations = 40", "iterations = 3") + views;
    capwalk.write("job.toml", &job);
    assert_eq!(capwalk.run("optimize job.toml").status, 0);
    let record = String::from_utf8(capwalk.bytes("out/record.csv")).expect("text");
    let mut lines = record.lines();
    let header = lines.next().expect("a header");
    assert_has(
        header,
        &["loss of view 1,loss of view 2", "leaf.translate.x"],
    );
    let row: Vec<f64> = lines
        .next()
        .expect("a row")
        .split(',')
        .map(|x| x.parse().expect(x))
        .collect();
    assert!(
        (row[1] - (2.0 * row[8] + row[9]) / 3.0).abs() < 1e-12,
        "{row:?}"
    );
    for view in 1..=2 {
        capwalk.bytes(&format!("out/pictures/000003-view{view}.png"));
    }
    let error = job.replace(
        "\"leaf.translate.x\"\nbounds",
        "\"sensor.translate.x\"\nbounds",
    );
    capwalk.write("bad.toml", &error);
    assert_has(
        &capwalk.error("optimize bad.toml -o bad"),
        &["bad.toml:16:8", "its own"],
    );
}

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

    capwalk.write(
        "limit.toml",
        &SMALL.replace("iterations = 40", "iterations = 100000000"),
    );
    let limited = capwalk.run("optimize limit.toml --time-limit 2s");
    assert_eq!(limited.status, 0, "{}", limited.stderr);
    assert_has(&limited.stdout, &["the time limit is over"]);
}

#[cfg(unix)]
#[test]
fn ctrl_c_writes_what_is_done() {
    let capwalk = Capwalk::new("optimize_ctrl_c");
    capwalk.write(
        "job.toml",
        &SMALL.replace("iterations = 40", "iterations = 100000000"),
    );
    let mut command = capwalk.command("optimize job.toml --json");
    let child = command
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn();
    let child = child.expect("it starts");
    let checkpoint = capwalk.path("out/checkpoint.npz");
    let started = Instant::now();
    while !checkpoint.exists() && started.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_millis(20));
    }
    // Nobody else may write there meanwhile.
    let second = capwalk.error("optimize job.toml --resume");
    assert_has(&second, &["another run is writing"]);
    let interrupt = std::process::Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(interrupt.expect("kill exists").success());
    let finished = crate::Finished::from(child.wait_with_output().expect("it ends"));
    assert_eq!(finished.status, 5, "{}", finished.stderr);
    let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
    assert_eq!(json["stopped"], "interrupted");
    capwalk.bytes("out/parameters.npz");
}

/// A run goes on only with the job that it began with; how long, and when it
/// stops, may change.
#[test]
fn another_job_cannot_go_on() {
    let capwalk = Capwalk::new("optimize_other");
    let short = SMALL.replace("iterations = 40", "iterations = 2");
    capwalk.write("job.toml", &short);
    assert_eq!(capwalk.run("optimize job.toml").status, 0);
    assert_has(
        &capwalk.error("optimize job.toml"),
        &["already", "--resume", "-o"],
    );
    for (old, new, message) in [
        ("spp = 4", "spp = 8", "spp was 4, is 8"),
        ("seed = 5", "seed = 6", "seed was 5, is 6"),
        ("lr = 0.02", "lr = 0.03", "lr was"),
        ("size = [8, 6]", "size = [6, 8]", "scene was"),
        ("= 0.2", "= 0.25", "view 1 was"),
        ("[-1, 1]", "[-1, 2]", "parameter leaf.translate.x was"),
    ] {
        let changed = short.replacen(old, new, 1);
        assert_ne!(changed, short, "{old}");
        capwalk.write("job.toml", &changed);
        let error = capwalk.error("optimize job.toml --resume");
        let message = message.replace("lr was", "[optimizer] was lr 0.02");
        assert_has(&error, &[&message, "cannot go on"]);
    }
    capwalk.write(
        "job.toml",
        &SMALL.replace("iterations = 40", "iterations = 4\ntime_limit = \"1h\""),
    );
    assert_eq!(capwalk.run("optimize job.toml --resume").status, 0);
}

#[test]
fn bad_jobs_name_the_place() {
    let capwalk = Capwalk::new("optimize_bad");
    let bad = |old: &str, new: &str, parts: &[&str]| {
        assert!(SMALL.contains(old), "{old}");
        capwalk.write("job.toml", &SMALL.replacen(old, new, 1));
        assert_has(&capwalk.error("optimize job.toml"), parts);
    };
    bad(
        "seed = 5",
        "sed = 5",
        &[
            "job.toml:7:1",
            "`sed` means nothing",
            "expected one of",
            "\"seed\"?",
        ],
    );
    bad("seed = 5", "seed = -1", &["job.toml:7:8", "at least 0"]);
    bad("lr = 0.02", "", &["`lr` is missing in [optimizer]"]);
    bad("lr = 0.02", "lr = 0", &["a number above 0"]);
    bad("spp = 4", "spp = 1", &["job.toml:6:7", "from 2 to"]);
    bad(
        "\"sigmoid\"",
        "\"sigmoit\"",
        &["job.toml:21:11", "\"sigmoid\"?", "\"log\""],
    );
    bad(
        "leaf.translate.x\"\nb",
        "leaf.translat.x\"\nb",
        &["job.toml:16:8", "leaf.translate.x"],
    );
    bad(
        "[-1, 1]",
        "[1, -1]",
        &["job.toml:16:8", "the lower one first"],
    );
    bad(
        "[-1, 1]",
        "[1, 2, 3]",
        &["job.toml:17:10", "[lowest, highest]"],
    );
    bad(
        "scene = \"leaf\"",
        "scene = \"leav\"",
        &["job.toml:2:9", "no file", "leaf, "],
    );
    bad(
        "\"leaf.translate.x\" = 0.2",
        "\"leaf.translate.w\" = 0.2",
        &["job.toml:13:1"],
    );
    bad("= 0.2", "= \"far\"", &["job.toml:13:22", "finite numbers"]);
    bad(
        "[target]\nspp = 64\n[target.set]\n\"leaf.translate.x\" = 0.2",
        "",
        &["no target"],
    );
    bad(
        "spp = 64\n[target.set]\n\"leaf.translate.x\" = 0.2",
        "picture = \"none.exr\"",
        &["job.toml:11:11", "none.exr"],
    );
    bad(
        "lr = 0.02",
        "lr = 0.02\nbetas = [0.9, 1]",
        &["job.toml:29:9", "below 1"],
    );
    bad(
        "[optimizer]",
        "[loss]\ntype = \"l3\"\n[optimizer]",
        &["job.toml:28:8", "\"l2\"", "\"relative\""],
    );
    bad(
        "bounds = [-1, 1]",
        "plane = \"xz\"",
        &["job.toml:16:8", "`<shape>.positions`"],
    );
    bad("iterations = 40", "iterations = ", &["job.toml:5:14"]);
    assert_has(
        &capwalk.error("optimize none.toml"),
        &["none.toml", "cannot read"],
    );
}

/// What `backward` refuses is refused with the place of the parameter.
#[test]
fn refusals_name_the_parameter() {
    let capwalk = Capwalk::new("optimize_refused");
    let spot =
        "<emitter type=\"point\"><point name=\"position\" x=\"0\" y=\"3\" z=\"0\"/></emitter>";
    assert_eq!(capwalk.run("scenes --export scenes leaf").status, 0);
    let scene = String::from_utf8(capwalk.bytes("scenes/leaf.xml")).expect("text");
    capwalk.write(
        "scenes/spot.xml",
        &scene.replace("</scene>", &format!("{spot}</scene>")),
    );
    let job = SMALL.replace("scene = \"leaf\"", "scene = \"scenes/spot.xml\"");
    let job = job.replace(
        "name = \"leaf.translate.x\"\nbounds = [-1, 1]\n",
        "name = \"floor.bsdf.reflectance.value.r\"\n",
    );
    let job = job.replace(
        "floor.bsdf.reflectance.value\"\nreparam = \"sigmoid\"",
        "leaf.translate.x\"",
    );
    capwalk.write("job.toml", &job);
    let error = capwalk.error("optimize job.toml");
    assert_has(
        &error,
        &[
            "job.toml:19:8",
            "by \"leaf.translate.x\" is refused",
            "no extent",
        ],
    );
}
