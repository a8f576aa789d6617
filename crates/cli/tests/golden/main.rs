//! Golden images: every scene of `tests/parity` is rendered and compared with the
//! image that Mitsuba 3 made of it (`tests/parity/golden`). Gradients are tested
//! against differences of the same path tracer, so an error in it is seen here
//! and nowhere else.
//!
//! `cargo test -p capwalk-cli --test golden <scene>` runs one; `cargo xtask parity
//! --golden <scene>` has Mitsuba make it again.

#[allow(dead_code, reason = "the room needs a part of it")]
#[path = "../../../scene-io/tests/reading/gltf_file.rs"]
mod gltf_file;
#[path = "../../../scene-io/tests/reading/gltf_room.rs"]
mod gltf_room;
mod statistics;

use std::path::{Path, PathBuf};
use std::process::Command;

use capwalk_math::Rgb;
use capwalk_scene::Image;
use capwalk_scene_io::image::{self, LayeredImage, Preview};
use serde_json::Value;
use statistics::{Comparison, Grid, Reference, TESTS};

/// Samples per pixel of our images: all of them take 76 s of CPU time. A
/// factor of 1.02 on what a lobe reflects then fails one or more scenes, 1.01 for
/// diffuse ones; so do 2 % of an emitter's density or of the light sampled from it,
/// a tenth of a pixel of offset, a filter narrower by a tenth. Not found: 2 % of
/// smooth plastic, of roulette, or of a filter's width.
const SPP: u32 = 512;
/// Seed of our images: whether one fails by accident is decided once.
const SEED: u64 = 1;
/// Probability that one or more of all images fail although all are right.
const LEVEL: f64 = 0.01;

/// A test for each scene, and the list of them.
macro_rules! scenes {
    ($($name:ident)*) => {
        $(#[test] fn $name() { run(stringify!($name)) })*
        const LISTED: &[&str] = &[$(stringify!($name)),*];
    };
}

scenes! {
    anisotropic
    bitmap
    bitmap_ball
    bitmap_box
    bitmap_numbers
    blendbsdf
    bsplinecurve
    bumpmap
    catmullrom
    checkerboard
    coarse_normals
    colour_bleeding
    conductor
    cube_sky
    cylinder
    dielectric
    directional_light
    disk_emitter
    emitters_hidden
    emitters_hidden_direct
    emitters_seen
    environment_map
    fov_y_crop
    gaussian
    gaussian_border
    glass_rough
    glass_smooth
    gltf_room
    instances
    lanczos
    linearcurve
    maps_around_sides
    mask
    mask_and_blend
    mesh_attribute
    metal_rough
    metal_smooth
    mirrored
    mitchell
    normalmap
    null
    one_sided_ply
    open_ply
    orthographic
    painted_mesh
    pane
    plastic
    plastic_nonlinear
    plastic_rough
    point_light
    polarized
    principal_point_tent
    principled
    principled_anisotropic
    principled_glass
    principled_metal_cloth
    principled_thin
    projector
    roughconductor
    roughdielectric_ggx
    roughplastic
    roulette
    serialized
    smooth_obj
    sphere_emitter
    sphere_shadow
    spot_light
    spot_texture
    textured_emitter
    thinlens
    turned_normals
    twosided
}

/// The files in a folder of the repository that end so, without their ending.
fn stems(folder: &Path, ending: &str) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("the folder exists");
    let names = entries.map(|entry| entry.expect("an entry").file_name());
    let names = names.map(|name| name.to_string_lossy().into_owned());
    let mut stems: Vec<String> = names
        .filter_map(|name| name.strip_suffix(ending).map(str::to_owned))
        .collect();
    stems.sort();
    stems
}

#[test]
fn every_scene_is_listed_and_has_a_golden_image() {
    assert_eq!(LISTED, stems(&parity(), ".xml"), "`scenes!` in this file");
    let golden = stems(&parity().join("golden"), ".npz");
    assert_eq!(LISTED, golden, "the images of tests/parity/golden");
}

fn parity() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/parity")
}

/// A room as a `.glb`, beside what Mitsuba makes of the same room in its own XML.
#[test]
fn gltf_room_as_glb() {
    let out = folder("gltf_room_as_glb");
    let (document, json) = gltf_room::room(&parity());
    let glb = out.join("room.glb");
    std::fs::write(&glb, document.binary(&json)).expect("the build folder is writable");
    compare(
        "gltf_room",
        &glb,
        &out,
        &["--size", "36x36", "--filter", "box"],
    );
}

/// Renders a scene and compares.
fn run(name: &str) {
    let scene = parity().join(format!("{name}.xml"));
    compare(name, &scene, &folder(name), &[]);
}

