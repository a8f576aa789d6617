//! Environment maps as the kernels read them: `environment_map.slang` says which word is what.

use capwalk_geometry::buffers::NONE;
use capwalk_scene::emitter::{EnvironmentMap, EnvironmentTable};
use capwalk_scene::{Scene, TextureId};

use crate::texture_records::{TextureRecords, float, two_floats};

/// Appends the record of a map with these texels and the factor on them, and its table if it is not
/// black. Returns where the record starts.
pub fn add_environment_map(
    scene: &Scene,
    map: &EnvironmentMap,
    [data, scale]: [TextureId; 2],
    table: Option<&EnvironmentTable>,
    textures: &mut TextureRecords,
    words: &mut Vec<u32>,
) -> u32 {
    let texels = [data, scale].map(|id| textures.add(scene, id, None, words));
    let table = table.map_or([NONE; 3], |table| {
        let rows = add_sums(table.row_sums(), words);
        let cells = add_sums(table.cell_sums(), words);
        let densities = words.len() as u32;
        words.extend(table.densities().iter().copied().map(float));
        [rows, cells, densities]
    });
    let at = words.len() as u32;
    words.extend([map.width, map.height]);
    for row in map.world_from_map.rows {
        words.extend(row.to_array().map(float));
    }
    words.extend(texels);
    words.extend(table);
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
