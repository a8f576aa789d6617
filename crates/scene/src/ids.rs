//! Places in the lists of a scene.

use serde::{Deserialize, Serialize};

/// Index into [`Scene::shapes`](crate::Scene::shapes).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct ShapeId(pub u32);
/// Index into [`Scene::materials`](crate::Scene::materials).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct BsdfId(pub u32);
/// Index into [`Scene::emitters`](crate::Scene::emitters).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct EmitterId(pub u32);
/// Index into [`Scene::textures`](crate::Scene::textures).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct TextureId(pub u32);
