//! From a job to a problem: scenes are loaded, targets read, or left to be rendered.

use capwalk_diff::{Purpose, RenderOptions, Seed, Watch};
use capwalk_inverse::variable::{VariableSpec, Variables, variable};
use capwalk_inverse::{Problem, Stop, TargetView};
use capwalk_scene::params::Registry;
use capwalk_scene::{Film, Image, Scene, Sensor, builtin};
use capwalk_scene_io::LoadError;
use capwalk_scene_io::toml::Place;

use super::job::{Define, Job, Located, MethodKeys, TargetKeys, ViewKeys, least_of_gradients};
use super::posed::{LoadedProblem, Pending, PosedProblem};
use crate::error::Error;
use crate::images::{read_layer, read_mask};
use crate::load::Loader;
use capwalk_scene_io::{FilesRead, Loaded, Warning};

/// What is found on the way to a problem.
#[derive(Default)]
struct Found {
    /// Warnings about scene files, each once.
    warnings: Vec<Warning>,
    files: FilesRead,
}

impl Job {
    /// The problem that the job poses: loads its scenes, then reads or renders the targets.
    /// Mistakes are found before the first target is rendered, and have a place in the job.
    ///
    /// ```
    /// use capwalk::Unwatched;
    /// use capwalk::optimize::{Job, PreparedViews, State};
    ///
    /// let job = Job::parse("example", r#"
    ///     scene = "leaf"
    ///     size = [8, 6]
    ///     iterations = 1
    ///     spp = 4
    ///     target = { set = { "leaf.translate.x" = 0.2 }, spp = 16 }
    ///     parameter = [{ name = "leaf.translate.x" }]
    ///     optimizer = { lr = 0.1 }
    /// "#)?;
    /// let problem = job.problem(&Unwatched)?.problem;
    /// let mut views = PreparedViews::new();
    /// let first = problem.iterate(&State::new(&problem), &mut views, &Unwatched)?;
    /// let second = problem.iterate(&first.next?, &mut views, &Unwatched)?;
    /// assert!(second.row.values[0] > first.row.values[0]); // on its way to 0.2
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn problem(&self, watch: &dyn Watch) -> Result<LoadedProblem, Error> {
        self.posed()?.rendered(watch)
    }

    /// The problem before its targets are rendered.
    pub(super) fn posed(&self) -> Result<PosedProblem, Error> {
        self.refuse_unused_defines()?;
        let mut found = Found::default();
        if let Some(path) = &self.path {
            found.files.add(path);
        }
        let keys = &self.keys;
        let scene = self.load(&keys.scene, &[], None, &mut found)?;
        let variables = self.variables(&scene, &keys.parameters)?;
        // The count of the scene is no wish for larger gradients than a job allows.
        let most = keys.samples.and_then(|keys| keys.most).unwrap_or(u32::MAX);
        let spp = keys.spp.unwrap_or(scene.settings.spp.max(2));
        let least = least_of_gradients(keys.samples.is_some());
        let spp_grad = keys.spp_grad.unwrap_or(spp.max(least).min(most));
        let (mut views, mut pending) = (Vec::new(), Vec::new());
        for (number, view) in keys.views.iter().enumerate() {
            let (view, target) = self.view(&scene, &variables, view, number, &mut found)?;
            views.push(view);
            pending.extend(target);
        }
        let MethodKeys { method, walk } = keys.method;
        let moves = variables.wanted(&scene).moves();
        let problem = Problem {
            by_noise: keys.samples.map(|keys| keys.rule(spp_grad, moves)),
            variables,
            views,
            loss: keys.loss,
            adam: keys.adam,
            lr: keys.lr,
            schedule: keys.schedule,
            guards: keys.guards,
            limits: keys.limits,
            seed: keys.seed,
            spp,
            spp_grad,
            method,
            walk,
            scene,
        };
        self.check_start(&problem)?;
        Ok(PosedProblem {
            problem,
            pending,
            warnings: found.warnings,
            files: found.files,
        })
    }