/// The folder for what a test writes.
fn folder(name: &str) -> PathBuf {
    let tests = Path::new(env!("CARGO_TARGET_TMPDIR")).join("golden");
    let out = tests.join(name);
    std::fs::create_dir_all(&out).expect("the build folder is writable");
    out
}

/// Renders a scene with these options and compares with a golden image; writes what differs.
fn compare(name: &str, scene: &Path, out: &Path, options: &[&str]) {
    let file = out.join("capwalk.npz");
    render(scene, &file, options);
    let ours = image::read(&file).expect("our own image");
    let golden = parity().join(format!("golden/{name}.npz"));
    let golden = image::read(&golden).expect("a golden image");

    let reference = reference(&golden);
    let layer = |name| mosaic(ours.layer(name).expect("the command writes it"));
    let mut variance = layer("stderr");
    variance
        .numbers
        .iter_mut()
        .for_each(|error| *error *= *error);
    let level = LEVEL / (LISTED.len() * TESTS) as f64;
    let mean = layer(image::VALUE);
    let found = statistics::compare(&mean, &variance, SPP.into(), &reference, level);
    let objections = match known_deviation(name) {
        Some(known) => beyond(&known, &found),
        None => found.objections,
    };
    if objections.is_empty() {
        return;
    }
    for (what, grid) in [
        ("mean", &mean),
        ("golden", &reference.mean),
        ("z", &found.z),
    ] {
        write(&out.join(format!("{what}.exr")), grid);
    }
    let (objections, out) = (objections.join("\n  "), out.display());
    panic!(
        "{name} is not as Mitsuba renders it:\n  {objections}\nmean.exr, golden.exr and z.exr (one channel per pixel, as a mosaic) are in {out}"
    );
}

/// Renders a scene with the command that is being tested.
fn render(scene: &Path, image: &Path, options: &[&str]) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_capwalk"));
    let command = command.arg("render").arg(scene).arg("-o").arg(image);
    let command = command.args(["--spp", &SPP.to_string(), "--seed", &SEED.to_string()]);
    let command = command.args(options);
    let done = command.output().expect("it starts");
    let errors = String::from_utf8_lossy(&done.stderr);
    assert!(done.status.success(), "{errors}");
}

/// Channel `(x + y) mod 3` of each pixel: channels of a pixel share their samples.
fn mosaic(image: &Image) -> Grid {
    let channel = |i: usize| (i % image.width + i / image.width) % 3;
    let pixels = image.pixels.iter().enumerate();
    Grid {
        width: image.width,
        height: image.height,
        numbers: pixels
            .map(|(i, pixel)| pixel.to_array()[channel(i)])
            .collect(),
    }
}

/// A golden image, whose layers are grey: one channel of each pixel.
fn reference(golden: &LayeredImage) -> Reference {
    let layer = |name| mosaic(golden.layer(name).expect("golden images have it"));
    let number = |key: &str| {
        let mut pairs = golden.metadata.iter();
        let (_, text) = pairs
            .find(|(k, _)| k == key)
            .expect("golden images have it");
        text.parse().expect("a number")
    };
    Reference {
        mean: layer("mean"),
        variance: layer("variance"),
        spp: number("spp"),
        correlation: number("correlation"),
    }
}

/// What `deviations.json` says of a scene, if it differs on purpose.
fn known_deviation(name: &str) -> Option<Value> {
    let text = std::fs::read_to_string(parity().join("deviations.json")).expect("the deviations");
    let mut all: Value = serde_json::from_str(&text).expect("JSON");
    all.get_mut(name).map(Value::take)
}

/// What is beyond the bounds of a known deviation.
fn beyond(known: &Value, found: &Comparison) -> Vec<String> {
    let numbers = [
        ("failing_pixels", found.failing_pixels),
        ("brightness", found.brightness.abs()),
    ];
    let mut objections = Vec::new();
    for (what, number) in numbers {
        let bound = known[what]["at_most"].as_f64().expect("a bound");
        if number > bound {
            objections.push(format!("{what}: {number:.4} instead of at most {bound}"));
        }
    }
    objections
}

/// Writes a grid as a grey image.
fn write(file: &Path, grid: &Grid) {
    let pixels = grid
        .numbers
        .iter()
        .map(|&number| Rgb::new(number, number, number));
    let image = Image {
        width: grid.width,
        height: grid.height,
        pixels: pixels.collect(),
    };
    let mut layered = LayeredImage::default();
    layered.push(image::VALUE, image);
    image::write(file, &layered, &Preview::default()).expect("the build folder is writable");
}
