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
        device: args.device,
        ..source::options(&args.sampling, scene)
    };
    memory::check(scene, Need::Image)?;
    let stem = source::stem(&args.scene);
    let files = Files::new(&args.output.output, &stem, &["exr", "png"], &read)?;

    let progress = Progress::new("render", progress::left_of(args.sampling.time_limit));
    let rendering = prepared.render(&options, &progress)?;
    let elapsed = progress.finish().as_secs_f64();
    let (value, statistics) = (&rendering.value, &rendering.statistics);
    console::remark(&report::remark_on_device(statistics));
    if statistics.samples == 0 {
        return report::nothing("a sample of the image was taken");
    }
    let mut layered = output::layered("render", &args.scene, None, &options);
    output::note_device(&mut layered, statistics);
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
            "device": statistics.device.name(),
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
