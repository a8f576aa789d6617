//! `--method edges` and what `--method auto` chooses against finite differences, wherever
//! something moves.

use capwalk_diff::{Estimate, Method};
use capwalk_scene::{EmitterVectors, SensorVectors};

use crate::folder::{Edges, Folder};
use crate::methods::{agrees, by, chosen};
use crate::reference::tangent;

/// Enough samples to see that two methods are not the same.
const FEW: u32 = 4;

/// Demands that gathered edges agree with the reference, or are walks
/// again; and the same of what is chosen, if that is neither.
pub fn agree(folder: &Folder, parameter: &str, edges: Edges, reference: &Estimate) {
    let name = format!("{}, {parameter}", folder.name);
    let scene = folder.scene();
    let tangent = tangent(folder, &scene, parameter);
    let lights = &tangent.emitters;
    let is_stationary = tangent.shapes.iter().all(Option::is_none)
        && tangent.sensor == SensorVectors::default()
        && lights
            .iter()
            .all(|light| *light == EmitterVectors::default());
    if is_stationary {
        return;
    }
    let [walk, gathered, auto] =
        [Method::Walk, Method::EDGES, Method::Auto].map(|method| chosen(method, &scene, &tangent));
    let few = |options| by(options, FEW, &scene, &tangent).mean;
    let (walked, few_gathered, few_auto) = (few(walk), few(gathered), few(auto));
    assert_eq!(
        few_gathered == walked,
        edges == Edges::Walked,
        "{name}: are edges the same as walks, as check.json says?"
    );
    if edges == Edges::Gathered {
        let name = format!("{name}, edges");
        agrees(&name, gathered, &scene, &tangent, reference);
    }
    if few_auto != walked && few_auto != few_gathered {
        let name = format!("{name}, auto");
        agrees(&name, auto, &scene, &tangent, reference);
    }
}
