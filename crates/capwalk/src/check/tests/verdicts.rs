//! Verdicts on many gradients that are right, and on the same made wrong on purpose: how often
//! `check` accuses, and how often it finds what it should.
//!
//! `cargo xtask verdicts` runs as many as wanted: `CAPWALK_VERDICTS` says how many,
//! `CAPWALK_VERDICTS_FROM` where to begin, `CAPWALK_VERDICTS_EVERY` which of them. Each is made from
//! its number alone.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use capwalk_diff::{RenderOptions, Unwatched};
use serde_json::Value;

use crate::check::{Check, CheckOptions};
use crate::{GradientOptions, Loader, Prepared, Verdict};

/// So many checks where nothing else is asked for: a few seconds.
const FEW: u64 = 12;

/// Samples per pixel that are checked with.
const SPP: [u32; 6] = [8, 12, 16, 24, 32, 64];

/// Width and height of the images, pixels.
const SIZE: [u32; 2] = [12, 12];

/// Of so many checks, one is made of a gradient that is wrong, too.
const WRONG_EVERY: u64 = 4;

/// By what a wrong gradient is too large.
const WRONG_BY: f64 = 1.1;

/// Of so many right gradients one may be called wrong.
const TOLERATED_ONCE_IN: u64 = 3000;

fn folders() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/scenes")
}

/// The scene files of `tests/scenes`, and the parameters by which they can be differentiated.
fn phenomena() -> Vec<(PathBuf, String)> {
    let folders = std::fs::read_dir(folders()).unwrap();
    let mut folders: Vec<PathBuf> = folders.map(|entry| entry.unwrap().path()).collect();
    folders.retain(|folder| folder.is_dir());
    folders.sort();
    let parameters = folders.iter().flat_map(|folder| {
        let text = std::fs::read_to_string(folder.join("check.json")).unwrap();
        let value: Value = serde_json::from_str(&text).unwrap();
        let checks = value.as_array().unwrap().iter();
        let checks = checks.filter(|check| check.get("refused").is_none());
        let names = checks.map(|check| check["parameter"].as_str().unwrap().to_owned());
        let names: Vec<String> = names.collect();
        names
            .into_iter()
            .map(|name| (folder.join("scene.xml"), name))
    });
    parameters.collect()
}

/// Numbers that look random, from 0 to 1 (SplitMix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    fn of<'a, T: ?Sized>(&mut self, choices: &[&'a T]) -> &'a T {
        choices[(self.next() * choices.len() as f64) as usize]
    }
}

/// A thing above a floor in some light.
struct Sketch {
    /// The thing: `leaf` is a rectangle with holes.
    shape: &'static str,
    /// Half its width, world units.
    size: f64,
    /// Between it and the floor, degrees.
    angle: f64,
    /// Of its middle above the floor, world units.
    height: f64,
    /// Of the camera above the floor, world units.
    eye: &'static str,
    /// Degrees.
    fov: &'static str,
    /// `sky`, `lamp` or `bulb`.
    light: &'static str,
    /// Half the width of the emitter, world units.
    emitter: f64,
    /// Of the thing: `diffuse` or `metal`.
    material: &'static str,
    /// How the opacities of the leaf are looked up.
    texels: &'static str,
    depth: &'static str,
    filter: &'static str,
    albedo: &'static str,
}

/// A rectangle with holes, low above the floor and seen nearly edge-on: few samples of the
/// differences meet what makes the derivative with respect to its size. With 24 samples a fourth
/// of the checks once said "wrong", though the errors of the gradient were right.
const LOW: Sketch = Sketch {
    shape: "leaf",
    size: 0.5,
    angle: 20.0,
    height: 0.5,
    eye: "0.1",
    fov: "15",
    light: "lamp",
    emitter: 0.3,
    material: "diffuse",
    texels: "bilinear",
    depth: "3",
    filter: "tent",
    albedo: "0.7",
};

