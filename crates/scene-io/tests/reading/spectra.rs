//! Spectra become the colours that Mitsuba 3.9.1 makes of them in `scalar_rgb`: the numbers
//! are what `mi.traverse(mi.load_string(...))` shows for the same text, unless it says
//! otherwise.

use capwalk_math::Rgb;
use capwalk_scene::lobe::{Diffuse, Lobe};
use capwalk_scene::{Bsdf, Emitter, Pattern};

use crate::common::*;

/// Mitsuba computes colours in single precision and shows six digits.
const ROUNDED: f64 = 1e-5;

fn reflectance(property: &str) -> Rgb {
    let scene = load(&scene(&format!(
        "<bsdf type=\"diffuse\" id=\"m\">{property}</bsdf>"
    )));
    let Bsdf::Plain(Lobe::Diffuse(Diffuse { reflectance })) = scene.materials[0].bsdf else {
        panic!("{:?}", scene.materials[0]);
    };
    scene.texture(reflectance).texel(0)
}

/// The eta and k of a conductor.
fn indices(properties: &str) -> [Rgb; 2] {
    let scene = load(&scene(&format!(
        "<bsdf type=\"conductor\" id=\"m\">{properties}</bsdf>"
    )));
    let Bsdf::Plain(Lobe::Conductor(metal)) = &scene.materials[0].bsdf else {
        panic!("{:?}", scene.materials[0]);
    };
    [metal.eta, metal.k].map(|texture| scene.texture(texture).texel(0))
}

fn radiance(property: &str) -> Rgb {
    let scene = load(&scene(&format!(
        "<shape type=\"cube\"><emitter type=\"area\">{property}</emitter></shape>"
    )));
    let mut emitters = scene.emitters.iter();
    let area = emitters.find(|emitter| matches!(emitter, Emitter::Area { .. }));
    scene
        .texture(area.expect("the cube emits").radiance())
        .texel(0)
}

fn assert_near(found: Rgb, expected: [f64; 3]) {
    let pairs = found.to_array().into_iter().zip(expected);
    let near = |(a, b): (f64, f64)| (a - b).abs() <= ROUNDED * b.abs();
    assert!(pairs.clone().all(near), "{found:?} is not {expected:?}");
}

const METAL: &str = "300:1.8, 400:1.65, 500:0.9, 600:0.2, 700:0.16, 800:0.18";

/// Reflectances are under daylight and within 0 and 1, indices under daylight, light is as
/// it is; zero outside of the wavelengths that are given.
#[test]
fn pairs() {
    let named = |name: &str, value: &str| format!("<spectrum name=\"{name}\" value=\"{value}\"/>");
    let reflected = |value: &str| reflectance(&named("reflectance", value));
    assert_near(
        reflected("400:0.1, 700:0.5"),
        [0.421193, 0.290558, 0.153908],
    );
    assert_near(reflected("600:0.9 650:1"), [0.704019, 0.0, 0.0]);
    assert_near(reflected("300:1 900:1"), [0.998985, 0.998874, 0.998802]);
    let emitted = |value: &str| radiance(&named("radiance", value));
    assert_near(emitted("400:0.1, 700:0.5"), [0.496092, 0.27684, 0.135823]);
    assert_near(emitted("500:2 510:3"), [0.0, 0.179896, 0.0319814]);
    assert_near(
        emitted("400:0 500:8 600:15.6 700:18.4"),
        [20.7108, 10.8546, 2.77115],
    );
    let [eta, k] = indices(&(named("eta", METAL) + &named("k", "620:3 640:4")));
    assert_near(eta, [0.0452341, 0.585709, 1.33692]);
    assert_near(k, [0.936717, 0.0, 0.0]);
}

