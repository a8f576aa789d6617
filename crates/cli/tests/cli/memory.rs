//! What does not fit into memory is an error with its size, before memory is taken for it.

use std::process::Command;

use crate::{Capwalk, Finished, assert_has};

/// A scene with these parts.
fn scene(parts: &str) -> String {
    format!(
        "<scene version=\"3.0.0\"><integrator type=\"direct\"/>\
         <sensor type=\"perspective\"><film type=\"hdrfilm\"/></sensor>{parts}</scene>"
    )
}

/// A TGA file of one colour with so many pixels a side, in runs of 128.
fn texture(side: u16) -> Vec<u8> {
    let [low, high] = side.to_le_bytes();
    let mut bytes = vec![
        0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, low, high, low, high, 24, 0,
    ];
    let runs = usize::from(side) * usize::from(side) / 128;
    bytes.extend([0xff, 50, 100, 150].repeat(runs));
    bytes
}

/// Runs a command with so many KiB of address space, and one thread.
fn with_memory(capwalk: &Capwalk, kib: u32, arguments: &str) -> Finished {
    let small = "--size 6x5 --spp 1 --threads 1";
    let program = env!("CARGO_BIN_EXE_capwalk");
    let line = format!("ulimit -v {kib} && exec {program} {arguments} {small}");
    let mut shell = Command::new("sh");
    let shell = shell.args(["-c", &line]).current_dir(&capwalk.folder);
    Finished::from(shell.output().expect("it starts"))
}

/// 3000 spheres that only stand there fit, and so does one of them that shines.
#[test]
fn emitters_of_many_triangles_are_refused() {
    let capwalk = Capwalk::new("memory_emitters");
    let dark = "<shape type=\"sphere\"/>".repeat(2999);
    let light = "<shape type=\"sphere\"><emitter type=\"area\"/></shape>";
    capwalk.write("one.xml", &scene(&(dark + light)));
    capwalk.write("all.xml", &scene(&light.repeat(3000)));
    let finished = with_memory(&capwalk, 1_500_000, "render one.xml -o one.npz");
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    let finished = with_memory(&capwalk, 1_500_000, "render all.xml -o all.npz");
    assert_eq!(finished.status, 3, "{}", finished.stderr);
    let expected = [
        "3840000 triangles, which need",
        "of them for emitters",
        "are free",
    ];
    assert_has(&finished.stderr, &expected);
}

#[test]
fn large_environment_maps_are_refused() {
    let capwalk = Capwalk::new("memory_sky");
    std::fs::write(capwalk.path("sky.tga"), texture(8000)).expect("writable");
    let sky = "<emitter type=\"envmap\"><string name=\"filename\" value=\"sky.tga\"/></emitter>";
    capwalk.write("sky.xml", &scene(sky));
    let finished = with_memory(&capwalk, 2_300_000, "render sky.xml -o sky.npz");
    assert_eq!(finished.status, 3, "{}", finished.stderr);
    let expected = [
        "sky.tga",
        "8000 x 8000 pixels need",
        "MiB of memory",
        "make it smaller",
    ];
    assert_has(&finished.stderr, &expected);
}

/// One texture fits, two do not, unless one of them is asked for.
#[test]
fn gradients_of_large_textures_are_refused() {
    let capwalk = Capwalk::new("memory_textures");
    std::fs::write(capwalk.path("texture.tga"), texture(2048)).expect("writable");
    let wall = |name: &str| {
        format!(
            "<shape type=\"rectangle\"><bsdf type=\"diffuse\" id=\"{name}\"><texture \
             name=\"reflectance\" type=\"bitmap\"><string name=\"filename\" \
             value=\"texture.tga\"/></texture></bsdf></shape>"
        )
    };
    let walls = wall("first") + &wall("second") + "<emitter type=\"constant\"/>";
    capwalk.write("scene.xml", &scene(&walls));
    capwalk.run("render leaf --size 6x5 --spp 1 -o target.npz");
    let backward = "backward scene.xml --loss l2 --target target.npz -o g.npz";
    let one = format!("{backward} -p first.reflectance.data");
    let finished = with_memory(&capwalk, 1_400_000, &one);
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    let finished = with_memory(&capwalk, 1_400_000, backward);
    assert_eq!(finished.status, 3, "{}", finished.stderr);
    let expected = ["numbers needs about", "MiB are free", "fewer arrays"];
    assert_has(&finished.stderr, &expected);
}
