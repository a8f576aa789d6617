//! The capwalk command.
fn main() {}
