//! Parameters that are set before anything is done.

use std::fmt;
use std::str::FromStr;

use capwalk_inverse::variable::{VariableSpec, Variables, variable};
use capwalk_scene::Scene;
use capwalk_scene::params::{ParameterKind, Registry};

use crate::error::Error;

/// A parameter and the value that it is to have: `ball.scale=2`,
/// `floor.bsdf.reflectance.value=0.1,0.2,0.3`. Names and values are those of unknowns in
/// [`optimize`](crate::optimize): numbers of arrays are replaced, one for all or each by its
/// own, and a place is relative to that in the scene, `ball.translate.x=0.1` is 0.1 farther
/// along x.
///
/// ```
/// let setting: capwalk::Setting = "floor.bsdf.reflectance.value=0.1,0.2,0.3".parse()?;
/// let scene = capwalk::Loader::new("leaf").set(setting).load()?.scene;
/// let prepared = capwalk::Prepared::new(scene)?;
/// let name = "floor.bsdf.reflectance.value";
/// assert_eq!(prepared.values(name)?.numbers, [0.1, 0.2, 0.3]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// An array, a parameter, or a sum of parameters.
    pub name: String,
    /// What it is to be.
    pub values: Vec<f64>,
}

/// A text is no [`Setting`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "expected NAME=VALUE with a finite number, or several separated by commas, for example \
     ball.translate.x=0.1 or floor.bsdf.reflectance.value=0.2,0.4,0.6"
)]
pub struct NotASetting;

impl FromStr for Setting {
    type Err = NotASetting;

    fn from_str(text: &str) -> Result<Self, NotASetting> {
        // Numbers have no `=`, names may.
        let (name, values) = text.rsplit_once('=').ok_or(NotASetting)?;
        let number = |text: &str| text.trim().parse().ok().filter(|x: &f64| x.is_finite());
        let values: Option<Vec<f64>> = values.split(',').map(number).collect();
        match name.trim() {
            "" => Err(NotASetting),
            name => Ok(Self {
                name: name.into(),
                values: values.ok_or(NotASetting)?,
            }),
        }
    }
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let values: Vec<String> = self.values.iter().map(f64::to_string).collect();
        write!(f, "{}={}", self.name, values.join(","))
    }
}

/// The scene with other values of parameters, all of them at once: none changes what another
/// one means.
pub fn set(scene: &Scene, settings: &[Setting]) -> Result<Scene, Error> {
    let registry = Registry::new(scene);
    let known = |setting: &Setting| {
        let Setting { name, values } = setting;
        // Unknowns would be displacements of all vertices.
        if let Some(array) = registry.array(name)?
            && array.kind == ParameterKind::Positions
        {
            return Err(Error::ManyPositions { name: name.clone() });
        }
        let spec = VariableSpec {
            name: name.clone(),
            start: Some(values.clone()),
            ..VariableSpec::default()
        };
        Ok(variable(scene, &registry, &spec)?)
    };
    let known: Result<Vec<_>, Error> = settings.iter().map(known).collect();
    let variables = Variables::new(scene, known?)?;
    Ok(variables.apply(scene, &variables.values(&variables.initial()))?)
}
