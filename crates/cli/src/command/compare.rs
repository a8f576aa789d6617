//! `capwalk compare`: two images, with their errors if they have them.

use std::path::Path;

use anyhow::{Context, Result, ensure};
use capwalk::scene_io::image::{GRADIENT, ImageFile, LayeredImage, Panel, Style, VALUE};
use capwalk::text::listed;
use capwalk::{Comparison, Estimate, Image, Rgb, Verdict};
use serde_json::json;

use super::check as verdicts;
use crate::args::Compare;
use crate::diagnostics::Outcome;
use crate::memory::{self, Need};
use crate::output::Files;
use crate::{console, report};

pub fn run(args: &Compare) -> Result<Outcome> {
    let mut tested = ImageFile::open(&args.image)?;
    let mut reference = ImageFile::open(&args.reference)?;
    let has_gradients = [&tested, &reference]
        .iter()
        .all(|file| file.names().contains(&GRADIENT));
    let layer = match &args.layer {
        Some(layer) => layer.as_str(),
        None if has_gradients => GRADIENT,
        None => VALUE,
    };
    // Before any of their pixels takes time and memory.
    let size = layer_size(&mut tested, layer, &args.image)?;
    let other = layer_size(&mut reference, layer, &args.reference)?;
    ensure!(
        size == other,
        "the images have different sizes: {} x {} and {} x {}",
        size[0],
        size[1],
        other[0],
        other[1]
    );
    let pixels = size.map(|n| u32::try_from(n).unwrap_or(u32::MAX));
    memory::check_size(pixels, Need::Comparison)?;
    let read = [&args.image, &args.reference].into_iter().collect();
    let files = match args.output.output.is_empty() {
        true => None,
        false => Some(Files::new(&args.output.output, "", &[], &read)?.limited(args.colours.limit)),
    };

    let a = &image_of(&mut tested, layer, size, &args.image)?;
    let b = &image_of(&mut reference, layer, size, &args.reference)?;
    let difference = Image {
        pixels: a
            .pixels
            .iter()
            .zip(&b.pixels)
            .map(|(&a, &b)| a - b)
            .collect(),
        ..*a
    };
    ensure!(
        difference.pixels.iter().any(|pixel| pixel.is_finite()),
        "no pixel of the layer \"{layer}\" is a finite number in both images: there is nothing to \
         compare. Choose another layer (--layer), or render them again"
    );
    let errors = Errors::new(&difference, b);
    // Equal images need no statistics, which would find the errors of
    // two runs with the same random numbers too large.
    let of_errors = [&tested, &reference].map(|file| errors_layer(file, layer));
    let comparison = match of_errors {
        [Some(of_a), Some(of_b)] if errors.largest > 0.0 => {
            let estimate = |mean: &Image, standard_error| Estimate {
                mean: mean.clone(),
                standard_error,
            };
            let a = estimate(a, image_of(&mut tested, &of_a, size, &args.image)?);
            let b = estimate(b, image_of(&mut reference, &of_b, size, &args.reference)?);
            Some(capwalk::compare(&a, &b))
        }
        _ => None,
    };

    let mut written = Vec::new();
    if let Some(files) = &files {
        let mut result = LayeredImage::default();
        result.push("difference", difference.clone());
        let panel = Panel {
            title: "difference",
            image: &difference,
            style: Style::Diverging(files.scale([&difference])),
        };
        written = files.write(&result, &[panel])?;
    }
    if args.output.json {
        let document = json!({
            "layer": layer,
            "mean_difference": errors.mean,
            "mean_absolute_difference": errors.mean_absolute,
            "root_mean_square_difference": errors.root_mean_square,
            "largest_difference": errors.largest,
            "relative_l1": errors.relative_l1,
            "non_finite_pixels": errors.non_finite,
            "comparison": comparison.as_ref().map(verdicts::comparison_json),
            "files": written,
        });
        console::print_json(&document)?;
    } else {
        let mut text = errors.describe(layer);
        if errors.largest == 0.0 && errors.non_finite == 0 {
            text += "identical\n";
        }
        if let Some(comparison) = &comparison {
            text += &format!(
                "\nwith their standard errors\n{}{}\n",
                capwalk::comparison_text(comparison),
                sentence(comparison)
            );
        }
        if !written.is_empty() {
            text += &report::written(&written);
        }
        console::print(&text)?;
    }
    Ok(comparison.as_ref().map_or(Outcome::Done, verdicts::outcome))
}

