//! Scenes: from files and texts, and their numbers.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{RwLock, RwLockReadGuard, RwLockWriteGuard, TryLockError};

use capwalk::scene_io::{LoadOptions, load_scene_lines, load_scene_str_with};
use capwalk::{FilesRead, Loaded, Loader, ViewId, Views};
use numpy::{
    IntoPyArray, PyArray2, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods,
};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyType};

use crate::watched::{detached, interruptible};
use crate::{aov, arrays, errors};

/// A scene that is ready to be rendered and differentiated, from `load_file` and its like. It can
/// be rendered by several threads at once, pickled, and copied.
#[pyclass(frozen, weakref, module = "capwalk._capwalk")]
pub struct Scene {
    state: RwLock<State>,
    name: String,
    source: Source,
}

/// What is known of where a scene came from.
#[derive(Clone, Default)]
struct Source {
    /// Warnings about its file, except those about light only.
    warnings: Vec<String>,
    /// What concerns light only.
    light_warnings: Vec<String>,
    files: FilesRead,
}

/// What of a scene changes.
struct State {
    views: Views,
    /// How often it was changed.
    revision: u64,
}

impl Scene {
    fn new(
        py: Python<'_>,
        name: String,
        source: Source,
        views: impl FnOnce() -> Result<Views, capwalk::Error> + Send,
    ) -> PyResult<Self> {
        let views = detached(py, views)?;
        let views = views.map_err(|error| errors::exception(py, error))?;
        Ok(Self {
            state: RwLock::new(State { views, revision: 0 }),
            name,
            source,
        })
    }

    fn of(
        py: Python<'_>,
        name: String,
        load: impl FnOnce() -> Result<Loaded, capwalk::Error> + Send + 'static,
    ) -> PyResult<Self> {
        let loaded = interruptible(py, load)?;
        let loaded = loaded.map_err(|error| errors::exception(py, error))?;
        let about = |is_about_light: bool| {
            let warnings = loaded.warnings.iter();
            let found = warnings.filter(|warning| warning.is_about_light == is_about_light);
            found.map(ToString::to_string).collect()
        };
        let source = Source {
            warnings: about(false),
            light_warnings: about(true),
            files: loaded.files,
        };
        Self::new(py, name, source, || {
            Views::new(loaded.scene, loaded.sensors)
        })
    }

    /// The scene, for work beside other work.
    pub fn read(&self, py: Python<'_>) -> PyResult<impl std::ops::Deref<Target = Views>> {
        let changing = "the scene is being changed by another thread, or was when this process was \
                        forked; use a copy of the scene in each of them";
        Ok(Reading(unlocked(py, self.state.try_read(), changing)?))
    }

    /// Changes the scene.
    fn change(
        &self,
        py: Python<'_>,
        change: impl FnOnce(&mut Views) -> Result<(), capwalk::Error> + Send,
    ) -> PyResult<()> {
        let rendering = "the scene is being rendered: by another thread, by what calls this to tell \
                         its progress, or when this process was forked; change a copy of it";
        let mut guard: RwLockWriteGuard<State> = unlocked(py, self.state.try_write(), rendering)?;
        let state: &mut State = &mut guard;
        let changed = detached(py, || change(&mut state.views))?;
        changed.map_err(|error| errors::exception(py, error))?;
        state.revision += 1;
        Ok(())
    }
}

/// A lock on the scene through which it is read.
struct Reading<'a>(RwLockReadGuard<'a, State>);

impl std::ops::Deref for Reading<'_> {
    type Target = Views;

    fn deref(&self) -> &Views {
        &self.0.views
    }
}

/// The scene if nobody keeps it from being taken; `busy` says who may.
fn unlocked<G>(py: Python<'_>, lock: Result<G, TryLockError<G>>, busy: &str) -> PyResult<G> {
    lock.map_err(|error| match error {
        TryLockError::WouldBlock => errors::busy(py, busy),
        TryLockError::Poisoned(_) => {
            let broken = "an internal error interrupted a change of this scene; load it again";
            errors::internal(py, broken)
        }
    })
}

