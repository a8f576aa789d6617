//! The front door: a scene that is ready for any number of images and gradients.

use std::collections::BTreeSet;
use std::sync::{Arc, OnceLock};

use capwalk_diff::check::Verdict;
use capwalk_diff::{
    Chosen, Device, Differences, GradientImage, GradientOptions, GradientWork, KeptChoice,
    PreparedScene, Refusal, RenderOptions, RenderWork, Rendering, Watch,
};
use capwalk_scene::params::Registry;
use capwalk_scene::{Image, Scene, SceneError, Tangent};

use crate::backward::{self, GradientNames, Gradients, GradientsWork};
use crate::check::{Check, CheckOptions, Reference, SECOND_FACTOR};
use crate::choices::{Choices, Differentiated};
use crate::coplanar::coplanar;
use crate::direction::Direction;
use crate::edge_on::{EdgeOnFace, edge_on};
use crate::error::Error;
use crate::gpu_work;
use crate::loss::{self, ImageLoss, Loss};
use crate::method::OptionError;
use crate::options::{self, DifferenceOptions, check_spp, refuse_gpu};
use crate::step::difference_step;

/// A scene that is ready to be rendered and differentiated. It owns all that it needs
/// and can be shared between threads.
///
/// ```
/// use capwalk::{Prepared, RenderOptions, Unwatched};
///
/// let scene = capwalk::Loader::new("leaf").size([8, 6]).load()?.scene;
/// let prepared = Prepared::new(scene)?;
/// let options = RenderOptions { spp: 4, ..RenderOptions::default() };
/// let image = prepared.render(&options, &Unwatched)?.value.mean;
/// assert_eq!((image.width, image.height), (8, 6));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Prepared {
    prepared: PreparedScene,
    /// Made when the first name is asked for. Numbers that change do not change names.
    registry: OnceLock<Registry>,
    /// The methods that were chosen for this scene, or before numbers of it changed.
    choices: Choices,
}

/// What has no GPU yet.
const IN_PARTS: &str = "work in parts";

/// Numbers of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// Dimensions; none for a single number.
    pub shape: Vec<usize>,
    /// Row by row.
    pub numbers: Vec<f64>,
}

impl Prepared {
    /// Makes a scene ready, or says why it cannot be rendered.
    pub fn new(scene: impl Into<Arc<Scene>>) -> Result<Self, SceneError> {
        let scene = scene.into();
        scene.check()?;
        Ok(Self::of(PreparedScene::new(scene)))
    }

    /// [`Self::new`], unless the watch stops it: [`Error::Stopped`]. What a gradient needs besides is
    /// prepared by the first one, and stopped by its watch.
    pub fn watched(scene: impl Into<Arc<Scene>>, watch: &dyn Watch) -> Result<Self, Error> {
        let scene = scene.into();
        scene.check()?;
        let prepared = PreparedScene::try_new(scene, watch).map_err(Refusal::from)?;
        Ok(Self::of(prepared))
    }

    fn of(prepared: PreparedScene) -> Self {
        Self {
            prepared,
            registry: OnceLock::new(),
            choices: Choices::default(),
        }
    }

    /// The scene as it is now.
    pub fn scene(&self) -> &Arc<Scene> {
        self.prepared.scene()
    }

    /// The names of all parameters of the scene; made by the first call.
    pub fn registry(&self) -> &Registry {
        self.registry.get_or_init(|| Registry::new(self.scene()))
    }