/// Objects that are spectra. In Mitsuba's `rgb` variants `regular` and `irregular` cannot be
/// evaluated; here they are the colours of their pairs.
#[test]
fn objects() {
    let refl = |plugin: &str, inside: &str| {
        reflectance(&format!(
            "<spectrum name=\"reflectance\" type=\"{plugin}\">{inside}</spectrum>"
        ))
    };
    let expected = [0.421193, 0.290558, 0.153908];
    let wavelengths = r#"<string name="wavelengths" value="400, 700"/>"#;
    let values = r#"<string name="values" value="0.1 0.5"/>"#;
    assert_near(
        refl("irregular", &format!("{wavelengths}{values}")),
        expected,
    );
    let range =
        r#"<float name="wavelength_min" value="400"/><float name="wavelength_max" value="700"/>"#;
    assert_near(refl("regular", &format!("{range}{values}")), expected);
    let pairs = r#"<spectrum name="value" value="400:0.1, 700:0.5"/>"#;
    assert_near(refl("regular", pairs), expected);
    let number = r#"<float name="value" value="0.3"/>"#;
    assert_near(refl("uniform", number), [0.3; 3]);
    assert_near(refl("rawconstant", number), [0.3; 3]);
    let vector = r#"<vector name="value" value="0.1, 0.2, 0.3"/>"#;
    assert_near(refl("rawconstant", vector), [0.1, 0.2, 0.3]);
    let colour = r#"<rgb name="color" value="0.1, 0.2, 0.3"/>"#;
    assert_near(refl("srgb", colour), [0.1, 0.2, 0.3]);
    let vector = r#"<vector name="color" value="0.1 0.2 0.3"/>"#;
    assert_near(refl("srgb", vector), [0.1, 0.2, 0.3]);
    let light = |plugin: &str, inside: &str| {
        radiance(&format!(
            "<spectrum name=\"radiance\" type=\"{plugin}\">{inside}</spectrum>"
        ))
    };
    // Objects are what they are, also flat ones in emitters.
    assert_near(light("uniform", number), [0.3; 3]);
    assert_near(light("d65", ""), [1.0; 3]);
    let scale = r#"<float name="scale" value="2"/>"#;
    assert_near(light("d65", &format!("{scale}{colour}")), [0.2, 0.4, 0.6]);
    let nested = format!("<texture type=\"uniform\">{number}</texture>");
    assert_near(light("d65", &nested), [0.3; 3]);
    assert_near(light("irregular", pairs), [0.496092, 0.27684, 0.135823]);
}