/// Width and height of a layer, or an error that names those that there are.
fn layer_size(file: &mut ImageFile, layer: &str, path: &Path) -> Result<[usize; 2]> {
    let size = file.size(layer)?;
    size.with_context(|| {
        let known = listed(&file.names());
        format!(
            "{}: there is no layer \"{layer}\"; there are {known}",
            path.display()
        )
    })
}

/// A layer, which has this size.
fn image_of(file: &mut ImageFile, layer: &str, size: [usize; 2], path: &Path) -> Result<Image> {
    let found = layer_size(file, layer, path)?;
    ensure!(
        found == size,
        "{}: the layer \"{layer}\" has {} x {} pixels; expected {} x {}",
        path.display(),
        found[0],
        found[1],
        size[0],
        size[1]
    );
    let image = file.image(layer)?;
    image.with_context(|| format!("{}: \"{layer}\" is gone", path.display()))
}

/// The layer with the standard errors of another one: `stderr` for what the file is about,
/// `<name>_stderr` for what comes with it.
fn errors_layer(file: &ImageFile, layer: &str) -> Option<String> {
    let names = file.names();
    let about = match names.contains(&GRADIENT) {
        true => GRADIENT,
        false => VALUE,
    };
    let errors = match layer == about {
        true => "stderr".to_owned(),
        false => format!("{layer}_stderr"),
    };
    names.contains(&errors.as_str()).then_some(errors)
}

/// How far images are apart, over all channels of the finite pixels.
struct Errors {
    mean: f64,
    mean_absolute: f64,
    root_mean_square: f64,
    largest: f64,
    relative_l1: f64,
    non_finite: usize,
}

impl Errors {
    fn new(difference: &Image, reference: &Image) -> Self {
        let finite = |pixels: &[Rgb]| -> Vec<f64> {
            let pixels = pixels.iter().filter(|p| p.is_finite());
            pixels.flat_map(|p| p.to_array()).collect()
        };
        let all = finite(&difference.pixels);
        let mean_of = |values: &[f64], f: fn(f64) -> f64| {
            values.iter().map(|&x| f(x)).sum::<f64>() / values.len() as f64
        };
        let mean_absolute = mean_of(&all, f64::abs);
        Self {
            mean: mean_of(&all, |x| x),
            mean_absolute,
            root_mean_square: mean_of(&all, |x| x * x).sqrt(),
            largest: all.iter().fold(0.0, |m, x| x.abs().max(m)),
            relative_l1: mean_absolute / mean_of(&finite(&reference.pixels), f64::abs),
            non_finite: difference.pixels.len() - all.len() / 3,
        }
    }

    fn describe(&self, layer: &str) -> String {
        let mut lines = vec![
            ("layer", layer.to_owned()),
            ("mean difference", report::number(self.mean)),
            ("mean absolute", report::number(self.mean_absolute)),
            ("root mean square", report::number(self.root_mean_square)),
            ("largest", report::number(self.largest)),
            ("relative L1", report::number(self.relative_l1)),
        ];
        if self.non_finite > 0 {
            let count = report::count(self.non_finite as u64);
            lines.push(("not finite", format!("{count} pixels, left out")));
        }
        report::list(&lines)
    }
}

fn sentence(comparison: &Comparison) -> String {
    match &comparison.verdict {
        Verdict::Right => "equal within their errors".into(),
        Verdict::Wrong { reason } => format!("different: {reason}"),
        Verdict::Inconclusive {
            samples_factor,
            doubt,
        } => format!(
            "inconclusive: {}about {} times the samples would be enough",
            doubt
                .iter()
                .map(|doubt| format!("{doubt}; "))
                .collect::<String>(),
            report::significant(*samples_factor, 2)
        ),
    }
}
