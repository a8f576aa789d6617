//! All parameters of a scene, found by name.

use std::collections::HashMap;
use std::collections::hash_map::Entry::{Occupied, Vacant};
use std::sync::Arc;

use super::array::ArrayParameter;
use super::array_names::behind;
use super::error::ParameterError;
use super::names::{Entry, Names};
use super::parameter::Parameter;
use super::scalar::describe;
use super::target::Target;
use super::users::users;
use crate::scene::Scene;

/// The parameters of a scene by their names, in time linear in the scene to make.
///
/// It stays right when numbers of the scene change, but not when shapes, materials,
/// emitters or textures are added, or get other names.
#[derive(Clone, Debug)]
pub struct Registry {
    names: Names,
    scalars: HashMap<Arc<str>, Found>,
    arrays: Vec<ArrayParameter>,
    arrays_by_name: HashMap<String, Found>,
    /// Bytes of the longest of all names.
    longest: usize,
    /// For each texture, where it is seen.
    users: Vec<String>,
}

/// What has a name: the place in a list.
#[derive(Clone, Copy, Debug)]
enum Found {
    One(u32),
    /// Different things have this name.
    Several,
}

impl Registry {
    /// The parameters of a scene.
    pub fn new(scene: &Scene) -> Self {
        let (names, users) = (Names::new(scene), users(scene));
        let entries: Vec<&Entry> = names.iter().collect();
        let mut scalars = HashMap::with_capacity(entries.len());
        for (i, entry) in entries.iter().enumerate() {
            let same = |first: u32| entries[first as usize].target == entry.target;
            insert(&mut scalars, entry.name.clone(), i, same);
        }
        let arrays = names
            .iter()
            .flat_map(|entry| behind(scene, &names, entry, &users));
        let arrays: Vec<ArrayParameter> = arrays.collect();
        let mut arrays_by_name = HashMap::with_capacity(arrays.len());
        for (i, array) in arrays.iter().enumerate() {
            let same = |first: u32| arrays[first as usize].place == array.place;
            insert(&mut arrays_by_name, array.name.clone(), i, same);
        }
        let of_scalars = entries.iter().map(|entry| entry.name.len());
        let of_arrays = arrays.iter().map(|array| array.name.len());
        Self {
            longest: of_scalars.chain(of_arrays).max().unwrap_or(0),
            scalars,
            names,
            arrays,
            arrays_by_name,
            users,
        }
    }

    /// Every scalar parameter with its value in `scene`, shape by shape, then emitters,
    /// materials and the sensor; other names directly behind the one they stand for.
    pub fn scalars(&self, scene: &Scene) -> Vec<Parameter> {
        let entries = self.names.iter();
        entries
            .filter_map(|entry| self.describe(scene, entry))
            .collect()
    }

    /// Every array, in the order of the scalars.
    pub fn arrays(&self) -> &[ArrayParameter] {
        &self.arrays
    }

    /// The scalar with this name and its value in `scene`; `None` if there is none, or
    /// several.
    pub fn scalar(&self, scene: &Scene, name: &str) -> Option<Parameter> {
        match self.scalars.get(name)? {
            Found::One(place) => self.describe(scene, self.names.get(*place)),
            Found::Several => None,
        }
    }

    /// The array with this name, or `None` if there is none.
    pub fn array(&self, name: &str) -> Result<Option<&ArrayParameter>, ParameterError> {
        match self.arrays_by_name.get(name) {
            None => Ok(None),
            Some(Found::One(place)) => Ok(Some(&self.arrays[*place as usize])),
            Some(Found::Several) => Err(ParameterError::Ambiguous { name: name.into() }),
        }
    }

    /// True if an array, or several, have this name.
    pub(super) fn has_array(&self, name: &str) -> bool {
        self.arrays_by_name.contains_key(name)
    }

