//! A scene seen by each of its sensors.

use std::collections::HashSet;
use std::sync::{Arc, OnceLock};

use capwalk_diff::{Unwatched, Watch};
use capwalk_scene::params::{ArrayParameter, ParameterError, Registry};
use capwalk_scene::{Aov, Integrator, Scene, SceneError, pack, unpack};
use capwalk_scene_io::SensorSettings;

use crate::backward::array;
use crate::error::Error;
use crate::prepared::{Prepared, Values};

/// Names a view: one of the sensors, and what it shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ViewId {
    /// Which sensor, from 0.
    pub sensor: usize,
    /// What is shown of the surfaces instead of their light.
    pub aov: Option<Aov>,
}

impl ViewId {
    /// All views of a scene with so many sensors.
    fn all(sensors: usize) -> impl Iterator<Item = Self> {
        let of = |sensor| {
            let aovs = Aov::ALL.map(Some).into_iter();
            std::iter::once(None)
                .chain(aovs)
                .map(move |aov| Self { sensor, aov })
        };
        (0..sensors).flat_map(of)
    }

    /// Where it stands among all views.
    fn place(self) -> usize {
        let aov = Aov::ALL.iter().position(|&aov| Some(aov) == self.aov);
        self.sensor * (1 + Aov::ALL.len()) + aov.map_or(0, |i| 1 + i)
    }
}

/// A scene with all of its sensors. Each view is made ready when it is asked for first, and
/// follows every change of the scene from then on.
///
/// ```
/// use capwalk::{ViewId, RenderOptions, Unwatched, Views};
///
/// let loaded = capwalk::Loader::new("leaf").size([8, 6]).load()?;
/// let mut views = Views::new(loaded.scene, loaded.sensors)?;
/// let mask = ViewId { sensor: 0, aov: Some(capwalk::scene::Aov::Mask) };
/// let mask = views.prepared(mask)?;
/// let image = mask.render(&RenderOptions::new(4, 1), &Unwatched)?.value.mean;
/// assert!(image.pixels.iter().all(|pixel| pixel.g <= 1.0));
/// views.update(&[("floor.bsdf.reflectance.value", &[0.1, 0.2, 0.3])])?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Views {
    /// As the first sensor sees it.
    scene: Arc<Scene>,
    sensors: Vec<SensorSettings>,
    /// The names of its parameters as each sensor has them.
    registries: Vec<OnceLock<Registry>>,
    /// By [`ViewId::place`]; what was asked for so far.
    prepared: Vec<OnceLock<Prepared>>,
}

impl Views {
    /// A scene and its sensors, at least one; that of the scene itself does not count. An
    /// error if one of them cannot render it.
    pub fn new(scene: impl Into<Arc<Scene>>, sensors: Vec<SensorSettings>) -> Result<Self, Error> {
        let scene = scene.into();
        let first = sensors.first().ok_or(Error::NoSuchSensor {
            sensors: 0,
            number: 0,
        })?;
        let views = Self {
            scene: Arc::new(first.scene(&scene)),
            registries: sensors.iter().map(|_| OnceLock::new()).collect(),
            prepared: ViewId::all(sensors.len())
                .map(|_| OnceLock::new())
                .collect(),
            sensors,
        };
        check(&views.scene, &views.sensors, None)?;
        Ok(views)
    }

    /// The scene with its sensors as bytes, exact in every number, to be sent to another
    /// process of the same version.
    pub fn to_bytes(&self) -> Result<Vec<u8>, Error> {
        Ok(pack(&(&*self.scene, &self.sensors))?)
    }

