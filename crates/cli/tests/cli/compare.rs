use crate::{Capwalk, assert_has};

#[test]
fn images_of_two_seeds_agree_within_their_errors() {
    let capwalk = Capwalk::new("compare");
    // Of forty pairs of seeds one leaves a doubt, as 1 and 2 do here (mean z² 1.31 ± 0.15).
    for seed in [3, 4] {
        capwalk.run(&format!(
            "render leaf --size 24x18 --spp 64 --seed {seed} -o {seed}.exr,{seed}.npz"
        ));
    }
    for ending in ["exr", "npz"] {
        let json = capwalk.json(&format!("compare 3.{ending} 4.{ending} --json"));
        assert_eq!(json["comparison"]["verdict"], "right", "{json:#}");
    }
    let same = capwalk.run("compare 3.exr 3.exr");
    assert_eq!(same.status, 0);
    assert_has(&same.stdout, &["identical"]);
    // Different samples of a pixel, but half of them the same: differences are
    // smaller than the errors allow.
    capwalk.run("render leaf --size 24x18 --spp 32 --seed 3 -o half.exr");
    assert_eq!(capwalk.run("compare 3.exr half.exr").status, 1);
}

#[test]
fn a_darker_image_differs() {
    let capwalk = Capwalk::new("compare_darker");
    let options = "--size 24x18 --spp 256 -o";
    capwalk.json("scenes --export . --json leaf");
    let scene = String::from_utf8(capwalk.bytes("leaf.xml")).expect("text");
    let darker = scene.replace("70", "60");
    assert_ne!(scene, darker, "the emitter of leaf has a radiance of 70");
    capwalk.write("darker.xml", &darker);
    for scene in ["leaf", "darker"] {
        capwalk.run(&format!(
            "render {scene}.xml {options} {scene}.npz --seed 3"
        ));
    }
    let finished = capwalk.run("compare darker.npz leaf.npz");
    assert_eq!(finished.status, 1, "{}", finished.stdout);
}

/// Not a pixel of both is a number.
#[test]
fn images_of_nothing_but_nan_are_not_compared() {
    let capwalk = Capwalk::new("compare_nan");
    let mut layered = capwalk_scene_io::image::LayeredImage::default();
    let mut image = capwalk_scene::Image::new(3, 2);
    image.pixels.fill(capwalk_math::Rgb::splat(f64::NAN));
    layered.push("value", image);
    capwalk_scene_io::image::write(&capwalk.path("nan.npz"), &layered, &Default::default())
        .expect("writable");
    let error = capwalk.error("compare nan.npz nan.npz");
    assert_has(
        &error,
        &["no pixel of the layer \"value\" is a finite number"],
    );
}

#[test]
fn sizes_must_agree() {
    let capwalk = Capwalk::new("compare_sizes");
    capwalk.run("render leaf --size 8x6 --spp 2 -o a.npz");
    capwalk.run("render leaf --size 6x8 --spp 2 -o b.npz");
    let message = capwalk.error("compare a.npz b.npz");
    assert_has(&message, &["8 x 6", "6 x 8"]);
    assert_has(
        &capwalk.error("compare a.npz missing.npz"),
        &["missing.npz"],
    );
}
