//! Differences of parameters that are at the end of what they can be.

use crate::{Capwalk, assert_has};

/// A sheet in front of a wall, with a material of this opacity and reflectance.
fn sheet(opacity: &str, reflectance: &str) -> String {
    format!(
        r#"<scene version="3.0.0"><integrator type="path"><integer name="max_depth" value="4"/></integrator>
<sensor type="perspective"><float name="fov" value="40"/>
<transform name="to_world"><lookat origin="0.1, -3.4, 1.3" target="0, 0, 0.75" up="0.05, 0, 1"/></transform>
<film type="hdrfilm"><integer name="width" value="16"/><integer name="height" value="12"/><rfilter type="tent"/></film>
<sampler type="independent"><integer name="sample_count" value="256"/></sampler></sensor>
<shape type="rectangle" id="wall"><transform name="to_world"><scale value="3"/><rotate x="1" angle="90"/><translate y="1"/></transform>
<bsdf type="diffuse"><rgb name="reflectance" value="0.6, 0.5, 0.4"/></bsdf></shape>
<shape type="rectangle" id="sheet"><transform name="to_world"><scale value="0.6"/><rotate x="1" angle="80"/><translate z="0.7"/></transform>
<bsdf type="mask"><float name="opacity" value="{opacity}"/>
<bsdf type="twosided"><bsdf type="diffuse"><rgb name="reflectance" value="{reflectance}"/></bsdf></bsdf></bsdf></shape>
<emitter type="constant"><rgb name="radiance" value="1, 0.8, 0.6"/></emitter></scene>"#
    )
}

/// Black becomes no darker, and what is opaque no more so: one side is taken there, and said.
#[test]
fn at_the_end_one_side_is_taken() {
    let capwalk = Capwalk::new("one_sided");
    for (opacity, reflectance, parameter, sides) in [
        ("1", "0.5, 0.5, 0.5", "sheet.bsdf.opacity", "below"),
        ("0", "0.5, 0.5, 0.5", "sheet.bsdf.opacity", "above"),
        (
            "0.7",
            "0, 0.3, 0.6",
            "sheet.bsdf.reflectance.value",
            "above",
        ),
        (
            "0.7",
            "0.3, 0.4, 0.5",
            "sheet.bsdf.reflectance.value",
            "both",
        ),
    ] {
        capwalk.write("sheet.xml", &sheet(opacity, reflectance));
        let command = format!("check sheet.xml -p {parameter}");
        let found = capwalk.run(&format!("{command} --json"));
        let json: serde_json::Value = serde_json::from_str(&found.stdout).expect("JSON");
        assert_eq!(
            json["sides"], sides,
            "{parameter} of {opacity}, {reflectance}"
        );
        let verdict = json["comparison"]["verdict"].as_str().expect("a word");
        // Differences of opacities are rare events, and noisy.
        let is_noisy = parameter.ends_with("opacity");
        assert!(
            verdict == "right" || is_noisy && verdict == "inconclusive",
            "{json}"
        );
        let expected = match sides {
            "both" => "central differences over ± ",
            "above" => "one-sided differences over + ",
            _ => "one-sided differences over - ",
        };
        assert_has(
            &capwalk.run(&format!("{command} --spp 4")).stdout,
            &[expected],
        );
    }
}

/// One number can only rise, another only fall.
#[test]
fn neither_side_is_refused() {
    let capwalk = Capwalk::new("neither_side");
    capwalk.write("sheet.xml", &sheet("0", "0, 0, 0"));
    let message =
        capwalk.error("check sheet.xml -p sheet.bsdf.opacity-sheet.bsdf.reflectance.value --spp 4");
    assert_has(&message, &["on both sides", "one of them at a time"]);
}