impl Sketch {
    /// Rectangles with holes are frequent, low above the floor and nearly parallel to it.
    fn random(random: &mut Random) -> Self {
        let shape = random.of(&[
            "leaf",
            "leaf",
            "leaf",
            "rectangle",
            "cube",
            "disk",
            "sphere",
        ]);
        let size = random.between(0.1, 0.8);
        let angle = *random.of(&[&1.0, &3.0, &5.0, &10.0, &20.0, &60.0]);
        // It does not reach the floor.
        let reach = match shape {
            "cube" | "sphere" => 3.0,
            _ => 1.8 * f64::sin(f64::to_radians(angle)),
        };
        Self {
            shape,
            size,
            angle,
            height: size * (reach + 0.02) + random.between(0.0, 0.8).powi(3),
            eye: random.of(&["0.1", "0.33", "1.01", "2.5"]),
            fov: random.of(&["15", "34", "60"]),
            light: random.of(&["sky", "lamp", "lamp", "bulb"]),
            emitter: random.between(0.1, 1.0),
            material: random.of(&["diffuse", "diffuse", "metal"]),
            texels: random.of(&["bilinear", "nearest"]),
            depth: random.of(&["2", "3", "4"]),
            filter: random.of(&["tent", "box", "gaussian"]),
            albedo: random.of(&["0.05", "0.7"]),
        }
    }

    /// As a scene file.
    fn scene(&self) -> String {
        let nested = match self.material {
            "metal" => r#"<bsdf type="roughconductor"><float name="alpha" value="0.3"/></bsdf>"#,
            _ => r#"<bsdf type="diffuse"><rgb name="reflectance" value="0.3, 0.6, 0.2"/></bsdf>"#,
        };
        let nested = format!(r#"<bsdf type="twosided">{nested}</bsdf>"#);
        let (kind, bsdf) = match self.shape {
            "leaf" => {
                let file = folders().join("mask_textured_leaf/leaf.png");
                let mask = format!(
                    r#"<bsdf type="mask"><texture type="bitmap" name="opacity">
<string name="filename" value="{}"/><boolean name="raw" value="true"/>
<string name="filter_type" value="{}"/></texture>{nested}</bsdf>"#,
                    file.display(),
                    self.texels
                );
                ("rectangle", mask)
            }
            other => (other, nested),
        };
        let emitter = match self.light {
            "sky" => {
                r#"<emitter type="constant"><rgb name="radiance" value="0.8, 0.9, 1"/></emitter>"#
                    .into()
            }
            "lamp" => format!(
                r#"<shape type="rectangle" id="lamp"><transform name="to_world"><rotate x="1" angle="180"/>
<scale value="{}"/><translate x="0.8" y="0.5" z="3"/></transform>
<emitter type="area"><rgb name="radiance" value="20"/></emitter></shape>"#,
                self.emitter
            ),
            _ => r#"<emitter type="point" id="bulb"><point name="position" x="0.8" y="0.5" z="3"/>
<rgb name="intensity" value="10"/></emitter>"#
                .into(),
        };
        let Self {
            size,
            angle,
            height,
            eye,
            fov,
            depth,
            filter,
            albedo,
            ..
        } = self;
        format!(
            r#"<scene version="3.0.0">
<integrator type="path"><integer name="max_depth" value="{depth}"/></integrator>
<sensor type="perspective"><float name="fov" value="{fov}"/><transform name="to_world">
<lookat origin="0.3, -2, {eye}" target="0, 0.1, {height}" up="0.1, 0.2, 1"/></transform>
<film type="hdrfilm"><rfilter type="{filter}"/></film></sensor>
<shape type="rectangle" id="floor"><transform name="to_world"><scale value="4"/></transform>
<bsdf type="diffuse"><rgb name="reflectance" value="{albedo}"/></bsdf></shape>
<shape type="{kind}" id="thing"><transform name="to_world"><scale value="{size}"/>
<rotate x="1" angle="{angle}"/><rotate z="1" angle="30"/>
<translate x="0" y="0.1" z="{height}"/></transform>{bsdf}</shape>{emitter}</scene>"#
        )
    }

    /// One of its parameters.
    fn parameter(&self, random: &mut Random) -> &'static str {
        match (random.next(), self.light) {
            (..0.1, _) => "sensor.translate.x",
            (..0.2, "lamp") => "lamp.translate.x",
            (..0.2, "bulb") => "bulb.translate.y",
            (..0.25, _) => "floor.bsdf.reflectance.value",
            _ => random.of(&[
                "thing.translate.x",
                "thing.translate.y",
                "thing.translate.z",
                "thing.rotate.x",
                "thing.rotate.z",
                "thing.scale",
            ]),
        }
    }
}

