#![no_main]

#[allow(dead_code, reason = "each target uses one of them")]
#[path = "../../crates/scene-io/tests/reading/readers.rs"]
mod readers;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    readers::obj(bytes);
});
