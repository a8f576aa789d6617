//! Forward mode against reverse mode, along a motion of everything.

use capwalk_diff::{
    GradientOptions, Method, PreparedScene, RenderOptions, Unwatched, Wanted, backward, gradient,
};
use capwalk_math::{Rgb, Vec3};
use capwalk_scene::*;

use super::v;

/// Numbers between -1 and 1 that look random.
struct Numbers(u64);

impl Numbers {
    fn number(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
    fn vector(&mut self) -> Vec3 {
        v(self.number(), self.number(), self.number())
    }
    fn vectors(&mut self, count: usize) -> Vec<Vec3> {
        (0..count).map(|_| self.vector()).collect()
    }
}

/// Every number of the scene changes at a velocity of its own.
pub fn everything(scene: &Scene, seed: u64) -> Tangent {
    let mut numbers = Numbers(seed);
    let mut tangent = Tangent::zero(scene);
    for (shape, tangent) in scene.shapes.iter().zip(&mut tangent.shapes) {
        let count = shape.mesh.positions.len();
        *tangent = Some(ShapeVectors {
            vertices: numbers.vectors(count),
            normals: match &shape.normals {
                ShadingNormals::Given(_) => Some(numbers.vectors(count)),
                _ => None,
            },
        });
    }
    for (texture, tangent) in scene.textures.iter().zip(&mut tangent.textures) {
        *tangent = Some(texture.data.iter().map(|_| numbers.number()).collect());
    }
    tangent.sensor = SensorVectors {
        translation: numbers.vector(),
        rotation: numbers.vector(),
        axes: [0, 1, 2].map(|_| numbers.vector()),
        optics: numbers.vector(),
    };
    tangent
}

/// An adjoint whose numbers look random.
pub fn adjoint(scene: &Scene, seed: u64) -> Image {
    let [width, height] = scene.film.crop_size.map(|n| n as usize);
    Image {
        width,
        height,
        pixels: Numbers(seed)
            .vectors(width * height)
            .into_iter()
            .map(|v| Rgb::from(v.to_array()))
            .collect(),
    }
}

/// Both modes take the same samples.
pub fn settings(spp: u32) -> GradientOptions {
    GradientOptions {
        blind: true,
        method: Method::Walk,
        ..GradientOptions::new(RenderOptions::new(spp, 5))
    }
}

/// The product, and the sum of the absolute values of what is summed.
pub fn forward_by(
    prepared: &PreparedScene,
    tangent: &Tangent,
    settings: &GradientOptions,
) -> (f64, f64) {
    let result = gradient(prepared, tangent, settings, &Unwatched).expect("covered");
    let pixels = result.gradient.mean.pixels.iter();
    let adjoint = adjoint(prepared.scene(), 3);
    let products = pixels.zip(&adjoint.pixels).map(|(a, &b)| a.dot(b));
    (products.clone().sum(), products.map(f64::abs).sum())
}

/// Few pixels, paths of so many segments.
pub fn small(scene: &mut Scene, depth: u32) {
    scene.film.size = [12; 2];
    scene.film.crop_size = [12; 2];
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(depth),
        rr_depth: 3,
        hide_emitters: false,
    };
    scene.check().expect("a valid scene");
}

/// Demands that both modes agree along a motion, up to rounding.
pub fn agree_by(
    name: &str,
    prepared: &PreparedScene,
    tangent: &Tangent,
    settings: &GradientOptions,
) {
    let (forward, size) = forward_by(prepared, tangent, settings);
    let wanted = Wanted::by(tangent);
    let reverse = backward(
        prepared,
        &adjoint(prepared.scene(), 3),
        &wanted,
        settings,
        &Unwatched,
    );
    let (reverse, error) = reverse.expect("covered").along(tangent);
    println!("{name}: forward {forward}, reverse {reverse} ± {error:.2e}");
    let difference = (forward - reverse).abs();
    assert!(forward.abs() > 1e-3, "{name}: nothing to compare");
    assert!(difference <= 1e-10 * size, "{name}: {difference:e}");
}