/// Mitsuba has black bodies in its `spectral` variants: expected are the values of its
/// plugin there, summed with its `cie1931_xyz` as it sums pairs.
#[test]
fn black_bodies() {
    for (temperature, expected) in [
        (
            2000,
            [16.014263153076172, 4.11186408996582, 0.1303918957710266],
        ),
        (5000, [15263.0244140625, 12082.5595703125, 9592.5615234375]),
        (10000, [158408.6875, 180718.078125, 260026.78125]),
    ] {
        let inside = format!(r#"<float name="temperature" value="{temperature}"/>"#);
        let light = |inside: &str| {
            radiance(&format!(
                "<spectrum name=\"radiance\" type=\"blackbody\">{inside}</spectrum>"
            ))
        };
        assert_near(light(&inside), expected);
        let scaled = format!(r#"{inside}<float name="scale" value="1e-3"/>"#);
        assert_near(light(&scaled), expected.map(|channel| 1e-3 * channel));
    }
}

/// A file has the same pairs, one a line.
#[test]
fn files() {
    let found = reflectance(r#"<spectrum name="reflectance" filename="ramp.spd"/>"#);
    assert_near(found, [0.421193, 0.290558, 0.153908]);
}

#[test]
fn what_is_wrong_with_spectra() {
    let refl = |inside: &str| scene(&format!("<bsdf type=\"diffuse\" id=\"m\">{inside}</bsdf>"));
    let pairs = "  expected two or more increasing wavelengths in nanometers, each with a value: 400:0.1, 700:0.5";
    for (inside, first, help) in [
        (
            r#"<spectrum name="reflectance" value="400:0.1"/>"#,
            "scene.xml:5:67: the spectrum has 1 wavelengths",
            pairs,
        ),
        (
            r#"<spectrum name="reflectance" value="400:0.1 500"/>"#,
            "scene.xml:5:67: \"500\" is not a wavelength and a value",
            pairs,
        ),
        (
            r#"<spectrum name="reflectance" value="400:0.1 300:nan"/>"#,
            "scene.xml:5:67: \"300:nan\" is not a wavelength and a value",
            pairs,
        ),
        (
            r#"<spectrum name="reflectance" value="400:0.1 300:1"/>"#,
            "scene.xml:5:67: the wavelength 300 stands behind 400",
            pairs,
        ),
        (
            r#"<spectrum name="reflectance" value="1" filename="a.spd"/>"#,
            "scene.xml:5:70: <spectrum> has both \"value\" and \"filename\"",
            "  keep one of them",
        ),
        (
            r#"<spectrum name="reflectance" filename="broken.spd"/>"#,
            "scene.xml:5:70: \"FOLDER/broken.spd\": line 3 is \"500 x\"",
            "  expected two or more lines with a wavelength in nanometers and a value, the wavelengths increasing",
        ),
        (
            r#"<spectrum name="reflectance" type="uniform"/>"#,
            "scene.xml:5:31: the texture \"uniform\" has no \"value\"",
            "  add <float name=\"value\" value=\"0.5\"/>",
        ),
        (
            r#"<spectrum name="reflectance" type="srgb"><rgb name="color" value="2"/></spectrum>"#,
            "scene.xml:5:97: \"color\" is (2, 2, 2)",
            "  expected numbers from 0 to 1: a surface cannot reflect more than it receives",
        ),
        (
            r#"<spectrum name="reflectance" type="srgb"><vector name="color" value="2"/></spectrum>"#,
            "scene.xml:5:100: \"color\" is (2, 2, 2)",
            "  expected numbers from 0 to 1: a surface cannot reflect more than it receives",
        ),
        (
            r#"<spectrum name="reflectance" type="blackbody"><float name="temperature" value="1"/></spectrum>"#,
            "scene.xml:5:31: a black body is used as a reflectance",
            "  it is the spectrum of an emitter",
        ),
        (
            r#"<spectrum name="reflectance" type="irregular"><string name="wavelengths" value="1 2 3"/><string name="values" value="1 2"/></spectrum>"#,
            "scene.xml:5:148: there are 3 wavelengths and 2 values",
            pairs,
        ),
    ] {
        check(&refl(inside), &[first, help]);
    }
}

/// The color of a spectrum depends on what it is for.
#[test]
fn one_spectrum_for_light_and_surfaces() {
    let text = scene(
        r#"<spectrum type="irregular" id="s"><spectrum name="value" value="400:0.1, 700:0.5"/></spectrum>
<shape type="cube"><bsdf type="diffuse"><ref name="reflectance" id="s"/></bsdf>
<emitter type="area"><ref name="radiance" id="s"/></emitter></shape>"#,
    );
    check(
        &text,
        &[
            "scene.xml:5:3: the spectrum is both light and what a surface does to light",
            "  write it twice: its color under daylight is another",
        ],
    );
}

/// Colours of a checkerboard are reflectances, also where it is what an emitter emits; `<rgb>`
/// may be bright there.
#[test]
fn checkerboards_hold_reflectances() {
    let colours = "<spectrum name=\"color0\" value=\"400:0.1, 500:0.7, 700:0.4\"/>\
                   <spectrum name=\"color1\" value=\"0.5\"/>";
    let board =
        |name: &str| format!("<texture name=\"{name}\" type=\"checkerboard\">{colours}</texture>");
    let of_light = format!(
        "<shape type=\"rectangle\"><emitter type=\"area\">{}</emitter></shape>",
        board("radiance")
    );
    let of_daylight = format!(
        "<shape type=\"rectangle\"><emitter type=\"area\"><spectrum name=\"radiance\" \
         type=\"d65\">{}</spectrum></emitter></shape>",
        board("nested")
    );
    let thrown = format!(
        "<emitter type=\"projector\">{}</emitter>",
        board("irradiance")
    );
    let shown = format!("<emitter type=\"spot\">{}</emitter>", board("texture"));
    let reflected = format!(
        "<shape type=\"rectangle\"><bsdf type=\"diffuse\">{}</bsdf></shape>",
        board("reflectance")
    );
    let board_of = |text: &str| {
        let scene = load(&scene(text));
        let mut boards = scene.textures.iter();
        let board = boards.find(|t| matches!(t.pattern, Pattern::Checkerboard { .. }));
        let board = board.expect("a checkerboard");
        [board.texel(0), board.texel(1)]
    };
    for text in [&of_light, &of_daylight, &thrown, &shown, &reflected] {
        let [first, second] = board_of(text);
        assert_near(first, [0.462849, 0.664294, 0.397962]);
        assert_near(second, [0.5; 3]);
    }
    // Mitsuba clamps what is measured, and takes one number above 1.
    let bright = of_light.replace("0.1, 500:0.7, 700:0.4", "5, 700:5");
    assert_near(board_of(&bright)[0], [1.0; 3]);
    let bright = of_light.replace(
        "<spectrum name=\"color1\" value=\"0.5\"/>",
        "<rgb name=\"color1\" value=\"5, 4, 3\"/>",
    );
    assert_near(board_of(&bright)[1], [5.0, 4.0, 3.0]);
}