/// What was said, by what it was said of.
#[derive(Default)]
struct Tally {
    right: u32,
    inconclusive: u32,
    wrong: u32,
}

impl Tally {
    fn count(&mut self, verdict: &Verdict) {
        match verdict {
            Verdict::Right => self.right += 1,
            Verdict::Wrong { .. } => self.wrong += 1,
            Verdict::Inconclusive { .. } => self.inconclusive += 1,
        }
    }
}

/// A check of a gradient times a factor.
fn check(prepared: &Prepared, parameter: &str, options: &CheckOptions, factor: f64) -> Check {
    let tangent = prepared.registry().tangent(prepared.scene(), parameter);
    let tangent = tangent.unwrap();
    let step = || prepared.difference_step(&tangent);
    let reference = options.reference(prepared.scene(), &tangent, step).unwrap();
    let gradient = |options: &GradientOptions| {
        let mut image = prepared.gradient(&tangent, options, &Unwatched)?;
        let estimate = &mut image.gradient;
        let pixels = estimate.mean.pixels.iter_mut();
        for pixel in pixels.chain(&mut estimate.standard_error.pixels) {
            *pixel = *pixel * factor;
        }
        Ok(image)
    };
    let first = gradient(&options.gradient).unwrap();
    let check = prepared.checked_with(
        first,
        &tangent,
        reference,
        &options.gradient,
        &|options: &GradientOptions| gradient(options),
        &Unwatched,
    );
    check.unwrap()
}

#[test]
fn right_gradients_are_not_called_wrong() {
    let variable = |name: &str| std::env::var(name).ok().and_then(|text| text.parse().ok());
    let first: u64 = variable("CAPWALK_VERDICTS_FROM").unwrap_or(0);
    let count: u64 = variable("CAPWALK_VERDICTS").unwrap_or(FEW);
    let every: u64 = variable("CAPWALK_VERDICTS_EVERY").unwrap_or(1);
    let phenomena = phenomena();
    let folder = std::env::temp_dir().join(format!("capwalk-verdicts-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let mut tallies: BTreeMap<&str, Tally> = BTreeMap::new();
    for number in (first..).step_by(every as usize).take(count as usize) {
        let random = &mut Random(number);
        let sketched = |sketch: Sketch| {
            let path = folder.join("scene.xml");
            std::fs::write(&path, sketch.scene()).unwrap();
            path
        };
        let mut spp = *random.of(&SPP.each_ref());
        let (of, path, parameter) = match number % 12 {
            7 => {
                spp = 24;
                ("low".into(), sketched(LOW), "thing.scale".into())
            }
            0 | 3 | 6 | 9 => {
                let sketch = Sketch::random(random);
                let parameter = sketch.parameter(random).to_owned();
                ("random".into(), sketched(sketch), parameter)
            }
            _ => {
                let i = random.next() * phenomena.len() as f64;
                let (path, parameter) = phenomena[i as usize].clone();
                let name = path.parent().and_then(Path::file_name).unwrap();
                (name.to_string_lossy().into_owned(), path, parameter)
            }
        };
        let scene = Loader::new(&path).size(SIZE).load().unwrap().scene;
        let prepared = Prepared::new(scene).unwrap();
        let gradient = GradientOptions::new(RenderOptions {
            adaptive: true,
            ..RenderOptions::new(spp, number)
        });
        let options = CheckOptions {
            gradient,
            ..CheckOptions::default()
        };
        let mut say = |name, factor| {
            let check = check(&prepared, &parameter, &options, factor);
            let verdict = &check.comparison.verdict;
            tallies.entry(name).or_default().count(verdict);
            println!(
                "{number} {name} {of} {parameter} {spp}: {} {verdict:?}",
                check.references
            );
        };
        say("right", 1.0);
        if number % WRONG_EVERY == 0 {
            say("wrong", WRONG_BY);
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
    for (name, tally) in &tallies {
        let Tally {
            right,
            inconclusive,
            wrong,
        } = tally;
        println!("TOTAL {name}: {right} right, {inconclusive} inconclusive, {wrong} wrong");
    }
    let of_right = &tallies["right"];
    let most = count / TOLERATED_ONCE_IN;
    assert!(
        u64::from(of_right.wrong) <= most,
        "{} wrong",
        of_right.wrong
    );
}
