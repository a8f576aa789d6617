//! The derivatives that `check.json` of each folder of `tests/scenes` asks for, beside the CPU's.

use capwalk_diff::check::{Verdict, compare};
use capwalk_diff::{GradientOptions, Method, Wanted, gradient};
use capwalk_gpu::Precision;
use capwalk_gpu_render::{DeviceError, DeviceScene, unsupported, unsupported_derivative};
use capwalk_render::{PreparedScene, RenderOptions, Unwatched};
use capwalk_scene::params::Registry;
use serde_json::Value;

use crate::{device, scenes};

/// Pixels of the images, samples of each on the device, and how many times as many on the CPU.
const SIZE: [u32; 2] = [8, 8];
const SAMPLES: u32 = 16;
const MORE_SAMPLES: u32 = 16;

/// Derivatives that can be compared.
const FEWEST: usize = 67;

/// The parameters in a folder's `check.json` whose derivatives are compared with differences there.
fn parameters(folder: &str) -> Vec<String> {
    let file = scenes::root().join(folder).join("check.json");
    let text = std::fs::read_to_string(file).expect("readable");
    let checks: Value = serde_json::from_str(&text).expect("JSON");
    let checks = checks.as_array().expect("a list").iter();
    let compared = checks.filter(|check| check.get("refused").is_none());
    let parameter = |check: &Value| check["parameter"].as_str().expect("a name").to_owned();
    compared.map(parameter).collect()
}

/// Where neither refuses the derivative, the verdict of `capwalk check` between both is not "wrong", and
/// leaves no doubt: they differ by noise alone, in every pixel and in sums. Seeds are fixed; of right ones
/// one in some hundred leaves a doubt.
#[test]
fn derivatives_of_folders_are_those_of_the_cpu() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let (mut compared, mut wrong) = (0, Vec::new());
    for (name, mut scene) in scenes::all() {
        let Some(folder) = name.strip_suffix("/scene.xml") else {
            continue;
        };
        scene.film.resize(SIZE);
        let prepared = PreparedScene::new(scene);
        if unsupported(&prepared).is_some() {
            continue;
        }
        let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
        let scene = prepared.scene();
        for parameter in parameters(folder) {
            let tangent = Registry::new(scene).tangent(scene, &parameter);
            let tangent = tangent.expect("a parameter");
            let options = |spp, seed| GradientOptions {
                method: Method::EDGES,
                ..GradientOptions::new(RenderOptions::new(spp, seed))
            };
            let ours = options(SAMPLES, 7);
            if unsupported_derivative(&prepared, &Wanted::by(&tangent), &ours).is_some() {
                continue;
            }
            let ours = match on_device.gradient(&tangent, &ours, &Unwatched) {
                Ok(image) => image.gradient,
                Err(DeviceError::Refused(_)) => continue,
                Err(error) => panic!("{folder}, {parameter}: {error}"),
            };
            let theirs = options(MORE_SAMPLES * SAMPLES, 8);
            let theirs = gradient(&prepared, &tangent, &theirs, &Unwatched);
            let theirs = theirs.expect("not refused on the device").gradient;
            let found = compare(&ours, &theirs);
            println!("{folder}, {parameter}: {found}, worst {:?}", found.worst[0]);
            if let Verdict::Wrong { reason }
            | Verdict::Inconclusive {
                doubt: Some(reason),
                ..
            } = found.verdict
            {
                wrong.push(format!("{folder}, {parameter}: {reason}"));
            }
            compared += 1;
        }
    }
    assert_eq!(wrong, [""; 0]);
    assert!(compared >= FEWEST, "{compared} derivatives");
}
