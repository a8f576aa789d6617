//! Checks a gradient against central differences and prints the verdict: right, wrong, or
//! inconclusive, with the number of samples that would be enough. Do this before an
//! optimisation of a new scene, and after any change to an estimator.

use capwalk::{CheckOptions, GradientOptions, Loader, Prepared, Unwatched, Verdict};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = Loader::new("leaf").size([32, 24]).load()?.scene;
    let prepared = Prepared::new(scene)?;
    let mut options = CheckOptions {
        gradient: GradientOptions {
            spp: 32,
            ..GradientOptions::default()
        },
        ..CheckOptions::default()
    };
    loop {
        let check = prepared.check("leaf.translate.x", &options, &Unwatched)?;
        let comparison = &check.comparison;
        println!(
            "{} samples per pixel, differences over ±{:.4}: mean z² {:.3} ± {:.3}",
            options.gradient.spp,
            check.made.step,
            comparison.mean_z_squared,
            comparison.mean_z_squared_error,
        );
        match &comparison.verdict {
            Verdict::Right => println!("right"),
            Verdict::Wrong { reason } => println!("wrong: {reason}"),
            // Noise hides the answer: take as many samples as are estimated to be enough.
            Verdict::Inconclusive { samples_factor, .. } => {
                println!("inconclusive: {samples_factor:.1} times the samples would be enough");
                let enough = f64::from(options.gradient.spp) * samples_factor.min(8.0);
                options.gradient.spp = enough.ceil() as u32;
                continue;
            }
        }
        return Ok(());
    }
}
