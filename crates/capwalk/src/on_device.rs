//! Images and derivatives on a device.

use capwalk_diff::{
    Chosen, GradientImage, GradientOptions, Method, RenderOptions, Rendering, Wanted, Watch,
};
use capwalk_scene::Image;

use crate::backward::Gradients;
use crate::device::{Device, Found, OnDevice};
use crate::direction::Direction;
use crate::error::Error;
use crate::gpu_work;
use crate::options::check_spp;
use crate::prepared::Prepared;

impl Prepared {
    /// [`Prepared::render`] on a device. A GPU takes the CPU's samples, with its random
    /// numbers, and rounds differently: the same scene, seed, options and device give the same
    /// bits. The first image opens the device, and the process keeps it until it is lost. An error
    /// if it is asked for and there is none, if it has not all that the scene needs, or if it
    /// fails; the feature `gpu` must have been built.
    ///
    /// ```
    /// # use capwalk::{Device, Prepared, RenderOptions, Unwatched};
    /// # let scene = capwalk::Loader::new("leaf").size([8, 6]).load()?.scene;
    /// # let prepared = Prepared::new(scene)?;
    /// let image = prepared.render_on(Device::Auto, &RenderOptions::new(4, 1), &Unwatched)?;
    /// assert!(image.result.statistics.complete);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn render_on(
        &self,
        device: Device,
        options: &RenderOptions,
        watch: &dyn Watch,
    ) -> Result<OnDevice<Rendering>, Error> {
        check_spp("spp", options.spp)?;
        let found = gpu_work::image(self.prepared_scene(), device, options, watch)?;
        or_else(found, None, || Ok((self.render(options, watch)?, None)))
    }

    /// [`Prepared::gradient`] on a device, see [`Prepared::render_on`]. A GPU has derivatives with
    /// respect to the numbers of materials, to what emitters send, and to what moves, by
    /// [`Method::EDGES`]; [`Device::Auto`] takes the CPU for what it has not.
    ///
    /// ```
    /// # use capwalk::{Device, GradientOptions, Prepared, Unwatched};
    /// # let scene = capwalk::Loader::new("leaf").size([8, 6]).load()?.scene;
    /// # let prepared = Prepared::new(scene)?;
    /// let options = GradientOptions { spp: 4, ..GradientOptions::default() };
    /// let name = "leaf.bsdf.reflectance.value";
    /// let found = prepared.gradient_on(Device::Auto, name, &options, &Unwatched)?;
    /// assert!(found.result.statistics.complete);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn gradient_on<D: Direction + ?Sized>(
        &self,
        device: Device,
        direction: &D,
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<OnDevice<GradientImage>, Error> {
        let tangent = direction.tangent(self.scene(), self.registry())?;
        let work = self.gradient_work(direction, options)?;
        let found = gpu_work::gradient(self.prepared_scene(), device, &tangent, options, watch)?;
        let there = by_method(options, Wanted::by(&tangent).moves());
        or_else(found, Some(there), || {
            let chosen = work.chosen(watch)?;
            Ok((work.whole(watch)?, Some(chosen)))
        })
    }

    /// [`Prepared::backward`] on a device, see [`Prepared::gradient_on`].
    pub fn backward_on<N: AsRef<str>>(
        &self,
        device: Device,
        adjoint: &Image,
        names: &[N],
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<OnDevice<Gradients>, Error> {
        let work = self.backward_work(adjoint, names, options)?;
        let loss = (adjoint, work.wanted());
        let found = gpu_work::backward(self.prepared_scene(), device, loss, options, watch)?;
        let found = match found {
            Found::There { result, adapter } => Found::There {
                result: work.by_name(&result),
                adapter,
            },
            Found::Cpu { remark } => Found::Cpu { remark },
        };
        let there = by_method(options, work.wanted().moves());
        or_else(found, Some(there), || {
            let chosen = work.chosen(watch)?;
            Ok((work.whole(watch)?, Some(chosen)))
        })
    }
}

/// The options with the method that a GPU has. Where nothing moves all methods are one, and the
/// choice of the CPU is the walk.
fn by_method(options: &GradientOptions, moves: bool) -> GradientOptions {
    let method = match options.method {
        Method::Auto if moves => Method::EDGES,
        Method::Auto => Method::Walk,
        method => method,
    };
    GradientOptions { method, ..*options }
}

/// What a GPU computed, by these options if it is a derivative, or else the CPU, which may have
/// chosen a method.
fn or_else<T>(
    found: Found<T>,
    options: Option<GradientOptions>,
    on_cpu: impl FnOnce() -> Result<(T, Option<Chosen>), Error>,
) -> Result<OnDevice<T>, Error> {
    match found {
        Found::There { result, adapter } => Ok(OnDevice {
            result,
            adapter: Some(adapter),
            remark: None,
            chosen: options.map(|options| Chosen {
                options,
                trials: Vec::new(),
            }),
        }),
        Found::Cpu { remark } => {
            let (result, chosen) = on_cpu()?;
            Ok(OnDevice {
                result,
                adapter: None,
                remark,
                chosen,
            })
        }
    }
}
