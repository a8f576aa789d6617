//! Environment maps as the kernels read them: `layout.rs` says which word is what.

use capwalk_geometry::buffers::NONE;
use capwalk_scene::emitter::{EnvironmentMap, EnvironmentTable};
use capwalk_scene::{Scene, TextureId};

use crate::layout::environment_map::*;
use crate::texture_records::{TextureRecords, float, two_floats};

/// Appends the record of a map with these texels and the factor on them, and its table unless it is
/// black. Returns where the record starts.
pub fn add_environment_map(
    scene: &Scene,
    map: &EnvironmentMap,
    [data, scale]: [TextureId; 2],
    table: &EnvironmentTable,
    textures: &mut TextureRecords,
    words: &mut Vec<u32>,
) -> u32 {
    let texels = [data, scale].map(|id| textures.add(scene, id, None, words));
    let table = match table.is_black() {
        true => [NONE; 3],
        false => {
            let rows = add_sums(table.row_sums(), words);
            let cells = add_sums(table.cell_sums(), words);
            let densities = words.len() as u32;
            words.extend(table.densities().iter().copied().map(float));
            [rows, cells, densities]
        }
    };
    let mut map_words = [0; ENVIRONMENT_RECORD];
    map_words[MAP_WIDTH] = map.width;
    map_words[MAP_HEIGHT] = map.height;
    let rotation = map.world_from_map.rows.map(|row| row.to_array().map(float));
    map_words[WORLD_FROM_MAP..MAP_TEXELS].copy_from_slice(rotation.as_flattened());
    map_words[MAP_TEXELS..ROW_SUMS].copy_from_slice(&texels);
    map_words[ROW_SUMS..].copy_from_slice(&table);
    let at = words.len() as u32;
    words.extend(map_words);
    at
}

/// Appends sums, each as a number of single precision and the rest of it: dark cells are much smaller
/// than the sum up to them. Returns where they start.
fn add_sums(sums: &[f64], words: &mut Vec<u32>) -> u32 {
    let at = words.len() as u32;
    for &sum in sums {
        words.extend(two_floats(sum));
    }
    at
}