    /// The longest name of an array that `text` starts with and a bracket follows.
    pub(super) fn array_before_bracket<'a>(
        &self,
        text: &'a str,
    ) -> Result<Option<(&'a str, &ArrayParameter)>, ParameterError> {
        let near = &text[..text.floor_char_boundary(self.longest + 1)];
        for (bracket, _) in near.rmatch_indices('[') {
            let name = &text[..bracket];
            if let Some(array) = self.array(name)? {
                return Ok(Some((name, array)));
            }
        }
        Ok(None)
    }

    /// What the longest name of a scalar refers to that `text` starts with and that a
    /// sign, white space and a sign, or nothing follows; and the text behind the name.
    pub(super) fn leading_scalar<'a>(
        &self,
        text: &'a str,
    ) -> Result<Option<(Target, &'a str)>, ParameterError> {
        // No name ends behind the longest one, whatever follows: sums can be long.
        let most = text.floor_char_boundary(self.longest);
        let space = text.len() - most - text[most..].trim_start().len();
        let seen = text.len().min(most + space + 1);
        let near = &text[..text.floor_char_boundary(seen)];
        let is_whole = (near.len() == text.len()).then_some(text.len());
        let signs = near.rmatch_indices(['+', '-']).map(|(sign, _)| sign);
        // White space before a sign may belong to the name or not.
        let ends = is_whole.into_iter().chain(signs).flat_map(|end| {
            let least = text[..end].trim_end().len();
            (least..=end.min(most))
                .rev()
                .filter(|&end| text.is_char_boundary(end))
        });
        let mut names = ends.map(|end| text.split_at(end));
        let Some((name, after)) = names.find(|(name, _)| self.scalars.contains_key(*name)) else {
            return Ok(None);
        };
        match self.scalars[name] {
            Found::Several => Err(ParameterError::Ambiguous { name: name.into() }),
            Found::One(place) => match self.names.get(place).target {
                None => Err(ParameterError::TwoSides { name: name.into() }),
                Some(target) => Ok(Some((target, after))),
            },
        }
    }

    /// All names: those of arrays, then those of scalars that are no arrays.
    pub(super) fn all_names(&self) -> impl Iterator<Item = &str> {
        let scalars = self.names.iter().filter(|entry| entry.target.is_some());
        let scalars = scalars.map(|entry| &*entry.name);
        let only_scalars = scalars.filter(|&name| !self.has_array(name));
        let arrays = self.arrays.iter().map(|array| array.name.as_str());
        arrays.chain(only_scalars)
    }

    fn describe(&self, scene: &Scene, entry: &Entry) -> Option<Parameter> {
        let alias_of = self.names.alias_of(entry).map(String::from);
        let name = entry.name.to_string();
        Some(describe(scene, entry.target?, &self.users, name, alias_of))
    }
}

/// Remembers the place of a name; `is_same` says whether an earlier place of it means
/// the same.
fn insert<K: Eq + std::hash::Hash>(
    found: &mut HashMap<K, Found>,
    name: K,
    place: usize,
    is_same: impl Fn(u32) -> bool,
) {
    match found.entry(name) {
        Vacant(entry) => {
            entry.insert(Found::One(place as u32));
        }
        Occupied(mut entry) => match *entry.get() {
            Found::One(first) if is_same(first) => {}
            Found::One(_) | Found::Several => {
                entry.insert(Found::Several);
            }
        },
    }
}

#[cfg(test)]
mod tests {
    use std::time::Instant;

    use capwalk_math::{Affine, Rgb};

    use super::super::tests::example;
    use super::*;
    use crate::ids::BsdfId;
    use crate::material::Material;
    use crate::material::lobe::Diffuse;
    use crate::primitive;
    use crate::shape::Shape;
    use crate::texture::Texture;

    /// Shapes with a material and a texture each. If every texture were looked for in all
    /// materials, and every material in all shapes, this would take minutes.
    #[test]
    fn registries_take_time_in_proportion_to_scenes() {
        const SHAPES: u32 = 20_000;
        let mut scene = example();
        scene.shapes.clear();
        scene.emitters.clear();
        scene.materials.clear();
        scene.textures.clear();
        for i in 0..SHAPES {
            let name = format!("shape{i}");
            let colour = Texture::colour(format!("{name}.bsdf.reflectance"), Rgb::splat(0.5));
            let reflectance = scene.add_texture(colour);
            scene.materials.push(Material {
                id: format!("{name}.bsdf"),
                bsdf: Diffuse { reflectance }.into(),
            });
            let (mesh, normals) = primitive::rectangle(Affine::IDENTITY);
            scene.add_shape(Shape::new(name, mesh, normals, BsdfId(i)));
        }
        let start = Instant::now();
        let registry = Registry::new(&scene);
        let (scalars, arrays) = (registry.scalars(&scene), registry.arrays());
        assert_eq!(scalars.len(), 20_000 * (7 + 4) + 2 * 9);
        assert_eq!(arrays.len(), 20_000 * 5 + 2 * 6);
        let sum = "shape19999.scale - 2*shape7.bsdf.reflectance.value.r + shape0.positions[2]";
        assert!(registry.tangent(&scene, sum).is_ok());
        let unknown = registry.tangent(&scene, "shape19999.bsdf.reflectence.value");
        let message = unknown.expect_err("misspelt").to_string();
        assert!(
            message.contains("`shape19999.bsdf.reflectance.value`"),
            "{message}"
        );
        let nothing = registry.tangent(&scene, "no such thing");
        assert!(nothing.is_err());
        let seconds = start.elapsed().as_secs_f64();
        assert!(seconds < 5.0, "{seconds} s");
    }
}
