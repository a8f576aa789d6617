#![no_main]

#[allow(dead_code, reason = "each target uses one of them")]
#[path = "../../crates/scene-io/tests/reading/readers.rs"]
mod readers;

/// Files that scenes may name.
const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../crates/scene-io/tests/data");

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    readers::scene_in(std::path::Path::new(FOLDER), bytes);
});