    /// Pixels of the image of each view, without reading targets or rendering them.
    pub fn sizes(&self) -> Result<Vec<[u32; 2]>, Error> {
        let mut found = Found::default();
        let scene = self.load(&self.keys.scene, &[], None, &mut found)?;
        let views = self.keys.views.iter().map(|keys| {
            let view = TargetView {
                sensor: self.sensor(&scene, keys, &mut found)?,
                target: Image::new(0, 0),
                mask: None,
                weight: keys.weight,
            };
            Ok(view.scene(&scene).film.crop_size)
        });
        views.collect()
    }

    /// A scene of the job, with these values of `$name` before those of the job, and the
    /// sensor that is asked for. New warnings and its files are added to `found`.
    fn load(
        &self,
        located: &Located,
        defines: &[Define],
        sensor: Option<(usize, Place)>,
        found: &mut Found,
    ) -> Result<Scene, LoadError> {
        let (document, name) = (&self.document, &located.text);
        let mut loader = match is_built_in(located) {
            false => {
                let path = document.path(name);
                let mut loader = Loader::new(path);
                if let Some((number, _)) = sensor {
                    loader = loader.sensor(number);
                }
                let own = |define: &&Define| defines.iter().any(|own| own.name == define.name);
                let of_job = self.keys.defines.iter().filter(|define| !own(define));
                of_job.chain(defines).fold(loader, |loader, define| {
                    loader.define(&define.name, &define.value)
                })
            }
            true => {
                if let Some(define) = defines.first() {
                    return Err(self.built_in(define.place, name, "no `$name`"));
                }
                if let Some((_, place)) = sensor.filter(|(number, _)| *number > 0) {
                    return Err(self.built_in(place, name, "one sensor, number 0"));
                }
                Loader::new(name)
            }
        };
        if let Some(size) = self.keys.size {
            loader = loader.size(size);
        }
        match loader.load() {
            Ok(Loaded {
                scene,
                warnings,
                files,
                ..
            }) => {
                found.files.extend(&files);
                // Views can name one file several times.
                for warning in warnings {
                    if !found.warnings.contains(&warning) {
                        found.warnings.push(warning);
                    }
                }
                Ok(scene)
            }
            Err(Error::Load(error)) => Err(error),
            Err(Error::UnknownScene { name }) => {
                let names: Vec<&str> = builtin::names().collect();
                let help = format!(
                    "expected a scene file, relative to the job, or a built-in scene: {}",
                    names.join(", ")
                );
                let message = format!("there is no file {name}");
                Err(document.error_with_help(located.place, message, help))
            }
            Err(Error::InvalidScene { error, .. }) => {
                let message = format!("it cannot be rendered: {error}");
                Err(document.error(located.place, message))
            }
            Err(other) => Err(document.error(located.place, other.to_string())),
        }
    }

    /// An error about something that a built-in scene does not have.
    fn built_in(&self, place: Place, scene: &str, has: &str) -> LoadError {
        let message = format!("the scene \"{scene}\" is built in and has {has}");
        let help = "leave it out, or export the scene as a file and name that";
        self.document.error_with_help(place, message, help)
    }

    /// An error if there are values of `$name`, but no scene file.
    fn refuse_unused_defines(&self) -> Result<(), LoadError> {
        let keys = &self.keys;
        let of_views = keys.views.iter().flat_map(|view| match &view.target {
            TargetKeys::Image { .. } => [view.scene.as_ref(), None],
            TargetKeys::Rendered { scene, .. } => [view.scene.as_ref(), scene.as_ref()],
        });
        let mut scenes = std::iter::once(&keys.scene).chain(of_views.flatten());
        match keys.defines.first() {
            Some(define) if scenes.all(is_built_in) => {
                Err(self.built_in(define.place, &keys.scene.text, "no `$name`"))
            }
            _ => Ok(()),
        }
    }

