//! Verdicts on many gradients that are right, and on the same made wrong on purpose: how often
//! `check` accuses, and how often it finds what it should.
//!
//! `cargo xtask verdicts` runs as many as wanted: `CAPWALK_VERDICTS` says how many,
//! `CAPWALK_VERDICTS_FROM` where to begin. Each is made from its number alone.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use capwalk_diff::{RenderOptions, Unwatched};
use serde_json::Value;

use super::{Check, CheckOptions};
use crate::{GradientOptions, Loader, Prepared, Verdict};

/// So many checks where nothing else is asked for: a few seconds.
const FEW: u64 = 24;

/// Samples per pixel that are checked with.
const SPP: [u32; 6] = [8, 12, 16, 24, 32, 64];

/// Width and height of the images, pixels.
const SIZE: [u32; 2] = [12, 12];

/// Of so many checks, one is made of a gradient that is wrong, too.
const WRONG_EVERY: u64 = 3;

/// By what a wrong gradient is too large.
const WRONG_BY: f64 = 1.1;

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

/// A thing above a floor in some light, as a file, and the parameter that changes. Rectangles with
/// holes are frequent, low above the floor and nearly parallel to it: few rays pass between.
fn random_scene(random: &mut Random) -> (String, &'static str) {
    let shape = random.of(&["leaf", "leaf", "leaf", "rectangle", "cube", "disk", "sphere"]);
    let size = random.between(0.1, 0.8);
    let angle = random.of(&[&1.0, &3.0, &5.0, &10.0, &20.0, &60.0]);
    // Above the floor in any case.
    let height = size * (1.8 * f64::sin(f64::to_radians(*angle)) + 0.02)
        + match shape {
            "cube" | "sphere" => 1.8 * size,
            _ => 0.0,
        }
        + random.between(0.0, 0.5).powi(3);
    let plain = "<bsdf type=\"twosided\"><bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0.3, 0.6, 0.2\"/></bsdf></bsdf>";
    let metal = "<bsdf type=\"twosided\"><bsdf type=\"roughconductor\"><float name=\"alpha\" value=\"0.3\"/></bsdf></bsdf>";
    let bsdf = match shape {
        "leaf" => {
            let filter = random.of(&["bilinear", "nearest"]);
            let file = folders().join("mask_textured_leaf/leaf.png");
            format!(
                "<bsdf type=\"mask\"><texture type=\"bitmap\" name=\"opacity\"><string name=\"filename\" value=\"{}\"/>\
                 <boolean name=\"raw\" value=\"true\"/><string name=\"filter_type\" value=\"{filter}\"/></texture>{plain}</bsdf>",
                file.display()
            )
        }
        _ => random.of(&[plain, plain, metal]).into(),
    };
    let light = random.of(&["sky", "lamp", "lamp", "bulb"]);
    let emitter = match light {
        "sky" => "<emitter type=\"constant\"><rgb name=\"radiance\" value=\"0.8, 0.9, 1\"/></emitter>".into(),
        "lamp" => format!(
            "<shape type=\"rectangle\" id=\"lamp\"><transform name=\"to_world\"><rotate x=\"1\" angle=\"180\"/>\
             <scale value=\"{}\"/><translate x=\"0.8\" y=\"0.5\" z=\"3\"/></transform>\
             <emitter type=\"area\"><rgb name=\"radiance\" value=\"20\"/></emitter></shape>",
            random.between(0.1, 1.0)
        ),
        _ => "<emitter type=\"point\" id=\"bulb\"><point name=\"position\" x=\"0.8\" y=\"0.5\" z=\"3\"/>\
              <rgb name=\"intensity\" value=\"10\"/></emitter>"
            .into(),
    };
    let kind = match shape {
        "leaf" => "rectangle",
        other => other,
    };
    let scene = format!(
        "<scene version=\"3.0.0\"><integrator type=\"path\"><integer name=\"max_depth\" value=\"{depth}\"/></integrator>\
         <sensor type=\"perspective\"><float name=\"fov\" value=\"{fov}\"/><transform name=\"to_world\">\
         <lookat origin=\"0.3, -2, {eye}\" target=\"0, 0.1, {height}\" up=\"0.1, 0.2, 1\"/></transform>\
         <film type=\"hdrfilm\"><rfilter type=\"{filter}\"/></film></sensor>\
         <shape type=\"rectangle\" id=\"floor\"><transform name=\"to_world\"><scale value=\"4\"/></transform>\
         <bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"{albedo}\"/></bsdf></shape>\
         <shape type=\"{kind}\" id=\"thing\"><transform name=\"to_world\"><scale value=\"{size}\"/>\
         <rotate x=\"1\" angle=\"{angle}\"/><rotate z=\"1\" angle=\"30\"/>\
         <translate x=\"0\" y=\"0.1\" z=\"{height}\"/></transform>{bsdf}</shape>{emitter}</scene>",
        depth = random.of(&["2", "3", "4"]),
        fov = random.of(&["15", "34", "60"]),
        eye = random.of(&["0.17", "0.33", "1.01", "2.5"]),
        filter = random.of(&["tent", "box", "gaussian"]),
        albedo = random.of(&["0.05", "0.7"]),
    );
    let of_thing = [
        "thing.translate.x",
        "thing.translate.y",
        "thing.translate.z",
        "thing.rotate.x",
        "thing.rotate.z",
        "thing.scale",
    ];
    let parameter = match (random.next(), light) {
        (..0.1, _) => "sensor.translate.x",
        (..0.2, "lamp") => "lamp.translate.x",
        (..0.2, "bulb") => "bulb.translate.y",
        (..0.25, _) => "floor.bsdf.reflectance.value",
        _ => random.of(&of_thing),
    };
    (scene, parameter)
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
            Verdict::Inconclusive { .. } | Verdict::Partial { .. } => self.inconclusive += 1,
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
    let check = prepared.checked_with(first, &tangent, reference, &options.gradient, &gradient, &Unwatched);
    check.unwrap()
}

