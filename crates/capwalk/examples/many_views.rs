//! The gradient of a loss over many views: where is a ball whose images from all sides are
//! given? Each camera is one prepared scene; shapes and textures are shared between them.
//! The gradients of the views add up, and so do their variances.

use capwalk::{Distance, GradientOptions, Loader, Loss, Prepared, RenderOptions, Unwatched};

const VIEWS: u32 = 6;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = Loader::new("ball").size([24, 18]).load()?.scene;
    let loss = Loss {
        distance: Distance::L2,
        levels: 2,
    };
    let (mut total, mut sum, mut variance) = (0.0, 0.0, 0.0);
    for view in 0..VIEWS {
        // The camera of the scene, moved sideways step by step.
        let mut prepared = Prepared::new(scene.clone())?;
        let offset = 0.6 * (f64::from(view) / f64::from(VIEWS - 1) - 0.5);
        prepared.update("sensor.translate", &[offset, 0.0, 0.0])?;

        // What it should see: the ball in another place.
        let mut target_scene = Prepared::new(prepared.scene().clone())?;
        let moved = target_scene.values("ball.positions")?.numbers;
        let moved: Vec<f64> = moved
            .chunks(3)
            .flat_map(|p| [p[0] + 0.1, p[1], p[2]])
            .collect();
        target_scene.update("ball.positions", &moved)?;
        let sampling = RenderOptions::new(64, 7);
        let target = target_scene.render(&sampling, &Unwatched)?.value.mean;

        // Each view has a seed of its own, so that their noise is independent.
        let options = GradientOptions {
            spp: 32,
            seed: u64::from(view),
            ..GradientOptions::default()
        };
        let sampling = options.sampling();
        let seen = prepared.loss(&loss, &target, None, &sampling, &Unwatched)?;
        let adjoint = &seen.measured.adjoint;
        let names = ["ball.translate.x"];
        let gradients = prepared.backward(adjoint, &names, &options, &Unwatched)?;
        let gradient = &gradients[names[0]];
        println!(
            "view {view}: {:+.5} ± {:.5}",
            gradient.size, gradient.size_error
        );
        total += seen.measured.value / f64::from(VIEWS);
        sum += gradient.size / f64::from(VIEWS);
        variance += (gradient.size_error / f64::from(VIEWS)).powi(2);
    }
    println!(
        "all: loss {total:.5}, gradient {sum:+.5} ± {:.5}",
        variance.sqrt()
    );
    Ok(())
}
