//! A run that is paused, torn or cut off at any moment ends in the same bits.

use std::fs;
use std::path::{Path, PathBuf};

use super::SMALL;
use crate::{Capwalk, assert_has};

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

/// Every piece with another number of threads, and with sample counts that follow the noise. Kills at every moment of writing are
/// tests of the library.
#[test]
fn a_run_in_pieces_ends_in_the_same_bits() {
    let capwalk = Capwalk::new("optimize_pieces");
    capwalk.write("job.toml", &format!("{SMALL}[samples]\nmost = 32\n"));
    assert_eq!(capwalk.run("optimize job.toml -o whole").status, 0);
    for (threads, iterations) in [(1, 7), (3, 1), (2, 32)] {
        let piece = format!("optimize job.toml -o pieces --resume -t {threads}");
        let finished = capwalk.run(&format!("{piece} --pause-after {iterations}"));
        assert_eq!(finished.status, 0, "{}", finished.stderr);
        assert_has(&finished.stdout, &["paused; --resume goes on"]);
    }
    let last = capwalk.run("optimize job.toml -o pieces --resume --pause-after 1");
    assert_has(&last.stdout, &["all iterations are done"]);
    assert_same_files(&capwalk.path("whole"), &capwalk.path("pieces"));
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
        fs::create_dir(capwalk.path(&format!("{case}/scene_textures"))).expect("made");
        for half in [
            ".parameters.npz.99.capwalk-tmp",
            "images/.000040.png.99.capwalk-tmp",
            "scene_meshes/.leaf.ply.77.capwalk-tmp",
            "scene_textures/.bark.exr.77.capwalk-tmp",
        ] {
            capwalk.write(&format!("{case}/{half}"), "half");
        }
        let resumed = capwalk.run(&format!("optimize job.toml -o {case} --resume"));
        assert_eq!(resumed.status, 0, "{case}: {}", resumed.stderr);
        assert_has(&resumed.stderr, &["going on after iteration 12"]);
        // The short run drew its last image, which the whole one did not.
        fs::remove_file(capwalk.path(&format!("{case}/images/000012.png"))).expect("there");
        assert_same_files(&capwalk.path("whole"), &capwalk.path(case));
    }
    // Fewer rows than the checkpoint counts cannot be made up.
    let text: String = whole.split_inclusive('\n').take(6).collect();
    capwalk.write("exact/record.csv", &text);
    let error = capwalk.error("optimize job.toml -o exact --resume");
    assert_has(&error, &["record.csv", "lacks rows of the 40"]);
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
        assert_has(&error, &[&message, "cannot continue"]);
    }
    capwalk.write(
        "job.toml",
        &format!(
            "{}[guards]\ninversion = false\n",
            SMALL.replace("iterations = 40", "iterations = 4\ntime_limit = \"1h\"")
        ),
    );
    assert_eq!(capwalk.run("optimize job.toml --resume").status, 0);
    let checkpoint = capwalk.path("out/checkpoint.npz");
    let bytes = fs::read(&checkpoint).expect("readable");
    fs::write(&checkpoint, &bytes[..bytes.len() / 2]).expect("writable");
    let error = capwalk.error("optimize job.toml --resume");
    assert_has(&error, &["the checkpoint is damaged", "Restore it", "-o"]);
}

/// A run writes over nothing but another run's files, and says so before it touches
/// anything.
#[test]
fn files_of_others_are_not_written_over() {
    let capwalk = Capwalk::new("optimize_others");
    assert_eq!(capwalk.run("scenes --export . leaf").status, 0);
    fs::rename(capwalk.path("leaf.xml"), capwalk.path("scene.xml")).expect("renamed");
    let of_file = SMALL.replace("\"leaf\"", "\"scene.xml\"");
    capwalk.write("job.toml", &of_file);
    let before = files(&capwalk.path("."));
    let error = capwalk.error("optimize job.toml -o .");
    assert_has(&error, &["scene.xml", "would overwrite", "-o"]);
    assert!(files(&capwalk.path(".")) == before);
    // With --resume too, and where it is no input.
    assert_has(
        &capwalk.error("optimize job.toml -o . --resume"),
        &["would overwrite"],
    );
    capwalk.write("job.toml", SMALL);
    assert_has(
        &capwalk.error("optimize job.toml -o ."),
        &["scene.xml already exists", "-o"],
    );
    for (folder, path, text) in [
        ("record", "record.csv", "mine\n1\n"),
        ("line", "record.csv", "mine"),
        ("timing", "timing.csv", "my times"),
        ("lock", ".lock", "mine"),
        ("image", "images/000000.png", "mine"),
        ("result", "parameters.npz", "mine"),
    ] {
        let parent = capwalk.path(&format!("{folder}/{path}"));
        fs::create_dir_all(parent.parent().expect("a folder")).expect("made");
        capwalk.write(&format!("{folder}/{path}"), text);
        let error = capwalk.error(&format!("optimize job.toml -o {folder}"));
        let file = path.split('/').next().expect("a name");
        assert_has(&error, &[file, "already exists"]);
        assert_eq!(capwalk.bytes(&format!("{folder}/{path}")), text.as_bytes());
        let entries = fs::read_dir(capwalk.path(folder)).expect("a folder");
        assert_eq!(entries.count(), 1, "{folder}");
    }
    // What a run leaves that was killed before its first checkpoint, beside something that is not
    // its own.
    fs::create_dir_all(capwalk.path("begun/images")).expect("made");
    for (file, text) in [
        ("record.csv", "iteration,loss\n"),
        ("timing.csv", "itera"),
        (".lock", ""),
    ] {
        capwalk.write(&format!("begun/{file}"), text);
    }
    let own = ["begun/.notes.tmp", "begun/.notes.12.tmp"];
    for file in own {
        capwalk.write(file, "mine");
    }
    let short = SMALL.replace("iterations = 40", "iterations = 1");
    capwalk.write("job.toml", &short);
    assert_eq!(capwalk.run("optimize job.toml -o begun").status, 0);
    for file in own {
        assert_eq!(capwalk.bytes(file), b"mine");
    }
}

/// What a run adds to is no link to something else, also when it goes on.
#[cfg(unix)]
#[test]
fn links_are_not_written_through() {
    let capwalk = Capwalk::new("optimize_links");
    capwalk.write(
        "job.toml",
        &SMALL.replace("iterations = 40", "iterations = 1"),
    );
    let run = "optimize job.toml -o run --resume";
    assert_eq!(capwalk.run(&format!("{run} --pause-after 1")).status, 0);
    for file in ["record.csv", "timing.csv", ".lock"] {
        let text = "iteration,mine\n";
        capwalk.write("mine", text);
        let link = capwalk.path(&format!("run/{file}"));
        fs::rename(&link, capwalk.path("kept")).expect("it is there");
        std::os::unix::fs::symlink("../mine", &link).expect("linkable");
        assert_has(&capwalk.error(run), &[file, "is a link", "-o"]);
        assert_eq!(capwalk.bytes("mine"), text.as_bytes(), "{file}");
        fs::rename(capwalk.path("kept"), &link).expect("renamed");
    }
    assert_eq!(capwalk.run(run).status, 0);
}

/// The folder is named as the job, up to its last dot.
#[test]
fn the_folder_is_named_after_the_job() {
    let capwalk = Capwalk::new("optimize_named");
    let short = SMALL.replace("iterations = 40", "iterations = 1");
    capwalk.write("job.v2.toml", &short.replace("output = \"out\"\n", ""));
    assert_eq!(capwalk.run("optimize job.v2.toml").status, 0);
    capwalk.bytes("job.v2.out/parameters.npz");
}
