//! What a program that was built without the feature `gpu` says about it.

use crate::{Capwalk, assert_has};

#[test]
fn without_the_feature_a_gpu_is_an_error_that_says_how_to_build_it() {
    let capwalk = Capwalk::new("device_not_built");
    let render = "render leaf --spp 1 --size 8x6 -o image.exr";
    let message = capwalk.error(&format!("{render} --device gpu"));
    assert_has(
        &message,
        &["built without the GPU", "--features gpu", "--device cpu"],
    );
    assert!(!capwalk.folder.join("image.exr").exists());
    // Without a GPU, any is as good as another.
    let json = capwalk.json(&format!("{render} --device auto --json"));
    assert_eq!(json["device"], "cpu");
}
