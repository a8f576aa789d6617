//! What the files of a check hold: the gradient, its reference and z as layers,
//! how both were made, and for previews the four of them in one picture.

use anyhow::Result;
use capwalk::scene_io::image::{LayeredImage, Panel, Scale, Style};
use capwalk::{Check, Comparison, Image, Rgb};

use super::timed::Checked;
use crate::args::SceneArgs;
use crate::output::{self, Files};

/// Where the colours of z end: beyond this, a pixel is not an accident.
const Z_LIMIT: f64 = 4.0;

/// Writes a check into all files. Returns their names.
pub fn write(
    files: &Files,
    scene: &SceneArgs,
    parameter: &str,
    checked: &Checked,
) -> Result<Vec<String>> {
    let check = &checked.check;
    let z = z_image(&check.comparison, &check.gradient.value.mean);
    let mut layered = layered(scene, parameter, checked);
    layered.push("z", z.clone());
    files.write(&layered, &panels(files, check, &z))
}

/// All layers but z. What the image says of itself is true for gradient and
/// reference together, unless it names one of them.
fn layered(scene: &SceneArgs, parameter: &str, checked: &Checked) -> LayeredImage {
    let Check {
        gradient,
        reference,
        made,
        ..
    } = &checked.check;
    let sampling = checked.chosen.options.sampling();
    let mut layered = output::layered("check", scene, Some(parameter), &sampling);
    output::note(&mut layered, "method", checked.chosen.options.method.name());
    output::note(&mut layered, "step", made.step);
    output::note(&mut layered, "sides", made.sides.name());
    output::note(&mut layered, "reference_spp", made.spp);
    output::note(&mut layered, "reference_seed", made.seed);
    let both = [&gradient.statistics, &reference.statistics];
    output::push_statistics(&mut layered, &both);
    for (name, statistics) in ["gradient", "reference"].iter().zip(both) {
        let mut note = |what: &str, value: String| {
            output::note(&mut layered, &format!("{name}_{what}"), value);
        };
        note("samples", statistics.samples.to_string());
        note("complete", statistics.complete.to_string());
        note("non_finite_samples", statistics.non_finite.to_string());
    }
    output::push_estimate(&mut layered, "value", "value_stderr", &gradient.value);
    output::push_estimate(&mut layered, "gradient", "stderr", &gradient.gradient);
    output::push_estimate(
        &mut layered,
        "reference",
        "reference_stderr",
        &reference.gradient,
    );
    layered
}

/// The z of each pixel as an image of the same size as another.
fn z_image(comparison: &Comparison, like: &Image) -> Image {
    let z = comparison.z.iter();
    Image {
        pixels: z.map(|&z| Rgb::splat(z)).collect(),
        ..*like
    }
}

/// Value, gradient and reference with the same colours, and z.
fn panels<'a>(files: &Files, check: &'a Check, z: &'a Image) -> [Panel<'a>; 4] {
    let (gradient, reference) = (
        &check.gradient.gradient.mean,
        &check.reference.gradient.mean,
    );
    let scale = files.scale([gradient, reference]);
    let panel = |title, image, style| Panel {
        title,
        image,
        style,
    };
    [
        panel(
            "value",
            &check.gradient.value.mean,
            Style::Photographic { exposure: 0.0 },
        ),
        panel("gradient", gradient, Style::Diverging(scale)),
        panel("reference", reference, Style::Diverging(scale)),
        panel("z", z, Style::Diverging(Scale::even(Z_LIMIT))),
    ]
}

#[cfg(test)]
mod tests {
    use capwalk::{
        Chosen, Dips, Estimate, GradientImage, GradientOptions, Method, Reference, Statistics,
        UsedDevice,
    };

    use super::*;

    /// An image of two pixels with these samples each.
    fn image(samples: [u32; 2], complete: bool, non_finite: u64) -> GradientImage {
        let estimate = Estimate {
            mean: Image::new(2, 1),
            standard_error: Image::new(2, 1),
        };
        GradientImage {
            chosen: None,
            value: estimate.clone(),
            gradient: estimate,
            statistics: Statistics {
                samples_per_pixel: samples.to_vec(),
                complete,
                samples: samples.iter().map(|&n| u64::from(n)).sum(),
                non_finite,
                cone_queries: 0,
                dips: Dips::default(),
                effort: 0,
                device: UsedDevice::default(),
            },
        }
    }

    /// A reference that was cut short makes the file partial, and its samples
    /// that are not finite count, though the gradient is whole and finite; and
    /// the other way round.
    #[test]
    fn a_file_speaks_of_gradient_and_reference() {
        for [whole, cut] in [["gradient", "reference"], ["reference", "gradient"]] {
            let pieces = [image([8, 8], true, 1), image([5, 3], false, 2)];
            let [gradient, reference] = match whole {
                "gradient" => pieces,
                _ => {
                    let [a, b] = pieces;
                    [b, a]
                }
            };
            let made = Reference {
                sides: capwalk::Stencil::Both,
                step: 0.5,
                fits_scene: false,
                spp: 8,
                fits_noise: false,
                adaptive: false,
                seed: 6,
            };
            let checked = Checked {
                check: Check::new(gradient, (made, reference), Vec::new()),
                chosen: Chosen {
                    options: GradientOptions {
                        spp: 8,
                        seed: 5,
                        method: Method::Walk,
                        ..GradientOptions::default()
                    },
                    trials: Vec::new(),
                },
                seconds: [1.0, 1.0],
            };
            let layered = layered(&SceneArgs::default(), "leaf.translate.x", &checked);
            let of = |key: &str| {
                let mut found = layered.metadata.iter().filter(|(k, _)| k == key);
                let value = found.next().map(|(_, value)| value.as_str());
                assert!(found.next().is_none(), "{key} is said twice");
                value
            };
            assert_eq!(of("complete"), Some("false"));
            assert_eq!(of("samples"), Some("24"));
            assert_eq!(of("non_finite_samples"), Some("3"));
            assert_eq!(layered.samples, Some(vec![13, 11]));
            assert_eq!(of(&format!("{whole}_complete")), Some("true"));
            assert_eq!(of(&format!("{whole}_samples")), Some("16"));
            assert_eq!(of(&format!("{whole}_non_finite_samples")), Some("1"));
            assert_eq!(of(&format!("{cut}_complete")), Some("false"));
            assert_eq!(of(&format!("{cut}_samples")), Some("8"));
            assert_eq!(of(&format!("{cut}_non_finite_samples")), Some("2"));
            assert_eq!(of("step"), Some("0.5"));
            assert_eq!(of("spp"), Some("8"));
        }
    }
}