/// An array of a scene: name, shape, unit, description, name of which it is an alias, and
/// whether edges move with it.
type Listed = (String, Vec<usize>, String, String, Option<String>, bool);

/// A sensor of a scene: name, width and height of its image, samples per pixel, and seed.
type Sensor = (String, (u32, u32), u32, u64);

/// What makes a scene again, and from what.
type Pickled<'py> = (Bound<'py, PyAny>, (Bound<'py, PyBytes>, String));

/// New numbers by the names of arrays.
type Changes<'py> = BTreeMap<String, PyReadonlyArrayDyn<'py, f64>>;

/// A change without Python objects: name, shape and numbers.
type Owned = (String, Vec<usize>, Vec<f64>);

fn owned(changes: &Changes<'_>) -> Vec<Owned> {
    let changes = changes.iter().map(|(name, array)| {
        let numbers = arrays::to_numbers(array);
        (name.clone(), array.shape().to_vec(), numbers)
    });
    changes.collect()
}

/// Changes whose shapes are those of the scene.
fn checked<'a>(
    views: &Views,
    changes: &'a [Owned],
) -> Result<Vec<(&'a str, &'a [f64])>, capwalk::Error> {
    let changes = changes.iter().map(|(name, shape, numbers)| {
        arrays::check_shape(name, &views.values(name)?.shape, shape)?;
        Ok((name.as_str(), numbers.as_slice()))
    });
    changes.collect()
}

/// Names of arrays: those with gradients, those without, and why.
type Differentiable = (Vec<String>, Vec<String>, Option<String>);

#[pymethods]
impl Scene {
    /// What the scene was loaded from.
    #[getter]
    fn name(&self) -> &str {
        &self.name
    }