    fn variables(
        &self,
        scene: &Scene,
        specs: &[(VariableSpec, Place)],
    ) -> Result<Variables, LoadError> {
        let document = &self.document;
        let registry = Registry::new(scene);
        let mut made = Vec::new();
        for (spec, place) in specs {
            let made_of = variable(scene, &registry, spec);
            made.push(made_of.map_err(|error| document.error(*place, error.to_string()))?);
        }
        // Two of them get in each other's way: the last one is where it is seen.
        let root = document.root().place();
        let last = specs.last().map_or(root, |(_, place)| *place);
        Variables::new(scene, made).map_err(|error| document.error(last, error.to_string()))
    }

    /// A view without its target or with it, and the target if it is to be rendered.
    fn view(
        &self,
        scene: &Scene,
        variables: &Variables,
        keys: &ViewKeys,
        number: usize,
        found: &mut Found,
    ) -> Result<(TargetView, Option<Pending>), Error> {
        let sensor = self.sensor(scene, keys, found)?;
        if sensor.is_some()
            && let Some(place) = self.moved_sensor(scene, variables)
        {
            let message = "it moves the sensor of the scene, but a [[view]] has its own";
            let help = "leave out the views, or what moves the sensor";
            return Err(self.document.error_with_help(place, message, help).into());
        }
        let mut view = TargetView {
            sensor,
            target: Image::new(0, 0),
            mask: None,
            weight: keys.weight,
        };
        let size = view.scene(scene).film.crop_size;
        if let Some(mask) = &keys.mask {
            let path = self.document.path(&mask.text);
            found.files.add(&path);
            let read = read_mask(&path, size);
            view.mask = Some(read.map_err(|error| self.at(mask.place, &error))?);
        }
        let pending = match &keys.target {
            TargetKeys::Image { file, layer } => {
                let path = self.document.path(&file.text);
                found.files.add(&path);
                let layer = layer.as_deref().unwrap_or("value");
                let read = read_layer(&path, &[layer], size);
                view.target = read.map_err(|error| self.at(file.place, &error))?;
                None
            }
            TargetKeys::Rendered { spp, .. } => {
                let scene = self.target_scene(scene, &view, keys, found)?;
                if scene.film.crop_size != size {
                    let message = "the target has another size than the image";
                    return Err(self.document.error(keys.place, message).into());
                }
                let seed = Seed(self.keys.seed).of_iteration(0, number as u64, Purpose::Target);
                Some(Pending {
                    view: number,
                    scene,
                    options: RenderOptions::new(*spp, seed.0),
                })
            }
        };
        Ok((view, pending))
    }

    /// An error about a file at the place where the job names it, with its cause.
    fn at(&self, place: Place, error: &Error) -> LoadError {
        let cause = std::error::Error::source(error);
        let cause = cause.map(|cause| format!(": {cause}"));
        let message = format!("{error}{}", cause.unwrap_or_default());
        self.document.error(place, message)
    }

    /// The scene that a view's target is an image of: the job's or another one, with the
    /// numbers that are set, as the view sees it.
    fn target_scene(
        &self,
        scene: &Scene,
        view: &TargetView,
        keys: &ViewKeys,
        found: &mut Found,
    ) -> Result<Scene, LoadError> {
        let TargetKeys::Rendered {
            scene: other,
            defines,
            set,
            ..
        } = &keys.target
        else {
            return Ok(view.scene(scene));
        };
        let is_other = other.is_some() || !defines.is_empty();
        let located = other.as_ref().unwrap_or(&self.keys.scene);
        let other = is_other.then(|| self.load(located, defines, keys.sensor, found));
        let other = other.transpose()?;
        let set = self.changed(other.as_ref().unwrap_or(scene), set)?;
        // With another scene's own film, unless the view has one.
        Ok(match (&view.sensor, other.is_some()) {
            (None, true) => set,
            _ => view.scene(&set),
        })
    }

