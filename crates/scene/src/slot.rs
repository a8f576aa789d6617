//! Where textures stand.

use crate::ids::TextureId;
use crate::quantity::Quantity;

/// A place for a texture in a material or an emitter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slot {
    /// Its name.
    pub name: &'static str,
    /// What stands there.
    pub texture: TextureId,
    /// What its numbers are.
    pub quantity: Quantity,
}
