//! Files for old versions of Mitsuba mean what they mean under today's names.

use crate::common::*;

const OLD: &str = r#"<scene version="0.6.0"><default name="mySamples" value="7"/>
<default name="shift" value="0.25"/>
<integrator type="path"><integer name="maxDepth" value="5"/><integer name="rrDepth" value="3"/></integrator>
<sensor type="perspective"><float name="nearClip" value="0.5"/><string name="fovAxis" value="y"/>
<float name="fov" value="30"/><transform name="toWorld"><lookAt origin="0 0 5" target="0 0 0" up="0 1 0"/></transform>
<sampler type="independent"><integer name="sampleCount" value="$mySamples"/></sampler>
<film type="ldrfilm"><integer name="width" value="40"/><integer name="height" value="30"/>
<float name="gamma" value="2.2"/><string name="fileFormat" value="png"/><rfilter type="tent"/></film></sensor>
<bsdf type="diffuse" id="wood"><texture name="diffuseReflectance" type="bitmap">
<string name="filename" value="texels.png"/><string name="filterType" value="nearest"/>
<float name="gamma" value="1.0"/><float name="maxAnisotropy" value="8"/><float name="uscale" value="2"/><float name="vscale" value="3"/>
<float name="uoffset" value="0.5"/><float name="voffset" value="$shift"/></texture></bsdf>
<bsdf type="dielectric" id="glass"><float name="intIOR" value="1.4"/></bsdf>
<bsdf type="conductor" id="mirror"><string name="extEta" value="air"/></bsdf>
<texture type="bitmap" id="leaf"><string name="filename" value="texels.png"/>
<string name="filterType" value="trilinear"/><float name="gamma" value="-1"/></texture>
<bsdf type="diffuse" id="leafy"><ref name="reflectance" id="leaf"/></bsdf>
<shape type="rectangle"><boolean name="flipNormals" value="true"/><ref id="wood"/></shape>
<shape type="cube"><ref id="mirror"/></shape><shape type="disk"><ref id="leafy"/></shape>
<emitter type="constant"/></scene>"#;

const NEW: &str = r#"<scene version="3.0.0">
<integrator type="path"><integer name="max_depth" value="5"/><integer name="rr_depth" value="3"/></integrator>
<sensor type="perspective"><float name="near_clip" value="0.5"/><string name="fov_axis" value="y"/>
<float name="fov" value="30"/><transform name="to_world"><lookat origin="0 0 5" target="0 0 0" up="0 1 0"/></transform>
<sampler type="independent"><integer name="sample_count" value="7"/></sampler>
<film type="hdrfilm"><integer name="width" value="40"/><integer name="height" value="30"/>
<rfilter type="tent"/></film></sensor>
<bsdf type="diffuse" id="wood"><texture name="reflectance" type="bitmap">
<string name="filename" value="texels.png"/><string name="filter_type" value="nearest"/>
<boolean name="raw" value="true"/><transform name="to_uv"><translate x="0.5" y="0.25"/><scale x="2" y="3"/></transform></texture></bsdf>
<bsdf type="dielectric" id="glass"><float name="int_ior" value="1.4"/></bsdf>
<bsdf type="conductor" id="mirror"/>
<texture type="bitmap" id="leaf"><string name="filename" value="texels.png"/></texture>
<bsdf type="diffuse" id="leafy"><ref name="reflectance" id="leaf"/></bsdf>
<shape type="rectangle"><boolean name="flip_normals" value="true"/><ref id="wood"/></shape>
<shape type="cube"><ref id="mirror"/></shape><shape type="disk"><ref id="leafy"/></shape>
<emitter type="constant"/></scene>"#;

#[test]
fn old_names_mean_what_the_new_ones_do() {
    let (old, new) = (load(OLD), load(NEW));
    assert_eq!(old.textures, new.textures);
    assert_eq!(old, new);
}

/// What is read otherwise than it is written is in the warning.
#[test]
fn the_warning_lists_what_was_changed() {
    let (_, warnings) = load_with_warnings(OLD);
    for change in [
        "trilinear is now bilinear",
        "gamma -1 is now raw false",
        "gamma 1.0 is now raw true",
        "max_anisotropy left out",
        "ext_eta left out",
    ] {
        assert!(warnings.join("\n").contains(change), "{warnings:?}");
    }
}

/// What cannot be brought to today's names is refused.
#[test]
fn old_numbers_that_mean_something_else() {
    for (old, other, expected) in [
        (
            "\"gamma\" value=\"1.0\"",
            "\"gamma\" value=\"1.8\"",
            "\"gamma\" is not supported",
        ),
        (
            "\"air\"",
            "\"water\"",
            "\"extEta\" (now \"ext_eta\") is not supported",
        ),
        ("\"trilinear\"", "\"cubic\"", "\"filter_type\" is \"cubic\""),
    ] {
        let message = message(&OLD.replace(old, other), &[]);
        assert!(message.contains(expected), "{message}");
    }
}

/// What to do instead follows from what is given.
#[test]
fn metals_in_other_surroundings() {
    let with = |inside: &str| {
        let metal =
            "<bsdf type=\"conductor\" id=\"mirror\"><string name=\"extEta\" value=\"air\"/>";
        let text = OLD.replace(
            metal,
            &metal
                .replace("air", "water")
                .replace("<string", &format!("{inside}<string")),
        );
        message(&text, &[])
    };
    let error = with("<rgb name=\"eta\" value=\"0.2, 0.9, 1.1\"/>");
    assert!(error.contains("divide eta and k by it"), "{error}");
    let error = with("<string name=\"material\" value=\"Au\"/>");
    let expected = "remove it and the material, and write <rgb name=\"eta\" value=\"";
    assert!(error.contains(expected), "{error}");
}

/// Only files for old versions may use old names.
#[test]
fn new_files_have_new_names() {
    let text = OLD.replace("0.6.0", "3.0.0");
    let message = message(&text, &[]);
    assert!(message.contains("did you mean \"lookat\"?"), "{message}");
}

/// What is wrong in an old file stays wrong, at its place.
#[test]
fn errors_in_old_files_have_their_place() {
    let text = OLD.replace("\"rrDepth\"", "\"rrDepht\"");
    assert!(
        message(&text, &[])
            .starts_with("scene.xml:3:76: unknown property \"rrDepht\" (now \"rr_depht\") of")
    );
    let text = OLD.replace("\"uscale\" value", "\"uscale\" valeu");
    let message = message(&text, &[]);
    assert!(message.starts_with("scene.xml:11:"), "{message}");
}
