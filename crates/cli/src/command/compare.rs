//! `capwalk compare`: two images, with their errors if they have them.

use anyhow::{Context, Result, ensure};
use capwalk::scene_io::image::{self, GRADIENT, LayeredImage, Panel, Style, VALUE};
use capwalk::{Comparison, Image, Rgb, Verdict};
use serde_json::json;

use super::check as verdicts;
use crate::args::Compare;
use crate::diagnostics::Outcome;
use crate::memory::{self, Need};
use crate::output::{self, Files};
use crate::{console, report};

pub fn run(args: &Compare) -> Result<Outcome> {
    let tested = image::read(&args.image)?;
    if let Some(layer) = tested.layers.first() {
        let size =
            [layer.image.width, layer.image.height].map(|n| u32::try_from(n).unwrap_or(u32::MAX));
        memory::check_size(size, Need::Comparison)?;
    }
    let reference = image::read(&args.reference)?;
    let layer = match &args.layer {
        Some(layer) => layer.as_str(),
        None if tested.layer(GRADIENT).is_some() && reference.layer(GRADIENT).is_some() => GRADIENT,
        None => VALUE,
    };
    let a = output::layer(&tested, layer).with_context(|| args.image.display().to_string())?;
    let b =
        output::layer(&reference, layer).with_context(|| args.reference.display().to_string())?;
    ensure!(
        (a.width, a.height) == (b.width, b.height),
        "the images have different sizes: {} x {} and {} x {}",
        a.width,
        a.height,
        b.width,
        b.height
    );
    let difference = Image {
        pixels: a
            .pixels
            .iter()
            .zip(&b.pixels)
            .map(|(&a, &b)| a - b)
            .collect(),
        ..*a
    };
    let errors = Errors::new(&difference, b);
    let estimates = [&tested, &reference].map(|p| output::read_estimate(p, layer));
    let comparison = match &estimates {
        // Equal images need no statistics, which would find the errors of
        // two runs with the same random numbers too large.
        [Some(a), Some(b)] if errors.largest > 0.0 => Some(capwalk::compare(a, b)),
        _ => None,
    };

    let mut written = Vec::new();
    if !args.output.output.is_empty() {
        let files = Files::new(&args.output.output, "", &[])?;
        let mut result = LayeredImage::default();
        result.push("difference", difference.clone());
        let limit = image::robust_limit([&difference]);
        let panel = Panel {
            title: "difference",
            image: &difference,
            style: Style::Diverging { limit },
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
        Verdict::Partial { .. } => "compared in part".into(),
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
