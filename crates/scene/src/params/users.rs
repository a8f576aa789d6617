//! Where the textures of a scene are seen.

use std::collections::HashSet;

use crate::ids::{BsdfId, TextureId};
use crate::scene::Scene;

/// How many names are listed before the others are only counted.
const LISTED: usize = 3;

/// For each texture, the shapes whose appearance it determines, and the emitters without a
/// shape that it stands in; or its own id if there are none.
pub(super) fn users(scene: &Scene) -> Vec<String> {
    let mut users = vec![Users::default(); scene.textures.len()];
    let of_materials = textures_of_materials(scene);
    for shape in &scene.shapes {
        let mut textures: HashSet<TextureId> = of_materials[shape.bsdf.0 as usize]
            .iter()
            .copied()
            .collect();
        textures.extend(shape.emitter.map(|id| scene.emitter(id).radiance()));
        textures.extend(shape.attributes.iter().map(|attribute| attribute.texture));
        for texture in textures {
            users[texture.0 as usize].add(&shape.id);
        }
    }
    for emitter in &scene.emitters {
        // With the shape, above.
        if emitter.shape().is_some() {
            continue;
        }
        let slots = emitter.slots();
        let textures: HashSet<TextureId> = slots.iter().map(|slot| slot.texture).collect();
        for texture in textures {
            users[texture.0 as usize].add(&emitter.name(scene));
        }
    }
    let pairs = users.iter().zip(&scene.textures);
    pairs
        .map(|(users, texture)| users.text(&texture.id))
        .collect()
}

/// The textures in each material and in all that it is made of.
fn textures_of_materials(scene: &Scene) -> Vec<Vec<TextureId>> {
    let ids = (0..scene.materials.len() as u32).map(BsdfId);
    let textures = |id| {
        scene
            .slots_below(id)
            .iter()
            .map(|slot| slot.texture)
            .collect()
    };
    ids.map(textures).collect()
}

/// The first of them, and how many there are.
#[derive(Clone, Debug, Default)]
struct Users {
    first: Vec<String>,
    count: usize,
}

impl Users {
    fn add(&mut self, name: &str) {
        self.count += 1;
        if self.first.len() < LISTED {
            self.first.push(name.to_owned());
        }
    }

    fn text(&self, texture: &str) -> String {
        match self.count {
            0 => format!("{texture} (unused)"),
            1..=LISTED => self.first.join(", "),
            n => {
                let first = &self.first[..LISTED - 1];
                format!("{} and {} more", first.join(", "), n - first.len())
            }
        }
    }
}
