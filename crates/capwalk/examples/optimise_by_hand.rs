//! An optimisation loop written by hand: finds the colour of a floor from an image of it
//! by gradient descent. The scene is prepared once and only its numbers change. For steps
//! of Adam, bounds, meshes, checkpoints and all the rest, see `capwalk::optimize`.

use capwalk::{Distance, GradientOptions, Loader, Loss, Prepared, RenderOptions, Unwatched};

const COLOUR: &str = "floor.bsdf.reflectance.value";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = Loader::new("leaf").size([24, 18]).load()?.scene;
    let mut prepared = Prepared::new(scene)?;

    // The target: an image with the colour that is to be found.
    let start = prepared.values(COLOUR)?.numbers;
    prepared.update(COLOUR, &[0.5, 0.6, 0.3])?;
    let sampling = RenderOptions::new(256, 1);
    let target = prepared.render(&sampling, &Unwatched)?.value.mean;
    prepared.update(COLOUR, &start)?;

    let loss = Loss {
        distance: Distance::L2,
        levels: 1,
    };
    // Where edges move, the first iteration chooses a method, and the others keep it. A colour moves
    // none.
    let rate = 0.5;
    for iteration in 0..40 {
        // Every iteration has random numbers of its own, and its image others than its
        // gradient.
        let options = GradientOptions {
            spp: 16,
            seed: 100 + iteration,
            ..GradientOptions::default()
        };
        let sampling = options.sampling();
        let seen = prepared.loss(&loss, &target, None, &sampling, &Unwatched)?;
        let adjoint = &seen.measured.adjoint;
        let gradients = prepared.backward(adjoint, &[COLOUR], &options, &Unwatched)?;

        // One step against the gradient.
        let numbers = prepared.values(COLOUR)?.numbers;
        let pairs = numbers.iter().zip(&gradients[COLOUR].numbers);
        let stepped: Vec<f64> = pairs.map(|(x, g)| (x - rate * g).clamp(0.0, 1.0)).collect();
        prepared.update(COLOUR, &stepped)?;
        if iteration % 5 == 0 {
            println!(
                "{iteration:2}  loss {:.6}  {stepped:.3?}",
                seen.measured.value
            );
        }
    }
    println!("found {:.3?}", prepared.values(COLOUR)?.numbers);
    Ok(())
}
