//! Scenes: from files and texts, and their numbers.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Arc, RwLock, RwLockReadGuard, RwLockWriteGuard};

use capwalk::scene_io::load_scene_str;
use capwalk::{Loaded, Loader, Prepared};
use numpy::{PyArrayDyn, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::{arrays, errors};

/// A scene that is ready to be rendered and differentiated.
#[pyclass(frozen, module = "capwalk")]
pub struct Scene {
    prepared: RwLock<Prepared>,
    name: String,
    warnings: Vec<String>,
}

impl Scene {
    /// Trees are built without the interpreter's lock, as all that waits for workers: these
    /// may be waiting for it, to tell a progress.
    fn new(
        py: Python<'_>,
        name: String,
        scene: impl Into<Arc<capwalk::Scene>> + Send,
        warnings: Vec<String>,
    ) -> PyResult<Self> {
        let prepared = py.detach(|| Prepared::new(scene.into()));
        let prepared = prepared.map_err(|error| errors::exception(py, error))?;
        Ok(Self {
            prepared: RwLock::new(prepared),
            name,
            warnings,
        })
    }

    fn of(py: Python<'_>, name: String, loaded: Loaded) -> PyResult<Self> {
        let warnings = loaded.warnings.iter().map(ToString::to_string).collect();
        Self::new(py, name, loaded.scene, warnings)
    }

    /// The scene, for work beside other work.
    pub fn read(&self, py: Python<'_>) -> PyResult<RwLockReadGuard<'_, Prepared>> {
        let changing = "the scene is being changed in another thread; wait for that, or use a copy \
                        of the scene in each thread";
        let read = self.prepared.try_read();
        read.map_err(|_| errors::busy(py, changing))
    }

    /// The scene, to be changed.
    fn write(&self, py: Python<'_>) -> PyResult<RwLockWriteGuard<'_, Prepared>> {
        let rendering = "the scene is being rendered in another thread; wait for that, or change a \
                         copy of the scene";
        let write = self.prepared.try_write();
        write.map_err(|_| errors::busy(py, rendering))
    }
}

/// An array of a scene: name, shape, unit, description, name of which it is an alias, and
/// whether edges move with it.
type Listed = (String, Vec<usize>, String, String, Option<String>, bool);

#[pymethods]
impl Scene {
    /// What the scene was loaded from.
    #[getter]
    fn name(&self) -> &str {
        &self.name
    }

    /// What its file says in vain.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.warnings.clone()
    }

    /// Width and height of its image, pixels.
    #[getter]
    fn size(&self, py: Python<'_>) -> PyResult<[u32; 2]> {
        Ok(self.read(py)?.scene().film.crop_size)
    }

    /// Samples per pixel and seed, as its file says.
    #[getter]
    fn sampling(&self, py: Python<'_>) -> PyResult<(u32, u64)> {
        let prepared = self.read(py)?;
        let settings = &prepared.scene().settings;
        Ok((settings.spp, settings.seed))
    }

    /// All arrays of the scene.
    fn arrays(&self, py: Python<'_>) -> PyResult<Vec<Listed>> {
        let prepared = self.read(py)?;
        let arrays = prepared.registry().arrays().iter().cloned();
        let listed = arrays.map(|array| {
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
    fn values<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let values = self.read(py)?.values(name);
        let values = values.map_err(|error| errors::exception(py, error))?;
        arrays::from_numbers(py, &values.shape, values.numbers)
    }

    /// Changes arrays: all of them, or none.
    fn update(
        &self,
        py: Python<'_>,
        changes: BTreeMap<String, PyReadonlyArrayDyn<'_, f64>>,
    ) -> PyResult<()> {
        let mut guard = self.write(py)?;
        let prepared: &mut Prepared = &mut guard;
        for (name, array) in &changes {
            let values = prepared.values(name);
            let expected = values.map_err(|error| errors::exception(py, error))?.shape;
            if array.shape() != expected {
                let [expected, found] = [&expected, array.shape()].map(arrays::shape_text);
                let text = format!("{name} has the shape {expected}; found {found}");
                return Err(errors::argument(py, text));
            }
        }
        let changes: Vec<(&str, Vec<f64>)> = changes
            .iter()
            .map(|(name, array)| (name.as_str(), arrays::to_numbers(array)))
            .collect();
        let changes: Vec<(&str, &[f64])> = changes
            .iter()
            .map(|(name, numbers)| (*name, numbers.as_slice()))
            .collect();
        let updated = py.detach(|| prepared.update_all(&changes));
        updated.map_err(|error| errors::exception(py, error))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let prepared = self.read(py)?;
        let scene = prepared.scene();
        let [width, height] = scene.film.crop_size;
        let (name, shapes) = (&self.name, scene.shapes.len());
        Ok(format!(
            "<capwalk.Scene {name}: {width} x {height} pixels, {shapes} shapes>"
        ))
    }

    /// Gives its image another size, pixels, without crop.
    fn resize(&self, py: Python<'_>, width: u32, height: u32) -> PyResult<()> {
        let mut guard = self.write(py)?;
        let prepared: &mut Prepared = &mut guard;
        let mut scene = capwalk::Scene::clone(prepared.scene());
        let film = &mut scene.film;
        film.size = [width, height];
        (film.crop_offset, film.crop_size) = ([0, 0], film.size);
        let updated = py.detach(|| prepared.update_scene(scene));
        updated.map_err(|error| errors::exception(py, error))
    }

    /// Another scene with the same numbers.
    fn copy(&self, py: Python<'_>) -> PyResult<Self> {
        let scene = self.read(py)?.scene().clone();
        Self::new(py, self.name.clone(), scene, self.warnings.clone())
    }
}

/// The scene in a file, or the built-in one of this name.
#[pyfunction]
pub fn load_file(
    py: Python<'_>,
    path: PathBuf,
    defines: BTreeMap<String, String>,
) -> PyResult<Scene> {
    let mut loader = Loader::new(&path);
    for (name, value) in defines {
        loader = loader.define(name, value);
    }
    let loaded = py.detach(|| loader.load());
    let loaded = loaded.map_err(|error| errors::exception(py, error))?;
    Scene::of(py, path.display().to_string(), loaded)
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
    let defines: Vec<(String, String)> = defines.into_iter().collect();
    let loaded = py.detach(|| load_scene_str(text, &folder, name, &defines));
    let loaded = loaded.map_err(|error| errors::exception(py, error))?;
    Scene::of(py, name.into(), loaded)
}
