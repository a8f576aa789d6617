//! `capwalk render`: an image.

use anyhow::Result;
use capwalk::RenderOptions;
use serde_json::json;

use crate::args::Render;
use crate::diagnostics::Outcome;
use crate::memory::{self, Need};
use crate::output::{self, Files};
use crate::progress::{self, Progress};
use crate::{console, report, source};

pub fn run(args: &Render) -> Result<Outcome> {
    let (prepared, read) = source::load(&args.scene)?;
    let scene = prepared.scene();
    let options = RenderOptions {
        adaptive: args.adaptive,
        ..source::options(&args.sampling, scene)
    };
    memory::check(scene, Need::Image)?;
    let stem = source::stem(&args.scene);
    let files = Files::new(&args.output.output, &stem, &["exr", "png"], &read)?;

    let progress = Progress::new("render", progress::left_of(args.sampling.time_limit));
    let found = prepared.render_on(args.device, &options, &progress)?;
    let elapsed = progress.finish().as_secs_f64();
    if let Some(remark) = &found.remark {
        console::remark(&format!("{remark}\n"));
    }
    let (rendering, adapter) = (found.result, found.adapter);

    let (value, statistics) = (&rendering.value, &rendering.statistics);
    if statistics.samples == 0 {
        return report::nothing("a sample of the image was taken");
    }
    let mut layered = output::layered("render", &args.scene, None, &options);
    if let Some(adapter) = &adapter {
        output::note(&mut layered, "device", adapter);
    }
    output::push_statistics(&mut layered, &[statistics]);
    output::push_estimate(&mut layered, "value", "stderr", value);
    let written = files.write(&layered, &[])?;
    console::remark(&report::warnings("image", statistics));
    if args.output.json {
        let document = json!({
            "scene": args.scene.scene,
            "set": source::settings_json(&args.scene),
            "size": scene.film.crop_size,
            "spp": options.spp,
            "seed": options.seed,
            "device": adapter.as_deref().unwrap_or("cpu"),
            "mean": report::mean_colour(&value.mean),
            "statistics": report::statistics_json(statistics, elapsed),
            "files": written,
        });
        console::print_json(&document)?;
    } else {
        console::print(&format!(
            "{}{}",
            report::work("render", statistics, elapsed),
            report::written(&written)
        ))?;
    }
    Ok(report::outcome(&[statistics]))
}
