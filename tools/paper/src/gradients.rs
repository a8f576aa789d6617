//! Derivative images by several methods, their times, and how far they are
//! from a reference.

use std::borrow::Cow;

use capwalk_diff::{
    Estimate, GradientImage, GradientOptions, GradientWork, Method, PreparedScene, WalkSettings,
    finite_difference,
};
use capwalk_math::{Moments, Rgb};
use capwalk_scene::{Film, Filter, Scene, Tangent, builtin, params};
use capwalk_scene_io::image::{Scale, Style};
use cpu_time::ProcessTime;

use crate::claim::Measured;
use crate::figure::Shown;
use crate::settings::{Failure, Settings, complete};

/// A scene and what moves in it.
pub struct Subject {
    pub scene: Scene,
    pub tangent: Tangent,
    /// Half the distance of finite differences.
    pub step: f64,
}

impl Subject {
    /// A built-in scene with its parameter, in so many pixels with a box filter.
    pub fn builtin(name: &str, [width, height]: [u32; 2], step: f64) -> Result<Self, Failure> {
        let unusable = |reason: String| Failure::Unusable(format!("scene {name}: {reason}"));
        let scene = builtin::scene(name).ok_or_else(|| unusable("it is not built in".into()))?;
        let parameter = builtin::default_parameter(name).expect("it is built in");
        Self::new(scene, parameter, [width, height], step)
    }

    /// A scene with one of its parameters.
    pub fn new(
        mut scene: Scene,
        parameter: &str,
        [width, height]: [u32; 2],
        step: f64,
    ) -> Result<Self, Failure> {
        scene.film = Film::new(width, height, Filter::Box);
        let tangent = params::Registry::new(&scene).tangent(&scene, parameter);
        Ok(Self {
            tangent: tangent.map_err(|error| Failure::Unusable(error.to_string()))?,
            scene,
            step,
        })
    }

    /// The derivative by a method, with seconds.
    pub fn gradient(
        &self,
        method: Method,
        walk: WalkSettings,
        spp: u32,
        set: u64,
        settings: &Settings,
    ) -> Result<Run, Failure> {
        let watch = (settings.stages)(method.name());
        let wanted = GradientOptions {
            method,
            walk,
            ..GradientOptions::new(settings.options(spp, set))
        };
        let started = ProcessTime::now();
        let prepared = PreparedScene::new(self.scene.clone());
        let tangent = Cow::Borrowed(&self.tangent);
        let work = GradientWork::new(&prepared, tangent, wanted);
        let options = work.chosen(&*watch)?.options;
        let image = work.whole(&*watch)?;
        complete(&image.statistics)?;
        Ok(Run {
            image,
            spp,
            reach: options.walk.max_radius,
            seconds: started.elapsed().as_secs_f64(),
        })
    }

    /// The derivative by finite differences, with seconds.
    pub fn difference(&self, spp: u32, set: u64, settings: &Settings) -> Result<Run, Failure> {
        let watch = (settings.stages)("differences");
        let options = settings.options(spp, set);
        let started = ProcessTime::now();
        let prepared = PreparedScene::new(self.scene.clone());
        let image = finite_difference(&prepared, &self.tangent, self.step, &options, &*watch)?;
        complete(&image.statistics)?;
        Ok(Run {
            image,
            spp,
            reach: 0.0,
            seconds: started.elapsed().as_secs_f64(),
        })
    }
}

/// A derivative image and what it cost.
pub struct Run {
    pub image: GradientImage,
    pub spp: u32,
    /// How far the fields of its walks around surfaces reach, radians.
    pub reach: f64,
    /// Of the CPU, all threads together: other programs do not lengthen it.
    pub seconds: f64,
}

impl Run {
    pub fn gradient(&self) -> &Estimate {
        &self.image.gradient
    }

    /// The variance of a sample of the derivative, mean over pixels and channels.
    pub fn variance(&self) -> Measured {
        let mut variance = Moments::default();
        for error in &self.gradient().standard_error.pixels {
            variance.add(f64::from(self.spp) * error.dot(*error) / 3.0);
        }
        variance.into()
    }
}

/// Mean absolute difference over pixels and channels. Pixels are sampled
/// independently of each other, so their spread is its error.
pub fn mean_l1(gradient: &Estimate, reference: &Estimate) -> Measured {
    let mut moments = Moments::default();
    distances(gradient, reference).for_each(|distance| moments.add(distance));
    moments.into()
}

/// By how much the mean absolute difference of one image from a reference is below
/// that of another one, pixel by pixel: what the scene makes of both drops out.
pub fn l1_gain(gradient: &Estimate, other: &Estimate, reference: &Estimate) -> Measured {
    let mut moments = Moments::default();
    let [ours, theirs] = [gradient, other].map(|estimate| distances(estimate, reference));
    ours.zip(theirs)
        .for_each(|(ours, theirs)| moments.add(theirs - ours));
    moments.into()
}

/// Absolute differences of pixels, means over channels.
fn distances(gradient: &Estimate, reference: &Estimate) -> impl Iterator<Item = f64> {
    let pairs = gradient.mean.pixels.iter().zip(&reference.mean.pixels);
    pairs.map(|(a, b)| (*a - *b).to_array().map(f64::abs).iter().sum::<f64>() / 3.0)
}

/// Derivatives side by side, colours within a limit.
pub fn shown(images: &[(String, &Estimate)], limit: f64) -> Vec<Shown> {
    let shown = images.iter().map(|(title, estimate)| Shown {
        title: title.clone(),
        image: estimate.mean.clone(),
        style: Style::Diverging(Scale::even(limit)),
    });
    shown.collect()
}

/// What of the mean squared distance from a reference is noise of the image, and
/// what is neither that nor noise of the reference: bias. Squares add.
pub struct Squares {
    pub noise: f64,
    /// Zero but for its error for an image without bias.
    pub bias: Measured,
}

impl Squares {
    pub fn of(gradient: &Estimate, reference: &Estimate) -> Self {
        let (mut noise, mut bias) = (Moments::default(), Moments::default());
        let square = |x: Rgb| x.dot(x) / 3.0;
        for i in 0..gradient.mean.pixels.len() {
            let [own, other] =
                [gradient, reference].map(|estimate| square(estimate.standard_error.pixels[i]));
            let distance = square(gradient.mean.pixels[i] - reference.mean.pixels[i]);
            noise.add(own);
            bias.add(distance - own - other);
        }
        Self {
            noise: noise.mean,
            bias: bias.into(),
        }
    }
}

/// Mean absolute value over pixels and channels.
pub fn mean_size(gradient: &Estimate) -> Measured {
    let mut moments = Moments::default();
    for pixel in &gradient.mean.pixels {
        let sizes = pixel.to_array().map(f64::abs);
        moments.add(sizes.iter().sum::<f64>() / 3.0);
    }
    moments.into()
}