    /// Warnings about its file.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.source.warnings.clone()
    }

    /// Warnings about its file if light is rendered.
    #[getter(_light_warnings)]
    fn light_warnings(&self) -> Vec<String> {
        self.source.light_warnings.clone()
    }

    /// The files that it was read from.
    #[getter(_files)]
    fn files(&self) -> Vec<PathBuf> {
        self.source.files.paths().map(PathBuf::from).collect()
    }

    /// Width and height of the image of its first sensor, pixels.
    #[getter]
    fn size(&self, py: Python<'_>) -> PyResult<(u32, u32)> {
        Ok(self.read(py)?.scene().film.crop_size.into())
    }

    /// Its sensors.
    #[pyo3(name = "_sensors")]
    fn sensors(&self, py: Python<'_>) -> PyResult<Vec<Sensor>> {
        let views = self.read(py)?;
        let sensors = views.sensors().iter();
        Ok(sensors
            .map(|view| {
                let name = view.sensor.id.clone();
                (name, view.film.crop_size.into(), view.spp, view.seed)
            })
            .collect())
    }

    /// How often it was changed.
    #[getter]
    fn revision(&self, py: Python<'_>) -> PyResult<u64> {
        let busy = "the scene is being changed by another thread; wait for that";
        Ok(unlocked(py, self.state.try_read(), busy)?.revision)
    }

    /// All arrays of the scene.
    #[pyo3(name = "_arrays")]
    fn arrays(&self, py: Python<'_>) -> PyResult<Vec<Listed>> {
        let views = self.read(py)?;
        let views: &Views = &views;
        let arrays = detached(py, || views.arrays())?;
        let listed = arrays.into_iter().map(|array| {
            (
                array.name,
                array.shape,
                array.unit.to_owned(),
                array.description,
                array.alias_of,
                array.moves_discontinuities,
            )
        });
        Ok(listed.collect())
    }

    /// The numbers of an array.
    #[pyo3(name = "_values")]
    fn values<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let views = self.read(py)?;
        let views: &Views = &views;
        let values =
            detached(py, || views.values(name))?.map_err(|error| errors::exception(py, error))?;
        arrays::from_numbers(py, &values.shape, values.numbers)
    }

    /// The shape of a gradient of what a sensor sees, with respect to an array or a number; an
    /// error if the sensor knows none of the name.
    #[pyo3(name = "_gradient_shape")]
    fn gradient_shape(&self, py: Python<'_>, name: &str, sensor: usize) -> PyResult<Vec<usize>> {
        let views = self.read(py)?;
        let views: &Views = &views;
        let shape = detached(py, || views.gradient_shape(name, sensor))?;
        shape.map_err(|error| errors::exception(py, error))
    }

    /// Changes arrays: all of them, or none.
    #[pyo3(name = "_update")]
    fn update(&self, py: Python<'_>, changes: Changes<'_>) -> PyResult<()> {
        let changes = owned(&changes);
        self.change(py, |views| views.update(&checked(views, &changes)?))
    }

    /// Goes over to what a copy of another scene would be after these changes.
    #[pyo3(name = "_restore")]
    fn restore(&self, py: Python<'_>, other: &Self, changes: Changes<'_>) -> PyResult<()> {
        let changes = owned(&changes);
        let other = other.read(py)?;
        let other: &Views = &other;
        self.change(py, |views| views.restore(other, &checked(other, &changes)?))
    }

    /// Lets a sensor take over the trees of the one that has them, see [`Views::turn`].
    #[pyo3(name = "_turn")]
    fn turn(&self, py: Python<'_>, sensor: usize, aov: Option<&str>) -> PyResult<()> {
        let aov = aov.map(|name| aov::named(py, name)).transpose()?;
        self.change(py, |views| views.turn(ViewId { sensor, aov }))
    }

    /// Goes over to the scene that pickling made these bytes of.
    #[pyo3(name = "_replace")]
    fn replace(&self, py: Python<'_>, bytes: &[u8]) -> PyResult<()> {
        self.change(py, |views| views.replace_by_bytes(bytes))
    }

    /// The arrays that can be differentiated with respect to, those that are refused, and why.
    #[pyo3(name = "_gradient_names")]
    fn gradient_names(&self, py: Python<'_>, sensor: usize) -> PyResult<Differentiable> {
        let views = self.read(py)?;
        let views: &Views = &views;
        let view = ViewId { sensor, aov: None };
        let names = detached(py, || Ok(views.prepared(view)?.gradient_names()))?;
        let names = names.map_err(|error: capwalk::Error| errors::exception(py, error))?;
        let reason = names.refusal.map(|refusal| refusal.to_string());
        // `sensor` is the one that renders; of several each goes by its own name.
        let own = |name: String| match name.strip_prefix("sensor.") {
            Some(number) if views.sensors().len() > 1 => {
                format!("{}.{number}", views.sensors()[sensor].sensor.id)
            }
            _ => name,
        };
        let [allowed, refused] =
            [names.allowed, names.refused].map(|names| names.into_iter().map(own).collect());
        Ok((allowed, refused, reason))
    }

    /// The triangles of a shape, (F, 3): numbers of their vertices, counter-clockwise seen from
    /// outside.
    fn faces<'py>(&self, py: Python<'py>, shape: &str) -> PyResult<Bound<'py, PyArray2<u32>>> {
        let views = self.read(py)?;
        let shapes = &views.scene().shapes;
        let Some(found) = shapes.iter().find(|found| found.id == shape) else {
            let names: Vec<&str> = shapes.iter().map(|shape| shape.id.as_str()).collect();
            let text = format!(
                "there is no shape \"{shape}\"; there are {}",
                names.join(", ")
            );
            return Err(errors::argument(py, text));
        };
        let faces = &found.mesh.faces;
        let numbers: Vec<u32> = faces.iter().flatten().copied().collect();
        numbers.into_pyarray(py).reshape([faces.len(), 3])
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let views = self.read(py)?;
        let scene = views.scene();
        let [width, height] = scene.film.crop_size;
        let (name, shapes) = (&self.name, scene.shapes.len());
        Ok(format!(
            "<capwalk.Scene {name}: {width} x {height} pixels, {shapes} shapes>"
        ))
    }

    /// Gives the images of all sensors another size, pixels, without crop.
    fn resize(&self, py: Python<'_>, width: u32, height: u32) -> PyResult<()> {
        self.change(py, |views| views.resize([width, height]))
    }

    /// Another scene with the same numbers, which changes by itself.
    fn copy(&self, py: Python<'_>) -> PyResult<Self> {
        let (scene, sensors) = {
            let views = self.read(py)?;
            (views.scene().clone(), views.sensors().to_vec())
        };
        let (name, source) = (self.name.clone(), self.source.clone());
        Self::new(py, name, source, || Views::new(scene, sensors))
    }

    fn __copy__(&self, py: Python<'_>) -> PyResult<Self> {
        self.copy(py)
    }

    fn __deepcopy__(&self, py: Python<'_>, _memo: Bound<'_, PyAny>) -> PyResult<Self> {
        self.copy(py)
    }

    /// The scene as bytes, for another process.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Pickled<'py>> {
        let (py, scene) = (slf.py(), slf.get());
        let views = scene.read(py)?;
        let views: &Views = &views;
        let bytes = detached(py, || views.to_bytes())?;
        let bytes = bytes.map_err(|error| errors::exception(py, error))?;
        let made = PyType::new::<Self>(py).getattr("from_bytes")?;
        Ok((made, (PyBytes::new(py, &bytes), scene.name.clone())))
    }

    /// What pickling made of a scene.
    #[staticmethod]
    fn from_bytes(py: Python<'_>, bytes: &[u8], name: String) -> PyResult<Self> {
        Self::new(py, name, Source::default(), || Views::from_bytes(bytes))
    }
}