#[test]
fn right_gradients_are_not_called_wrong() {
    let variable = |name: &str| std::env::var(name).ok().and_then(|text| text.parse().ok());
    let first: u64 = variable("CAPWALK_VERDICTS_FROM").unwrap_or(0);
    let count: u64 = variable("CAPWALK_VERDICTS").unwrap_or(FEW);
    let only: Option<f64> = variable("CAPWALK_VERDICTS_FACTOR").map(|x: u64| x as f64 / 100.0);
    let phenomena = phenomena();
    let folder = std::env::temp_dir().join(format!("capwalk-verdicts-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let mut tallies: BTreeMap<&str, Tally> = BTreeMap::new();
    for number in first..first + count {
        let mut random = Random(number);
        let (path, parameter) = match number % 3 {
            0 => {
                let (scene, parameter) = random_scene(&mut random);
                let path = folder.join("scene.xml");
                std::fs::write(&path, scene).unwrap();
                (path, parameter.to_owned())
            }
            _ => {
                let i = random.next() * phenomena.len() as f64;
                phenomena[i as usize].clone()
            }
        };
        let scene = Loader::new(&path).size(SIZE).load().unwrap().scene;
        let prepared = Prepared::new(scene).unwrap();
        let spp = *random.of(&SPP.each_ref());
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
            let place = path.parent().and_then(Path::file_name).unwrap().display();
            println!("{number} {name} {place} {parameter} {spp}: {} {verdict:?}", check.references);
        };
        if only.is_none_or(|only| only == 1.0) {
            say("right", 1.0);
        }
        if number % WRONG_EVERY == 0 && only != Some(1.0) {
            say("wrong", WRONG_BY);
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
    for (name, tally) in &tallies {
        let Tally { right, inconclusive, wrong } = tally;
        println!("TOTAL {name}: {right} right, {inconclusive} inconclusive, {wrong} wrong");
    }
}