    /// The scene with numbers that are set.
    fn changed(&self, scene: &Scene, set: &[(VariableSpec, Place)]) -> Result<Scene, LoadError> {
        let variables = self.variables(scene, set)?;
        let changed = variables.apply(scene, &variables.values(&variables.initial()));
        changed.map_err(|error| {
            let root = self.document.root().place();
            let place = set.first().map_or(root, |(_, place)| *place);
            self.document.error(place, error.to_string())
        })
    }

    /// The sensor of a view and its film, if it is not the scene's.
    fn sensor(
        &self,
        scene: &Scene,
        keys: &ViewKeys,
        found: &mut Found,
    ) -> Result<Option<(Sensor, Film)>, LoadError> {
        let document = &self.document;
        let mut own = match (&keys.scene, keys.sensor) {
            (None, None | Some((0, _))) => scene.clone(),
            (located, sensor) => {
                let located = located.as_ref().unwrap_or(&self.keys.scene);
                self.load(located, &[], sensor, found)?
            }
        };
        let set = |own: &mut Scene, name: &str, numbers: &[f64], place: Place| {
            let name = format!("{}.{name}", own.sensor.id);
            let registry = Registry::new(own);
            let array = registry.array(&name).ok().flatten();
            let array =
                array.ok_or_else(|| document.error(place, "the sensor has no such number"))?;
            let changed = array.set(own, numbers);
            changed.map_err(|error| document.error(place, error.to_string()))?;
            let checked = own.check();
            checked.map_err(|error| document.error(place, error.to_string()))
        };
        if let Some((matrix, place)) = &keys.to_world {
            set(&mut own, "to_world", matrix, *place)?;
        }
        if let Some((degrees, place)) = keys.x_fov {
            set(&mut own, "x_fov", &[degrees], place)?;
        }
        let is_the_same = own.sensor == scene.sensor && own.film == scene.film;
        Ok((!is_the_same).then_some((own.sensor, own.film)))
    }

    /// Where the first parameter is that moves the sensor.
    fn moved_sensor(&self, scene: &Scene, variables: &Variables) -> Option<Place> {
        let registry = Registry::new(scene);
        let alone = |(spec, place): &(VariableSpec, Place)| {
            let variable = variable(scene, &registry, spec).ok()?;
            let variables = Variables::new(scene, vec![variable]).ok()?;
            variables.moves_sensor(scene).then_some(*place)
        };
        variables
            .moves_sensor(scene)
            .then(|| self.keys.parameters.iter().find_map(alone))?
    }

    /// An error at the first parameter if the scene before the first step is not usable.
    fn check_start(&self, problem: &Problem) -> Result<(), LoadError> {
        problem.check_start().map_err(|stop| {
            let place = self.keys.parameters[0].1;
            let message = match stop {
                Stop::Guard(violation) => format!("before the first step, {violation}"),
                stop => stop.to_string(),
            };
            let help = "change the start; [guards] says what is looked for";
            self.document.error_with_help(place, message, help)
        })
    }

    /// A refusal in a state, with the place of the parameter that it is about.
    pub(super) fn refused(
        &self,
        problem: &Problem,
        state: &capwalk_inverse::State,
        reason: &str,
    ) -> LoadError {
        let alone = problem.refused_variable(state);
        let (spec, place) = &self.keys.parameters[alone.unwrap_or(0)];
        let message = format!(
            "the derivative with respect to \"{}\" is refused",
            spec.name
        );
        self.document.error_with_help(*place, message, reason)
    }

    /// The specifications of its parameters.
    pub(super) fn specs(&self) -> Vec<VariableSpec> {
        let parameters = self.keys.parameters.iter();
        parameters.map(|(spec, _)| spec.clone()).collect()
    }
}

/// As for every scene, the names of built-in ones win.
fn is_built_in(located: &Located) -> bool {
    builtin::description(&located.text).is_some()
}