    /// An image with its standard errors. On the CPU it is an error only if the options ask for no
    /// samples.
    ///
    /// A GPU ([`RenderOptions::device`]) takes the CPU's samples, with its random numbers, and rounds
    /// differently: the same scene, seed, options and device give the same bits. The first image
    /// opens the device, and the process keeps it until it is lost. An error if it is asked for and
    /// there is none, if it has not all that the scene needs, or if it fails; the feature `gpu` must
    /// have been built.
    ///
    /// If `watch` stops the work, what was done is returned, and the statistics say how
    /// much that is.
    ///
    /// ```
    /// # use capwalk::{Prepared, RenderOptions, Unwatched};
    /// # let scene = capwalk::Loader::new("leaf").size([8, 6]).load()?.scene;
    /// # let prepared = Prepared::new(scene)?;
    /// let rendering = prepared.render(&RenderOptions::new(4, 1), &Unwatched)?;
    /// assert!(rendering.statistics.complete);
    /// assert!(rendering.value.standard_error.pixels[0].is_finite());
    ///
    /// let options = RenderOptions { device: capwalk::Device::Auto, ..RenderOptions::new(4, 1) };
    /// let rendering = prepared.render(&options, &Unwatched)?;
    /// println!("rendered on {}", rendering.statistics.device.name());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn render(&self, options: &RenderOptions, watch: &dyn Watch) -> Result<Rendering, Error> {
        check_spp("spp", options.spp)?;
        let found = gpu_work::image(&self.prepared, options, watch)?;
        let on_cpu = || Ok(capwalk_diff::render(&self.prepared, options, watch));
        found.or_on_cpu(on_cpu, |image| &mut image.statistics)
    }

    /// The derivative of the image along a direction, such as `"ball.translate.x"`, per
    /// unit of that parameter, with standard errors; and the image that comes with it.
    ///
    /// The first one by a motion lists the boundaries of the scene: [`Error::Stopped`] if `watch`
    /// stops that. If it stops the sampling, what was done is returned.
    ///
    /// A GPU, see [`Prepared::render`], has derivatives with respect to the numbers of materials, to
    /// what emitters send, and to what moves, by [`Method::EDGES`](crate::Method::EDGES); [`Device::Auto`] takes the CPU
    /// for what it has not.
    ///
    /// ```
    /// use capwalk::{GradientOptions, Unwatched};
    /// # let scene = capwalk::Loader::new("leaf").size([8, 6]).load()?.scene;
    /// # let prepared = capwalk::Prepared::new(scene)?;
    /// let options = GradientOptions { spp: 8, ..GradientOptions::default() };
    /// let result = prepared.gradient("leaf.translate.x", &options, &Unwatched)?;
    /// // The shadow moves: some pixels get brighter, others darker.
    /// let greens = || result.gradient.mean.pixels.iter().map(|pixel| pixel.g);
    /// assert!(greens().any(|g| g > 0.0) && greens().any(|g| g < 0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn gradient<D: Direction + ?Sized>(
        &self,
        direction: &D,
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<GradientImage, Error> {
        let work = self.gradient_on_cpu(direction, options)?;
        let found = gpu_work::gradient(&self.prepared, work.tangent(), options, watch)?;
        found.or_on_cpu(|| Ok(work.whole(watch)?), |image| &mut image.statistics)
    }

    /// The method that [`Prepared::gradient`] uses on the CPU with these options, and what was tried
    /// to find it: with [`Method::Auto`](crate::Method::Auto) a pilot chooses, in a small part of the time of a long
    /// gradient, and in at most half of that of a short one. A gradient with the options that
    /// come back has the same bits.
    ///
    /// It is chosen once for an expression and for about as many samples, by the first call that
    /// needs it, and kept while the numbers of the scene change ([`Prepared::update`]). It does not
    /// depend on seeds. [`Prepared::update_scene`] and a new `Prepared` choose again.
    ///
    /// ```
    /// use capwalk::{GradientOptions, Method, Unwatched};
    /// # let scene = capwalk::Loader::new("leaf").size([8, 6]).load()?.scene;
    /// # let prepared = capwalk::Prepared::new(scene)?;
    /// let options = GradientOptions { spp: 8, ..GradientOptions::default() };
    /// let chosen = prepared.choose("leaf.translate.x", &options, &Unwatched)?;
    /// assert_ne!(chosen.options.method, Method::Auto);
    /// let result = prepared.gradient("leaf.translate.x", &chosen.options, &Unwatched)?;
    /// let same = prepared.gradient("leaf.translate.x", &options, &Unwatched)?;
    /// assert_eq!(result.gradient, same.gradient);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn choose<D: Direction + ?Sized>(
        &self,
        direction: &D,
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<Chosen, Error> {
        refuse_gpu("the choice of a method", options.device)?;
        Ok(self.gradient_on_cpu(direction, options)?.chosen(watch)?)
    }

    /// The derivative of the image along a direction by finite differences with common
    /// random numbers: the reference that [`Prepared::gradient`] is checked against. Off
    /// by a term of the order of the step squared, and noisier the smaller the step. They are
    /// central, or one-sided where the scene is valid on one side alone.
    pub fn finite_difference<D: Direction + ?Sized>(
        &self,
        direction: &D,
        options: &DifferenceOptions,
        watch: &dyn Watch,
    ) -> Result<GradientImage, Error> {
        let tangent = direction.tangent(self.scene(), self.registry())?;
        check_spp("spp", options.spp)?;
        let step = options::step(options.step, || self.fine_difference_step(&tangent))?;
        let differences = Differences::new(&self.prepared, &tangent, step)?;
        Ok(differences.image(&options.sampling(), watch))
    }

    /// The step that the differences of a check along this motion take by default, in units of
    /// the parameter.
    pub fn difference_step(&self, tangent: &Tangent) -> f64 {
        difference_step(&self.prepared, tangent)
    }

    /// The step that [`Prepared::finite_difference`] takes by default: a quarter of
    /// [`Prepared::difference_step`], like the second reference of a check. Nobody is told of the
    /// bias of differences that stand by themselves.
    pub fn fine_difference_step(&self, tangent: &Tangent) -> f64 {
        self.difference_step(tangent) / f64::from(SECOND_FACTOR)
    }

    /// Pairs of shapes, by name, that have faces in one plane which overlap there and move
    /// against each other: which of them is seen is decided by rounding, and where they part,
    /// the image has other derivatives to one side than to the other. Flat emitters are in front
    /// of what lies in their plane: with them, only pairs that leave the plane.
    pub fn coplanar_shapes(&self, tangent: &Tangent) -> Vec<[String; 2]> {
        self.named(coplanar(self.scene(), tangent))
    }

    /// Pairs of shapes by name.
    fn named(&self, pairs: BTreeSet<[usize; 2]>) -> Vec<[String; 2]> {
        let name = |i: usize| self.scene().shapes[i].id.clone();
        pairs.into_iter().map(|pair| pair.map(name)).collect()
    }

    /// Pairs of shapes, by name: an edge of the first lies on a face of the second and moves off it.
    /// To one side of the motion a gap opens, to the other they cross, so the image has other
    /// derivatives to one side than to the other. Without any if the watch stops the search.
    pub fn touching_shapes(&self, tangent: &Tangent, watch: &dyn Watch) -> Vec<[String; 2]> {
        let found = self.prepared.touching(tangent, watch);
        self.named(found.unwrap_or_default())
    }

    /// Faces in the image that the camera, which is in their planes, sees edge-on and moves against:
    /// one side of them comes into view to one side of the motion and the other to the other, so the
    /// image has other derivatives to one side than to the other.
    pub fn edge_on_faces(&self, tangent: &Tangent) -> Vec<EdgeOnFace> {
        edge_on(self.scene(), tangent)
    }

    /// A gradient and its reference by central differences, with a verdict. On the CPU.
    ///
    /// ```
    /// use capwalk::{CheckOptions, GradientOptions, Unwatched, Verdict};
    /// # let scene = capwalk::Loader::new("leaf").size([8, 6]).load()?.scene;
    /// # let prepared = capwalk::Prepared::new(scene)?;
    /// let options = CheckOptions {
    ///     gradient: GradientOptions { spp: 64, ..GradientOptions::default() },
    ///     ..CheckOptions::default()
    /// };
    /// let check = prepared.check("leaf.translate.x", &options, &Unwatched)?;
    /// assert!(!matches!(check.comparison.verdict, Verdict::Wrong { .. }));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn check<D: Direction + ?Sized>(
        &self,
        direction: &D,
        options: &CheckOptions,
        watch: &dyn Watch,
    ) -> Result<Check, Error> {
        refuse_gpu("a check", options.gradient.device)?;
        let tangent = &*direction.tangent(self.scene(), self.registry())?;
        let work = self.gradient_on_cpu(direction, &options.gradient)?;
        work.prepare(watch)?;
        // Before the gradient is estimated.
        let reference =
            options.reference(self.scene(), tangent, || self.difference_step(tangent))?;
        let chosen = work.chosen(watch)?.options;
        let gradient = work.whole(watch)?;
        drop(work); // what it knows of the motion can be large
        self.checked(gradient, tangent, reference, &chosen, watch)
    }

    /// A gradient that was estimated with these options, with a reference and a verdict.
    ///
    /// Differences have a bias that grows with their step, and errors that are too small where
    /// few rare events were met. Where they contradict the gradient or leave a doubt of it, others
    /// decide, with more samples, and over a part of the step unless one was asked for. A gradient is
    /// called wrong only by two references that do not contradict each other. Its errors may be too
    /// small, too: it is called wrong only if another estimate of it, with more samples, is
    /// contradicted as well, and called wrong beside references of its own.
    ///
    /// [`Error::Stopped`] if `watch` stopped either before its first sample.
    pub fn checked(
        &self,
        gradient: GradientImage,
        tangent: &Tangent,
        reference: Reference,
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<Check, Error> {
        refuse_gpu("a check", options.device)?;
        let again = |options: &GradientOptions| {
            let work = self.gradient_on_cpu(tangent, options)?;
            Ok(work.whole(watch)?)
        };
        self.checked_with(gradient, tangent, reference, options, &again, watch)
    }

    /// The check, where further gradients come from `again`.
    pub(crate) fn checked_with(
        &self,
        gradient: GradientImage,
        tangent: &Tangent,
        reference: Reference,
        options: &GradientOptions,
        again: &dyn Fn(&GradientOptions) -> Result<GradientImage, Error>,
        watch: &dyn Watch,
    ) -> Result<Check, Error> {
        // Nothing beside something is no comparison.
        let sampled = |image: &GradientImage, before| match image.statistics.samples {
            0 => Err(Error::Stopped { before }),
            _ => Ok(()),
        };
        sampled(&gradient, "a sample of the gradient was taken")?;
        let made = self.reference(&gradient, tangent, reference, watch)?;
        sampled(&made.1, "a sample of the reference was taken")?;
        let mut check = Check::new(gradient, made, self.coplanar_shapes(tangent));
        while let Some(next) = check.next_reference()
            && !watch.should_stop()
        {
            let made = self.reference(&check.gradient, tangent, next, watch)?;
            check = check.with_next_reference(made);
        }
        let mut check = check.decided();
        check.edge_on = self.edge_on_faces(tangent);
        // Those that lie in the plane of the other are listed already.
        let mut touching = self.touching_shapes(tangent, watch);
        touching.retain(|[a, b]| {
            let mut listed = check.coplanar.iter();
            !listed.any(|pair| pair.contains(a) && pair.contains(b))
        });
        check.touching = touching;
        let Some(more) = check.second_gradient(options) else {
            return Ok(check);
        };
        let second = again(&more)?;
        let mut check = check.with_second_gradient(&second);
        for confirmation in check.confirmations() {
            let made = self.reference(&second, tangent, confirmation, watch)?;
            check = check.with_confirmation(&second, made);
            if !matches!(check.comparison.verdict, Verdict::Wrong { .. }) {
                break;
            }
        }
        Ok(check)
    }

    /// A reference, and how it was made: with as many samples as fit the noise of both, unless so
    /// many are asked for.
    fn reference(
        &self,
        gradient: &GradientImage,
        tangent: &Tangent,
        made: Reference,
        watch: &dyn Watch,
    ) -> Result<(Reference, GradientImage), Error> {
        let differences = Differences::new(&self.prepared, tangent, made.step)?;
        let sampling = made.options().sampling();
        let (spp, image) = match made.fits_noise {
            true => differences.image_beside(gradient, &sampling, watch),
            false => (made.spp, differences.image(&sampling, watch)),
        };
        // A smaller step may be valid on both sides.
        let sides = differences.stencil();
        Ok((Reference { spp, sides, ..made }, image))
    }

    /// The gradient of `Σ adjoint · image` with respect to everything that is named, in one
    /// pass: arrays such as `"ball.positions"`, numbers such as `"ball.translate.x"`, and
    /// sums of numbers.
    ///
    /// `adjoint` is the derivative of a loss with respect to each pixel and channel. Its
    /// noise must be independent of the seed of this call. On a GPU, see [`Prepared::gradient`].
    ///
    /// ```
    /// use capwalk::{GradientOptions, Image, Rgb, Unwatched};
    /// # let scene = capwalk::Loader::new("leaf").size([8, 6]).load()?.scene;
    /// # let prepared = capwalk::Prepared::new(scene)?;
    /// // The loss is the sum of all pixels.
    /// let mut adjoint = Image::new(8, 6);
    /// adjoint.pixels.fill(Rgb::splat(1.0));
    /// let options = GradientOptions { spp: 4, ..GradientOptions::default() };
    /// let names = ["leaf.positions", "leaf.translate.x"];
    /// let gradients = prepared.backward(&adjoint, &names, &options, &Unwatched)?;
    /// assert_eq!(gradients["leaf.positions"].shape, [3, 3]);
    /// assert!(gradients["leaf.translate.x"].is_scalar());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn backward<N: AsRef<str>>(
        &self,
        adjoint: &Image,
        names: &[N],
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<Gradients, Error> {
        let work = self.backward_on_cpu(adjoint, names, options)?;
        let found = gpu_work::backward(&self.prepared, adjoint, work.wanted(), options, watch)?;
        let on_cpu = || work.unnamed(watch);
        let result = found.or_on_cpu(on_cpu, |result| &mut result.statistics)?;
        Ok(work.by_name(result))
    }

    /// [`Prepared::render`] in parts, which may be computed elsewhere: each process loads
    /// the same scene and asks for other parts. Merged in any order they give the bits of
    /// the whole on the CPU.
    ///
    /// ```
    /// use capwalk::{Part, Partial, RenderOptions, Unwatched};
    /// # let scene = capwalk::Loader::new("leaf").size([8, 6]).load()?.scene;
    /// # let prepared = capwalk::Prepared::new(scene)?;
    /// let options = RenderOptions::new(4, 1);
    /// let work = prepared.render_work(&options)?;
    /// let mut parts = Vec::new();
    /// for i in [2, 0, 1] {
    ///     let part = work.part(&Part::nth(work.grid(), i, 3)?, &Unwatched)?;
    ///     // Bytes travel between processes.
    ///     parts.push(Partial::from_bytes(&part.to_bytes()?)?);
    /// }
    /// let image = work.finish(Partial::merge(parts)?)?;
    /// assert_eq!(image.value, prepared.render(&options, &Unwatched)?.value);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn render_work(&self, options: &RenderOptions) -> Result<RenderWork<'_>, OptionError> {
        refuse_gpu(IN_PARTS, options.device)?;
        check_spp("spp", options.spp)?;
        Ok(RenderWork::new(&self.prepared, *options))
    }

    /// [`Prepared::gradient`] in parts, see [`Prepared::render_work`].
    pub fn gradient_work<'a, D: Direction + ?Sized>(
        &'a self,
        direction: &'a D,
        options: &GradientOptions,
    ) -> Result<GradientWork<'a>, Error> {
        refuse_gpu(IN_PARTS, options.device)?;
        self.gradient_on_cpu(direction, options)
    }

    /// The derivative of the image by the CPU, whatever device the options ask for.
    fn gradient_on_cpu<'a, D: Direction + ?Sized>(
        &'a self,
        direction: &'a D,
        options: &GradientOptions,
    ) -> Result<GradientWork<'a>, Error> {
        check_spp("spp", options.spp)?;
        let tangent = direction.tangent(self.scene(), self.registry())?;
        let on_cpu = GradientOptions {
            device: Device::Cpu,
            ..*options
        };
        let work = GradientWork::new(&self.prepared, tangent, on_cpu);
        // With a name of what moves, the method is kept.
        Ok(match direction.name() {
            Some(name) => {
                work.keeping(self.kept_choice(Differentiated::Along(name.into()), options))
            }
            None => work,
        })
    }

    /// The place of the method that these options leave to be chosen; one of its own if none.
    fn kept_choice(&self, what: Differentiated, options: &GradientOptions) -> KeptChoice {
        match options.method.is_open() {
            true => self.choices.of(self.scene(), what, options),
            false => KeptChoice::default(),
        }
    }

    /// [`Prepared::backward`] in parts, see [`Prepared::render_work`].
    ///
    /// ```
    /// use capwalk::{GradientOptions, Image, Part, Partial, Rgb, Unwatched};
    /// # let scene = capwalk::Loader::new("leaf").size([8, 6]).load()?.scene;
    /// # let prepared = capwalk::Prepared::new(scene)?;
    /// let mut adjoint = Image::new(8, 6);
    /// adjoint.pixels.fill(Rgb::splat(1.0));
    /// let (names, options) = (["leaf.positions"], GradientOptions::default());
    /// let work = prepared.backward_work(&adjoint, &names, &options)?;
    /// // Two workers, half of the batches each.
    /// let batches = work.grid().batches;
    /// let first = work.part(&Part::batches(work.grid(), 0..batches / 2)?, &Unwatched)?;
    /// let second = work.part(&Part::batches(work.grid(), batches / 2..batches)?, &Unwatched)?;
    /// let gradients = work.finish(Partial::merge([second, first])?)?;
    /// let whole = prepared.backward(&adjoint, &names, &options, &Unwatched)?;
    /// assert_eq!(gradients["leaf.positions"], whole["leaf.positions"]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn backward_work<'a, N: AsRef<str>>(
        &'a self,
        adjoint: &'a Image,
        names: &[N],
        options: &GradientOptions,
    ) -> Result<GradientsWork<'a>, Error> {
        refuse_gpu(IN_PARTS, options.device)?;
        self.backward_on_cpu(adjoint, names, options)
    }

    /// The gradient of a loss by the CPU, whatever device the options ask for.
    fn backward_on_cpu<'a, N: AsRef<str>>(
        &'a self,
        adjoint: &'a Image,
        names: &[N],
        options: &GradientOptions,
    ) -> Result<GradientsWork<'a>, Error> {
        check_spp("spp", options.spp)?;
        if options.adaptive {
            return Err(OptionError::AdaptiveBackward.into());
        }
        let kept = |wanted| self.kept_choice(Differentiated::Loss(wanted), options);
        GradientsWork::new(
            &self.prepared,
            self.registry(),
            adjoint,
            names,
            GradientOptions {
                device: Device::Cpu,
                ..*options
            },
            kept,
        )
    }

    /// The method that [`Prepared::backward`] uses on the CPU with these options, see
    /// [`Prepared::choose`]. It does not depend on the adjoint, and is kept by what the names
    /// change.
    pub fn choose_backward<N: AsRef<str>>(
        &self,
        adjoint: &Image,
        names: &[N],
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<Chosen, Error> {
        refuse_gpu("the choice of a method", options.device)?;
        self.backward_on_cpu(adjoint, names, options)?.chosen(watch)
    }

    /// Why derivatives with respect to parameters that move edges are refused in this
    /// scene; `None` if they are not.
    pub fn refusal(&self) -> Option<Refusal> {
        capwalk_diff::refusal(&self.prepared)
    }

    /// The names of all arrays that [`Prepared::backward`] takes in this scene, and those
    /// that would be refused.
    pub fn gradient_names(&self) -> GradientNames {
        backward::names(&self.prepared, self.registry())
    }

    /// Renders an image and compares it with a target: the loss, its standard error, and
    /// its derivative with respect to each pixel, to be handed to [`Prepared::backward`].
    ///
    /// `options` are those of the gradient that follows: the image is rendered with
    /// [an independent seed](RenderOptions::with_independent_seed).
    pub fn loss(
        &self,
        loss: &Loss,
        target: &Image,
        mask: Option<&Image>,
        options: &RenderOptions,
        watch: &dyn Watch,
    ) -> Result<ImageLoss, Error> {
        check_spp("spp", options.spp)?;
        let render = |options: &RenderOptions| self.render(options, watch);
        loss::measure(self.scene(), loss, target, mask, options, render)
    }

    /// What an array of the scene is now.
    pub fn values(&self, name: &str) -> Result<Values, Error> {
        let array = backward::array(self.registry(), self.scene(), name)?;
        Ok(Values {
            numbers: array.get(self.scene()),
            shape: array.shape,
        })
    }

    /// The motion in which the numbers of an array change with these velocities, row by row.
    /// Refuses another count, numbers that are not finite, and velocities that part vertices
    /// at the same place.
    ///
    /// ```
    /// # let scene = capwalk::Loader::new("leaf").size([8, 6]).load()?.scene;
    /// # let prepared = capwalk::Prepared::new(scene)?;
    /// let upwards = [0.0, 1.0, 0.0].repeat(3);
    /// let tangent = prepared.tangent("leaf.positions", &upwards)?;
    /// let options = capwalk::GradientOptions::default();
    /// let result = prepared.gradient(&tangent, &options, &capwalk::Unwatched)?;
    /// let same = prepared.gradient("leaf.translate.y", &options, &capwalk::Unwatched)?;
    /// assert_eq!(result.gradient.mean, same.gradient.mean);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn tangent(&self, name: &str, velocities: &[f64]) -> Result<Tangent, Error> {
        let array = backward::array(self.registry(), self.scene(), name)?;
        Ok(array.given_tangent(self.scene(), velocities)?)
    }

    /// Changes the numbers of an array, such as `"ball.positions"`. Moved vertices refit
    /// the trees, other colours touch none. Nothing is changed if the scene could not be
    /// rendered with them. Later answers are those of [`Prepared::new`] for the changed scene, to
    /// the bit, by the methods that were chosen before, see [`Prepared::choose`].
    ///
    /// ```
    /// # let scene = capwalk::Loader::new("leaf").size([8, 6]).load()?.scene;
    /// # let mut prepared = capwalk::Prepared::new(scene)?;
    /// let name = "floor.bsdf.reflectance.value";
    /// prepared.update(name, &[0.1, 0.2, 0.3])?;
    /// assert_eq!(prepared.values(name)?.numbers, [0.1, 0.2, 0.3]);
    /// assert!(prepared.update(name, &[-1.0; 3]).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn update(&mut self, name: &str, numbers: &[f64]) -> Result<(), Error> {
        self.update_all(&[(name, numbers)])
    }

    /// [`Prepared::update`] of several arrays, all of them or none.
    pub fn update_all(&mut self, changes: &[(&str, &[f64])]) -> Result<(), Error> {
        let mut scene = Scene::clone(self.scene());
        for (name, numbers) in changes {
            backward::array(self.registry(), self.scene(), name)?.set(&mut scene, numbers)?;
        }
        self.renumber(scene)
    }

    /// Goes over to a scene with the same names and other numbers; its methods stay chosen.
    pub(crate) fn renumber(&mut self, scene: Scene) -> Result<(), Error> {
        let checked = scene.check_after(Some(self.scene()));
        checked.map_err(Error::InvalidUpdate)?;
        self.prepared.update(scene);
        Ok(())
    }

    /// Goes over to another scene, whatever differs in it, and refits what it can: the
    /// trees if shapes differ only in where their vertices are. Later answers are those of
    /// [`Prepared::new`] for it, to the bit. Nothing is changed if it cannot be rendered.
    ///
    /// ```
    /// # let scene = capwalk::Loader::new("leaf").size([8, 6]).load()?.scene;
    /// # let mut prepared = capwalk::Prepared::new(scene)?;
    /// let mut scene = capwalk::Scene::clone(prepared.scene());
    /// scene.film.size = [16, 12];
    /// scene.film.crop_size = [16, 12];
    /// prepared.update_scene(scene)?;
    /// assert_eq!(prepared.scene().film.crop_size, [16, 12]);
    ///
    /// prepared.update_scene(capwalk::load("ball")?.scene)?;
    /// assert!(prepared.values("ball.positions").is_ok());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn update_scene(&mut self, scene: impl Into<Arc<Scene>>) -> Result<(), Error> {
        let scene = scene.into();
        let checked = scene.check_after(Some(self.scene()));
        checked.map_err(Error::InvalidUpdate)?;
        self.prepared.update(scene);
        self.registry = OnceLock::new();
        self.choices = Choices::default();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU64, Ordering};

    use super::*;
    use capwalk_diff::Unwatched;
    use capwalk_scene::builtin;

    fn leaf() -> Scene {
        let mut scene = builtin::scene("leaf").expect("built in");
        scene.film.size = [8, 6];
        scene.film.crop_size = [8, 6];
        scene
    }

    /// Nothing is black or NaN because nothing was sampled.
    #[test]
    fn no_samples_and_no_step_are_refused() {
        let prepared = Prepared::new(leaf()).expect("it can be rendered");
        let none = RenderOptions::new(0, 0);
        let image = Image::new(8, 6);
        let (name, names) = ("leaf.translate.x", ["leaf.translate.x"]);
        let loss = Loss {
            distance: crate::Distance::L2,
            levels: 1,
        };
        let differences = |spp, step| DifferenceOptions {
            spp,
            adaptive: false,
            seed: 0,
            step: Some(step),
        };
        let difference = |spp, step| {
            let options = differences(spp, step);
            prepared.finite_difference(name, &options, &Unwatched).err()
        };
        let check = |gradient: RenderOptions, spp, step| {
            let options = CheckOptions {
                gradient: gradient.into(),
                reference_spp: Some(spp),
                step: Some(step),
            };
            prepared.check(name, &options, &Unwatched).err()
        };
        let some = RenderOptions::new(2, 0);
        let errors = [
            prepared.render(&none, &Unwatched).err(),
            prepared.render_work(&none).err().map(Error::from),
            prepared.gradient(name, &none.into(), &Unwatched).err(),
            prepared.gradient_work(name, &none.into()).err(),
            prepared
                .backward(&image, &names, &none.into(), &Unwatched)
                .err(),
            prepared.loss(&loss, &image, None, &none, &Unwatched).err(),
            difference(0, 0.1),
            difference(2, 0.0),
            difference(2, f64::NAN),
            difference(2, -1.0),
            check(none, 2, 0.1),
            check(some, 0, 0.1),
            check(some, 2, 0.0),
        ];
        for (number, error) in errors.iter().enumerate() {
            assert!(
                matches!(error, Some(Error::Option(_))),
                "{number}: {error:?}"
            );
        }
        assert!(difference(2, 0.1).is_none() && check(some, 2, 0.1).is_none());
    }

    /// Counts how often it is asked: by each sample of a pilot.
    #[derive(Default)]
    struct Counts(AtomicU64);

    impl Watch for Counts {
        fn progress(&self, _done: u64, _total: u64) {}
        fn should_stop(&self) -> bool {
            self.0.fetch_add(1, Ordering::Relaxed);
            false
        }
    }

    /// Pilots run once for a name and for what names change, until the scene is another one. What
    /// was asked before decides nothing but the method, and that only after changes.
    #[test]
    fn choices_are_kept_until_the_scene_is_another() {
        let sampled = |seed| GradientOptions::new(RenderOptions::new(512, seed));
        let pilots = |prepared: &Prepared, seed| {
            let (name, adjoint) = ("leaf.translate.x", Image::new(8, 6));
            let counts = [Counts::default(), Counts::default()];
            let forward = prepared.choose(name, &sampled(seed), &counts[0]);
            let reverse = prepared.choose_backward(&adjoint, &[name], &sampled(seed), &counts[1]);
            let counts = counts.map(|count| count.0.into_inner() > 100);
            let options = [forward, reverse].map(|chosen| chosen.expect("covered").options);
            (
                counts,
                options.map(|options| (options.method, options.walk)),
            )
        };
        let mut prepared = Prepared::new(leaf()).expect("it can be rendered");
        let (asked, first) = pilots(&prepared, 1);
        assert_eq!(asked, [true; 2]);
        assert_eq!(pilots(&prepared, 2), ([false; 2], first));
        // The same call gives the same bits, whatever was asked before.
        let name = "leaf.translate.x";
        let gradient = |prepared: &Prepared, options| {
            let result = prepared.gradient(name, &options, &Unwatched);
            result.expect("covered").gradient
        };
        let anew = Prepared::new(leaf()).expect("it can be rendered");
        assert!(gradient(&prepared, sampled(2)) == gradient(&anew, sampled(2)));

        let positions = prepared.values("leaf.positions").expect("an array").numbers;
        let moved: Vec<f64> = positions.iter().map(|x| x + 0.1).collect();
        let update = prepared.update("leaf.positions", &moved);
        update.expect("it can be rendered");
        assert_eq!(pilots(&prepared, 3), ([false; 2], first));
        // By the method that is kept, those of a new one.
        let chosen = prepared.choose(name, &sampled(3), &Unwatched);
        let chosen = chosen.expect("covered").options;
        let anew = Prepared::new(Scene::clone(prepared.scene())).expect("it can be rendered");
        assert!(gradient(&prepared, sampled(3)) == gradient(&anew, chosen));

        let scene = Scene::clone(prepared.scene());
        prepared.update_scene(scene).expect("it can be rendered");
        assert_eq!(pilots(&prepared, 3).0, [true; 2]);
    }

    /// Whatever differs, also where the meshes are the same.
    #[test]
    fn another_scene_answers_like_a_new_one() {
        let answers = |prepared: &Prepared| {
            let options = GradientOptions::new(RenderOptions::new(4, 3));
            let name = "leaf.translate.x";
            let result = prepared.gradient(name, &options, &Unwatched);
            result.expect("covered").gradient.mean
        };
        let moved = |name: &str| {
            let scene = leaf();
            let tangent = Registry::new(&scene).tangent(&scene, name).expect("a name");
            scene.moved(&tangent, 0.2)
        };
        let with_uvs = || {
            let mut scene = leaf();
            let shape = Arc::make_mut(&mut scene.shapes[0]);
            shape.bsdf = capwalk_scene::BsdfId(0);
            shape.uvs = Some(vec![[[0.0; 2]; 3]; shape.mesh.faces.len()]);
            scene
        };
        let mut prepared = Prepared::new(leaf()).expect("it can be rendered");
        answers(&prepared);
        let smaller = |mut scene: Scene| {
            scene.film.size = [5, 4];
            scene.film.crop_size = [5, 4];
            scene
        };
        let mut turned = leaf();
        turned.shapes.reverse();
        for emitter in &mut turned.emitters {
            let last = turned.shapes.len() as u32 - 1;
            if let capwalk_scene::Emitter::Area { shape, .. } = emitter {
                shape.0 = last - shape.0;
            }
        }
        let scenes = [
            moved("leaf.translate.y"),
            with_uvs(),
            smaller(leaf()),
            turned,
            moved("sensor.translate.x"),
        ];
        for (number, scene) in scenes.into_iter().enumerate() {
            let anew = Prepared::new(scene.clone()).expect("it can be rendered");
            prepared.update_scene(scene).expect("it can be rendered");
            assert!(answers(&prepared) == answers(&anew), "scene {number}");
        }
        let mut broken = leaf();
        Arc::make_mut(&mut broken.shapes[0]).mesh.positions[0].x = f64::NAN;
        assert!(prepared.update_scene(broken).is_err());
    }

    /// Numbers that were right for what they were may be wrong for what they become: nothing of a
    /// scene is taken for known because the scene before had it.
    #[test]
    fn changes_are_checked_as_scenes_are() {
        let mut prepared = Prepared::new(leaf()).expect("it can be rendered");
        let scene = Scene::clone(prepared.scene());
        let radiance = scene.emitters[0].radiance();
        let covered = |opacity| {
            let mut covered = scene.clone();
            let nested = capwalk_scene::BsdfId(covered.materials.len() as u32);
            let mut material = covered.materials[0].clone();
            material.id = "covered".into();
            covered.materials.push(material);
            covered.materials[0].bsdf = capwalk_scene::Bsdf::Mask { opacity, nested };
            covered
        };
        let changed = |change: &dyn Fn(&mut Scene)| {
            let mut changed = scene.clone();
            change(&mut changed);
            changed
        };
        let scenes = [
            covered(radiance),
            changed(&|scene| Arc::make_mut(&mut scene.textures[0]).data[0] = f64::NAN),
            changed(&|scene| {
                Arc::make_mut(&mut scene.textures[radiance.0 as usize]).data[0] = -1.0;
            }),
            changed(&|scene| scene.shape_mut(capwalk_scene::ShapeId(1)).mesh.faces[0] = [900; 3]),
            changed(&|scene| {
                let first = scene.shapes[0].clone();
                scene.shapes.push(first);
            }),
            changed(&|scene| scene.film.size = [0, 6]),
        ];
        for (number, scene) in scenes.into_iter().enumerate() {
            let expected = scene.check().expect_err("it is wrong").to_string();
            let found = scene.check_after(Some(prepared.scene()));
            let found = found.expect_err("it is wrong").to_string();
            assert_eq!(found, expected, "scene {number}");
            assert!(prepared.update_scene(scene).is_err());
        }
    }
}