/// The scene in a file, or the built-in one of this name.
#[pyfunction]
pub fn load_file(
    py: Python<'_>,
    path: PathBuf,
    defines: BTreeMap<String, String>,
) -> PyResult<Scene> {
    // All sensors are used: no warning that only the first is.
    let mut loader = Loader::new(&path).sensor(0);
    for (name, value) in defines {
        loader = loader.define(name, value);
    }
    Scene::of(py, path.display().to_string(), move || loader.load())
}

/// The scene in a text. Files in it are relative to `folder`.
#[pyfunction]
pub fn load_string(
    py: Python<'_>,
    text: &str,
    folder: PathBuf,
    defines: BTreeMap<String, String>,
) -> PyResult<Scene> {
    let name = "string";
    let (options, text) = (all_sensors(defines), text.to_owned());
    Scene::of(py, name.into(), move || {
        Ok(load_scene_str_with(&text, &folder, name, &options)?)
    })
}

/// What scenes call materials, those that are refused by name among them.
#[pyfunction]
pub fn bsdf_plugins() -> Vec<&'static str> {
    capwalk::scene_io::bsdf_plugins().collect()
}

/// The scene in a text that was made from something else, which messages call
/// `lines[i]` where they are about line `i` of it.
#[pyfunction]
pub fn load_lines(
    py: Python<'_>,
    text: &str,
    folder: PathBuf,
    lines: Vec<String>,
) -> PyResult<Scene> {
    let name = lines.first().cloned().unwrap_or_default();
    let (options, text) = (all_sensors(BTreeMap::new()), text.to_owned());
    Scene::of(py, name, move || {
        Ok(load_scene_lines(&text, &folder, lines, &options)?)
    })
}

/// No warning says that only the first sensor is used: all of them are.
fn all_sensors(defines: BTreeMap<String, String>) -> LoadOptions {
    LoadOptions {
        defines: defines.into_iter().collect(),
        sensor: Some(0.into()),
    }
}