    /// What [`Views::to_bytes`] made.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Error> {
        let (scene, sensors): (Scene, _) = unpack(bytes)?;
        Self::new(scene, sensors)
    }

    /// Goes over to a scene of bytes with as many sensors, and refits what it can. Later answers
    /// are those of [`Views::from_bytes`].
    pub fn replace_by_bytes(&mut self, bytes: &[u8]) -> Result<(), Error> {
        let (scene, sensors): (Scene, Vec<SensorSettings>) = unpack(bytes)?;
        if sensors.len() != self.sensors.len() {
            *self = Self::new(scene, sensors)?;
            return Ok(());
        }
        self.replace(scene, sensors, Prepared::update_scene)?;
        self.registries
            .iter_mut()
            .for_each(|r| *r = OnceLock::new());
        Ok(())
    }

    /// The scene as the first sensor sees it.
    pub fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// The sensors.
    pub fn sensors(&self) -> &[SensorSettings] {
        &self.sensors
    }

    /// The scene, ready to be rendered by a sensor.
    pub fn prepared(&self, view: ViewId) -> Result<&Prepared, Error> {
        self.prepared_watched(view, &Unwatched)
    }

    /// [`Self::prepared`], unless it is not ready yet and the watch stops that: [`Error::Stopped`].
    pub fn prepared_watched(&self, view: ViewId, watch: &dyn Watch) -> Result<&Prepared, Error> {
        if view.sensor >= self.sensors.len() {
            return Err(Error::NoSuchSensor {
                sensors: self.sensors.len(),
                number: view.sensor,
            });
        }
        let place = &self.prepared[view.place()];
        if let Some(prepared) = place.get() {
            return Ok(prepared);
        }
        // Trees are built outside of the lock. Who is first is kept.
        let prepared = Prepared::watched(seen(&self.scene, &self.sensors, view), watch)?;
        Ok(place.get_or_init(|| prepared))
    }

    /// An error if names of parameters, or sums of them, mean one sensor that is called `sensor`
    /// while another renders, which is called so copy.
    pub fn check_names(&self, view: ViewId, names: &[&str]) -> Result<(), Error> {
        let is_another = |i: usize| i != view.sensor && self.sensors[i].sensor.id == "sensor";
        if !(0..self.sensors.len()).any(is_another) {
            return Ok(());
        }
        let in_sum = |c: char| c.is_whitespace() || "+-*".contains(c);
        let is_meant = |name: &&&str| name.split(in_sum).any(|part| part.starts_with("sensor."));
        match (names.iter().find(is_meant), self.sensors.get(view.sensor)) {
            (Some(name), Some(seen)) => Err(Error::OfAnotherSensor {
                name: name.to_string(),
                sensor: seen.sensor.id.clone(),
            }),
            _ => Ok(()),
        }
    }

    /// What went wrong in a view, whose own names do not tell a parameter of another sensor
    /// from one that there is not.
    pub fn explain(&self, view: ViewId, error: Error) -> Error {
        let Error::Parameter(ParameterError::Unknown { name, .. }) = &error else {
            return error;
        };
        let mut others = (0..self.sensors.len()).filter(|&i| i != view.sensor);
        match others.any(|i| self.gradient_shape(name, i).is_ok()) {
            true => Error::OfAnotherSensor {
                name: name.clone(),
                sensor: self.sensors[view.sensor].sensor.id.clone(),
            },
            false => error,
        }
    }

    /// The arrays of the scene, with those of all sensors.
    pub fn arrays(&self) -> Vec<ArrayParameter> {
        if self.sensors.len() == 1 {
            return self.registry(0).arrays().to_vec();
        }
        let arrays = self.registry(0).arrays().iter();
        let mut arrays: Vec<ArrayParameter> = arrays
            .filter(|array| !array.kind.is_of_sensor())
            .cloned()
            .collect();
        for i in 0..self.sensors.len() {
            let own = self.registry(i).arrays().iter();
            let own = own.filter(|array| self.is_own(i, array)).cloned();
            // `sensor`, of which it may be an alias, is not one of several.
            arrays.extend(own.map(|mut array| {
                array.alias_of = None;
                array
            }));
        }
        arrays
    }

    /// What an array of the scene is now.
    pub fn values(&self, name: &str) -> Result<Values, Error> {
        let sensor = self.sensor_of(name)?;
        let seen = self.sensors[sensor].scene(&self.scene);
        let array = array(self.registry(sensor), &seen, name)?;
        Ok(Values {
            numbers: array.get(&seen),
            shape: array.shape,
        })
    }

    /// The shape of a gradient of what a sensor sees with respect to an array, or to a sum of
    /// numbers, which has none; an error if the sensor knows neither.
    pub fn gradient_shape(&self, name: &str, sensor: usize) -> Result<Vec<usize>, Error> {
        let registry = self.registry(sensor);
        if let Some(array) = registry.array(name)? {
            return Ok(array.shape.clone());
        }
        registry.tangent(&self.sensors[sensor].scene(&self.scene), name)?;
        Ok(Vec::new())
    }

    /// Changes arrays, all of them or none, see [`Prepared::update`]. Methods stay chosen.
    pub fn update(&mut self, changes: &[(&str, &[f64])]) -> Result<(), Error> {
        let (scene, sensors) = (Scene::clone(&self.scene), self.sensors.clone());
        let (scene, sensors) = self.changed(scene, sensors, changes)?;
        self.replace(scene, sensors, Prepared::renumber)
    }

    /// Goes over to what another scene with the same names would be after these changes. Later
    /// answers do not depend on what was asked before.
    pub fn restore(&mut self, other: &Self, changes: &[(&str, &[f64])]) -> Result<(), Error> {
        let (scene, sensors) = (Scene::clone(&other.scene), other.sensors.clone());
        let (scene, sensors) = self.changed(scene, sensors, changes)?;
        self.replace(scene, sensors, Prepared::update_scene)
    }

    /// A scene with the same names, and its sensors, after these changes.
    fn changed(
        &self,
        mut scene: Scene,
        mut sensors: Vec<SensorSettings>,
        changes: &[(&str, &[f64])],
    ) -> Result<(Scene, Vec<SensorSettings>), Error> {
        for (name, numbers) in changes {
            let sensor = self.sensor_of(name)?;
            let mut seen = sensors[sensor].scene(&scene);
            array(self.registry(sensor), &seen, name)?.set(&mut seen, numbers)?;
            sensors[sensor].sensor = seen.sensor.clone();
            scene = seen;
        }
        Ok((scene, sensors))
    }

    /// Gives all images this width and height in pixels, without crop.
    pub fn resize(&mut self, size: [u32; 2]) -> Result<(), Error> {
        let mut sensors = self.sensors.clone();
        sensors.iter_mut().for_each(|view| view.film.resize(size));
        self.replace(Scene::clone(&self.scene), sensors, Prepared::update_scene)
    }

    /// Makes a view ready out of that of another sensor, which no longer is: trees and boundaries
    /// stay, and only what depends on the sensor is built anew. Later answers are those of a view
    /// that was made ready by itself. Does nothing if the view is ready, or none of the others is.
    ///
    /// So many sensors take turns with one set of trees, which each change of the scene refits once.
    pub fn turn(&mut self, view: ViewId) -> Result<(), Error> {
        if view.sensor >= self.sensors.len() || self.prepared[view.place()].get().is_some() {
            return Ok(());
        }
        let mut others = (0..self.sensors.len()).map(|sensor| ViewId { sensor, ..view });
        let ready = others.find_map(|other| self.prepared[other.place()].take());
        let Some(mut prepared) = ready else {
            return Ok(());
        };
        prepared.update_scene(seen(&self.scene, &self.sensors, view))?;
        self.prepared[view.place()] = OnceLock::from(prepared);
        Ok(())
    }

    /// Goes over to another scene with as many sensors: every view that is ready does so.
    fn replace(
        &mut self,
        scene: Scene,
        sensors: Vec<SensorSettings>,
        follow: fn(&mut Prepared, Scene) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let scene = Arc::new(sensors[0].scene(&scene));
        check(&scene, &sensors, Some(&self.scene)).map_err(Error::InvalidUpdate)?;
        (self.scene, self.sensors) = (scene, sensors);
        // A view that nobody has asked for costs nothing.
        for (view, place) in ViewId::all(self.sensors.len()).zip(&mut self.prepared) {
            if let Some(prepared) = place.get_mut() {
                follow(prepared, seen(&self.scene, &self.sensors, view))?;
            }
        }
        Ok(())
    }

    /// The sensor that an array is of, or the first for what all of them see.
    fn sensor_of(&self, name: &str) -> Result<usize, Error> {
        for i in 0..self.sensors.len() {
            let array = self.registry(i).array(name)?;
            if array.is_some_and(|array| self.is_own(i, array)) {
                return Ok(i);
            }
        }
        let array = self.registry(0).array(name)?;
        match array.is_some_and(|a| a.kind.is_of_sensor()) && self.sensors.len() > 1 {
            true => Err(Error::SeveralSensors {
                name: name.into(),
                sensors: self.sensors.iter().map(|v| v.sensor.id.clone()).collect(),
            }),
            false => Ok(0),
        }
    }

    /// True for the arrays of a sensor under its own name.
    fn is_own(&self, sensor: usize, array: &ArrayParameter) -> bool {
        let id = &self.sensors[sensor].sensor.id;
        let own = array.name.strip_prefix(id.as_str());
        array.kind.is_of_sensor() && own.is_some_and(|rest| rest.starts_with('.'))
    }

    fn registry(&self, sensor: usize) -> &Registry {
        self.registries[sensor]
            .get_or_init(|| Registry::new(&self.sensors[sensor].scene(&self.scene)))
    }
}

/// The scene of a view.
fn seen(scene: &Scene, sensors: &[SensorSettings], view: ViewId) -> Scene {
    let mut seen = sensors[view.sensor].scene(scene);
    if let Some(aov) = view.aov {
        seen.settings.integrator = Integrator::Aov(aov);
    }
    seen
}

/// An error unless all sensors can render a scene, and all go by different names. `checked` is a
/// scene that has passed already, if there is one.
fn check(
    scene: &Scene,
    sensors: &[SensorSettings],
    checked: Option<&Scene>,
) -> Result<(), SceneError> {
    scene.check_after(checked)?;
    let shapes = scene.shapes.iter().map(|shape| shape.id.as_str());
    let mut ids: HashSet<&str> = shapes.collect();
    for view in sensors {
        view.film.check()?;
        view.sensor.check()?;
        if !ids.insert(&view.sensor.id) {
            return Err(SceneError::DuplicateId {
                id: view.sensor.id.clone(),
            });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
