//! The velocity fields that the paper compares: against finite differences and closed forms, in both
//! modes, and what they refuse. One program, for the reasons of the tests of `capwalk-diff`, whose
//! scenes these are.

mod baselines;
#[path = "../../../../crates/diff/tests/gradients/common/mod.rs"]
mod common;
#[allow(dead_code, reason = "only some folders, of which none is refused")]
#[path = "../../../../crates/cli/tests/phenomena/folder.rs"]
mod folder;
mod in_both_modes;
#[allow(dead_code, reason = "one method")]
#[path = "../../../../crates/cli/tests/phenomena/methods.rs"]
mod methods;
mod on_triangles;
#[path = "../../../../crates/cli/tests/phenomena/reference.rs"]
mod reference;
mod refused;
mod scenes;

use common::store;
