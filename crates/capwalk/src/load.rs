//! From the name of a scene to the scene.

use std::path::{Path, PathBuf};

use capwalk_scene::{Filter, Scene, builtin};
use capwalk_scene_io::{
    FilesRead, LoadOptions, Loaded, SensorChoice, SensorSettings, load_scene_with,
};

use crate::error::Error;
use crate::method::Choice;
use crate::setting::{Setting, set};

/// The scene in a Mitsuba 3 XML or glTF file, or the built-in scene of this name.
///
/// ```
/// let loaded = capwalk::load("leaf")?;
/// assert!(loaded.scene.shapes.iter().any(|shape| shape.id == "leaf"));
/// assert!(loaded.warnings.is_empty());
///
/// let error = capwalk::load("no_such_file.xml").unwrap_err();
/// assert!(matches!(error, capwalk::Error::UnknownScene { .. }));
/// # Ok::<(), capwalk::Error>(())
/// ```
pub fn load(name: impl AsRef<Path>) -> Result<Loaded, Error> {
    Loader::new(name).load()
}

/// With the widths that are Mitsuba's defaults.
impl Choice for Filter {
    const NAMES: &'static [(&'static str, Self)] = &[
        ("box", Self::Box),
        ("tent", Self::Tent { radius: 1.0 }),
        ("gaussian", Self::Gaussian { stddev: 0.5 }),
        (
            "mitchell",
            Self::Mitchell {
                b: 1.0 / 3.0,
                c: 1.0 / 3.0,
            },
        ),
        ("catmullrom", Self::CATMULL_ROM),
        ("lanczos", Self::Lanczos { lobes: 3 }),
    ];

    fn help(self) -> &'static str {
        match self {
            Self::Box => "One pixel wide",
            Self::Tent { .. } => "Triangle of radius 1",
            Self::Gaussian { .. } => "Standard deviation 0.5, radius 2",
            Self::CATMULL_ROM => "Catmull and Rom, radius 2",
            Self::Mitchell { .. } => "Mitchell and Netravali, B = C = 1/3, radius 2",
            Self::Lanczos { .. } => "Three lobes, radius 3",
        }
    }
}

/// Loads a scene with changes to what its file says.
///
/// ```
/// let loaded = capwalk::Loader::new("leaf").size([64, 48]).load()?;
/// assert_eq!(loaded.scene.film.crop_size, [64, 48]);
/// # Ok::<(), capwalk::Error>(())
/// ```
#[derive(Clone, Debug)]
#[must_use = "nothing is loaded before `load`"]
pub struct Loader {
    name: PathBuf,
    options: LoadOptions,
    size: Option<[u32; 2]>,
    filter: Option<Filter>,
    settings: Vec<Setting>,
}

impl Loader {
    /// For a Mitsuba 3 XML or glTF file, or the built-in scene of this name.
    pub fn new(name: impl AsRef<Path>) -> Self {
        Self {
            name: name.as_ref().into(),
            options: LoadOptions::default(),
            size: None,
            filter: None,
            settings: Vec::new(),
        }
    }

    /// With a value of `$name` in the file, which wins over its `<default>` and over
    /// values that are given later.
    pub fn define(mut self, name: impl Into<String>, value: impl Into<String>) -> Self {
        self.options.defines.push((name.into(), value.into()));
        self
    }

    /// With this sensor of the file, by its number from 0 or by its name; by default the
    /// first, with a warning if there are others.
    pub fn sensor(mut self, sensor: impl Into<SensorChoice>) -> Self {
        self.options.sensor = Some(sensor.into());
        self
    }

    /// With an image of this width and height in pixels, without crop.
    pub fn size(mut self, size: [u32; 2]) -> Self {
        self.size = Some(size);
        self
    }

    /// With this reconstruction filter.
    pub fn filter(mut self, filter: Filter) -> Self {
        self.filter = Some(filter);
        self
    }

    /// With other values of parameters, see [`Setting`].
    pub fn set(mut self, setting: Setting) -> Self {
        self.settings.push(setting);
        self
    }

    /// The scene, checked.
    pub fn load(&self) -> Result<Loaded, Error> {
        let mut loaded = match self.name.to_str().and_then(builtin::scene) {
            Some(scene) => {
                self.refuse_options_of_files(&scene)?;
                Loaded {
                    sensors: vec![SensorSettings::of(&scene)],
                    scene,
                    warnings: Vec::new(),
                    files: FilesRead::default(),
                }
            }
            None => self.read()?,
        };
        let films = loaded.sensors.iter_mut().map(|view| &mut view.film);
        for film in films.chain([&mut loaded.scene.film]) {
            if let Some(size) = self.size {
                film.resize(size);
            }
            if let Some(filter) = self.filter {
                film.filter = filter;
            }
        }
        loaded.scene.check().map_err(|error| Error::InvalidScene {
            scene: self.shown(),
            error,
        })?;
        if !self.settings.is_empty() {
            loaded.scene = set(&loaded.scene, &self.settings)?;
            // What the sensor that renders is now.
            let id = &loaded.scene.sensor.id;
            if let Some(view) = loaded.sensors.iter_mut().find(|v| v.sensor.id == *id) {
                view.sensor = loaded.scene.sensor.clone();
            }
        }
        Ok(loaded)
    }

    /// A built-in scene has no `$name` and one sensor.
    fn refuse_options_of_files(&self, scene: &Scene) -> Result<(), Error> {
        if !self.options.defines.is_empty() {
            let scene = self.shown();
            return Err(Error::NothingToDefine { scene });
        }
        let names = [scene.sensor.id.clone()];
        match &self.options.sensor {
            Some(choice) if choice.place(&names).is_none() => Err(match choice.clone() {
                SensorChoice::Number(number) => Error::NoSuchSensor { sensors: 1, number },
                SensorChoice::Name(name) => Error::NoSensorNamed {
                    name,
                    sensors: names.into(),
                },
            }),
            _ => Ok(()),
        }
    }

    fn read(&self) -> Result<Loaded, Error> {
        if !self.name.exists() {
            return Err(Error::UnknownScene { name: self.shown() });
        }
        Ok(load_scene_with(&self.name, &self.options)?)
    }

    /// The name as messages show it.
    fn shown(&self) -> String {
        self.name.display().to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Names that are no UTF-8 are opened as they are.
    #[cfg(unix)]
    #[test]
    fn paths_are_kept_as_they_are() {
        use std::ffi::OsStr;
        use std::os::unix::ffi::OsStrExt;

        let name = format!("capwalk-load-{}-", std::process::id());
        let name = [name.as_bytes(), b"\xff.xml"].concat();
        let path = std::env::temp_dir().join(OsStr::from_bytes(&name));
        let xml = r#"<scene version="3.0.0"><integrator type="path"/>
<sensor type="perspective"/><emitter type="constant"/><shape type="cube" id="box"/></scene>"#;
        std::fs::write(&path, xml).expect("writable");
        let loaded = load(&path);
        std::fs::remove_file(&path).expect("it was written");
        assert_eq!(loaded.expect("a scene").scene.shapes[0].id, "box");
    }
}
