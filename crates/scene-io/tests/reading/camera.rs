//! Bad integrators, sensors, films, filters and samplers.

use crate::common::*;

#[test]
fn no_integrator() {
    check(
        &format!("{HEAD}{}", r#"<sensor type="perspective"/></scene>"#),
        &[
            "scene.xml:1:1: the scene has no integrator",
            "  add for example <integrator type=\"path\"/>",
        ],
    );
}

fn integrator(element: &str) -> String {
    format!("{HEAD}{element}<sensor type=\"perspective\"/></scene>")
}

#[test]
fn unknown_integrator() {
    check(
        &integrator(r#"<integrator type="pathh"/>"#),
        &[
            "scene.xml:2:19: unknown integrator plugin \"pathh\"",
            "  known integrator plugins: aov, direct, path",
            "  did you mean \"path\"?",
        ],
    );
    check(
        &integrator(r#"<integrator type="stokes"><integrator type="path"/></integrator>"#),
        &[
            "scene.xml:2:19: the integrator \"stokes\" is not supported",
            "  light has no polarization here; write its nested integrator without it",
        ],
    );
}

#[test]
fn integrators_without_an_image() {
    check(
        &integrator(r#"<integrator type="moment"/>"#),
        &[
            "scene.xml:2:1: the integrator \"moment\" has no integrator",
            "  put the integrator into it that makes the image",
        ],
    );
    let deep = r#"<integrator type="moment">"#.repeat(9) + &"</integrator>".repeat(9);
    check(
        &integrator(&deep),
        &[
            "scene.xml:2:209: integrators stand inside each other too deep",
            "  expected at most 8 inside each other",
        ],
    );
}

#[test]
fn media() {
    check(
        &scene(r#"<shape type="cube"><medium name="interior" type="homogeneous"/></shape>"#),
        &[
            "scene.xml:5:22: participating media are not rendered",
            "  light goes from surface to surface here; remove the <medium>",
        ],
    );
}

#[test]
fn shading_samples_twice() {
    check(
        &format!(
            "{HEAD}{}",
            r#"<integrator type="direct"><integer name="shading_samples" value="2"/><integer name="bsdf_samples" value="0"/></integrator><sensor type="perspective"/></scene>"#
        ),
        &[
            "scene.xml:2:66: \"shading_samples\" is given together with \"emitter_samples\" or \"bsdf_samples\"",
            "  it stands for both of them; keep either it or them",
        ],
    );
}

#[test]
fn no_samples() {
    check(
        &format!(
            "{HEAD}{}",
            r#"<integrator type="direct"><integer name="shading_samples" value="0"/></integrator><sensor type="perspective"/></scene>"#
        ),
        &[
            "scene.xml:2:1: the integrator \"direct\" takes neither emitter nor material samples",
            "  give at least one of emitter_samples and bsdf_samples",
        ],
    );
}

#[test]
fn depth_out_of_range() {
    check(
        &format!(
            "{HEAD}{}",
            r#"<integrator type="path"><integer name="max_depth" value="-2"/></integrator><sensor type="perspective"/></scene>"#
        ),
        &[
            "scene.xml:2:58: \"max_depth\" is -2",
            "  expected a whole number from -1 to 2147483647",
        ],
    );
}

#[test]
fn timeout() {
    check(
        &format!(
            "{HEAD}{}",
            r#"<integrator type="path"><float name="timeout" value="3"/></integrator><sensor type="perspective"/></scene>"#
        ),
        &[
            "scene.xml:2:54: \"timeout\" is 3",
            "  rendering until a time has passed is not reproducible; choose sample_count",
        ],
    );
}

#[test]
fn no_sensor() {
    check(
        &format!("{HEAD}{}", r#"<integrator type="path"/></scene>"#),
        &[
            "scene.xml:1:1: the scene has no sensor",
            "  add <sensor type=\"perspective\"> ... </sensor>",
        ],
    );
}

#[test]
fn unknown_sensor() {
    check(
        &format!(
            "{HEAD}{}",
            r#"<integrator type="path"/><sensor type="fisheye"/></scene>"#
        ),
        &[
            "scene.xml:2:40: unknown sensor plugin \"fisheye\"",
            "  known sensor plugins: perspective, thinlens, orthographic",
        ],
    );
}

/// A scene with a sensor of this plugin and these properties.
fn other_sensor(plugin: &str, properties: &str) -> String {
    sensor(properties).replace("\"perspective\"", &format!("\"{plugin}\""))
}

#[test]
fn lens_without_aperture() {
    check(
        &other_sensor("thinlens", ""),
        &[
            "scene.xml:3:3: a thin lens has no \"aperture_radius\"",
            "  add it, in world units; a perspective sensor has none",
        ],
    );
}

#[test]
fn lens_of_negative_radius() {
    check(
        &other_sensor("thinlens", r#"<float name="aperture_radius" value="-1"/>"#),
        &[
            "scene.xml:3:64: \"aperture_radius\" is -1",
            "  expected 0 or more",
        ],
    );
}

#[test]
fn lens_in_focus_nowhere() {
    check(
        &other_sensor(
            "thinlens",
            r#"<float name="aperture_radius" value="1"/><float name="focus_distance" value="0"/>"#,
        ),
        &[
            "scene.xml:3:104: \"focus_distance\" is 0",
            "  expected the depth that is sharp, above 0",
        ],
    );
}

#[test]
fn flat_orthographic_sensor() {
    check(
        &other_sensor(
            "orthographic",
            r#"<transform name="to_world"><scale x="0"/></transform>"#,
        ),
        &[
            "scene.xml:3:31: the \"to_world\" of a sensor cannot be inverted",
            "  scale by finite numbers other than 0",
        ],
    );
}

/// An orthographic sensor has no angle.
#[test]
fn orthographic_fov() {
    check(
        &other_sensor("orthographic", r#"<float name="fov" value="40"/>"#),
        &[
            "scene.xml:3:44: unknown property \"fov\" of the sensor \"orthographic\"",
            "  its properties are far_clip, focus_distance, near_clip, shutter_close, shutter_open, to_world",
        ],
    );
}

#[test]
fn fov_of_zero() {
    check(
        &sensor(r#"<float name="fov" value="0"/>"#),
        &[
            "scene.xml:3:55: \"fov\" is 0",
            "  expected an angle between 0 and 180 degrees",
        ],
    );
}

#[test]
fn fov_axis_unknown() {
    check(
        &sensor(r#"<float name="fov" value="40"/><string name="fov_axis" value="z"/>"#),
        &[
            "scene.xml:3:91: \"fov_axis\" is \"z\"",
            "  expected x, y, diagonal, smaller or larger",
        ],
    );
}

#[test]
fn fov_axis_without_fov() {
    check(
        &sensor(r#"<string name="fov_axis" value="y"/>"#),
        &[
            "scene.xml:3:61: \"fov_axis\" is given without \"fov\"",
            "  focal lengths refer to the diagonal; remove it, or give fov",
        ],
    );
}

#[test]
fn fov_and_focal_length() {
    check(
        &sensor(r#"<float name="fov" value="40"/><string name="focal_length" value="50mm"/>"#),
        &[
            "scene.xml:3:95: both \"fov\" and \"focal_length\" are given",
            "  keep one of them",
        ],
    );
}

#[test]
fn focal_length_unreadable() {
    check(
        &sensor(r#"<string name="focal_length" value="long"/>"#),
        &[
            "scene.xml:3:65: \"focal_length\" is \"long\"",
            "  expected millimetres above 0, such as 50mm",
        ],
    );
}

#[test]
fn sensor_with_scale() {
    check(
        &sensor(r#"<transform name="to_world"><scale value="2"/></transform>"#),
        &[
            "scene.xml:3:30: the \"to_world\" of a sensor scales or shears",
            "  expected a rotation and a translation; fov sets how much is seen",
        ],
    );
}

#[test]
fn clip_planes_crossed() {
    check(
        &sensor(r#"<float name="near_clip" value="5"/><float name="far_clip" value="2"/>"#),
        &[
            "scene.xml:3:61: \"near_clip\" is 5 and \"far_clip\" is 2",
            "  expected 0 < near_clip < far_clip",
        ],
    );
}

#[test]
fn spectral_response() {
    check(
        &sensor(r#"<spectrum name="srf" value="1"/>"#),
        &[
            "scene.xml:3:46: \"srf\" is not supported",
            "  light is computed in red, green and blue, without spectral response functions",
        ],
    );
}

#[test]
fn unknown_sampler() {
    check(
        &sensor(r#"<sampler type="halton"/>"#),
        &[
            "scene.xml:3:45: unknown sampler plugin \"halton\"",
            "  known sampler plugins: independent, ldsampler, sobol",
        ],
    );
}

#[test]
fn no_samples_per_pixel() {
    check(
        &sensor(
            r#"<sampler type="independent"><integer name="sample_count" value="0"/></sampler>"#,
        ),
        &[
            "scene.xml:3:94: \"sample_count\" is 0",
            "  expected a whole number from 1 to 4294967295",
        ],
    );
}

#[test]
fn unknown_film() {
    check(
        &sensor(r#"<film type="ldrfilm"/>"#),
        &[
            "scene.xml:3:42: unknown film plugin \"ldrfilm\"",
            "  known film plugins: hdrfilm",
            "  did you mean \"hdrfilm\"?",
        ],
    );
}

#[test]
fn image_of_no_pixels() {
    check(
        &film(r#"<integer name="width" value="0"/><integer name="height" value="48"/>"#),
        &[
            "scene.xml:3:80: the image has 0 x 48 pixels; expected at least 1 x 1 and at most 67108864 in all",
        ],
    );
}

#[test]
fn image_of_too_many_pixels() {
    check(
        &film(r#"<integer name="width" value="100000"/><integer name="height" value="10000"/>"#),
        &[
            "scene.xml:3:30: the image has 100000 x 10000 pixels; expected at least 1 x 1 and at most 67108864 in all",
        ],
    );
}

#[test]
fn image_of_negative_size() {
    check(
        &film(r#"<integer name="width" value="-3"/>"#),
        &[
            "scene.xml:3:80: \"width\" is -3",
            "  expected a whole number from 0 to 4294967295",
        ],
    );
}

#[test]
fn crop_outside() {
    check(
        &film(
            r#"<integer name="width" value="40"/><integer name="crop_offset_x" value="20"/><integer name="crop_width" value="30"/>"#,
        ),
        &[
            "scene.xml:3:161: film.crop_width is 50 (offset included); expected a crop window inside the film",
        ],
    );
}

#[test]
fn unknown_filter() {
    check(
        &film(r#"<rfilter type="sinc"/>"#),
        &[
            "scene.xml:3:66: unknown rfilter plugin \"sinc\"",
            "  known rfilter plugins: box, tent, gaussian, mitchell, catmullrom, lanczos",
        ],
    );
}

#[test]
fn filters_out_of_range() {
    check(
        &film(r#"<rfilter type="mitchell"><float name="C" value="1.5"/></rfilter>"#),
        &["scene.xml:3:99: rfilter.C is 1.5; expected a number from 0 to 1"],
    );
    check(
        &film(r#"<rfilter type="lanczos"><integer name="lobes" value="0"/></rfilter>"#),
        &[
            "scene.xml:3:104: \"lobes\" is 0",
            "  expected a whole number from 1 to 4294967295",
        ],
    );
}

#[test]
fn filter_of_no_width() {
    check(
        &film(r#"<rfilter type="tent"><float name="radius" value="0"/></rfilter>"#),
        &[
            "scene.xml:3:100: rfilter.radius is 0; expected a number of pixels above 0 and below 100",
        ],
    );
}

#[test]
fn unknown_pixel_format() {
    check(
        &film(r#"<string name="pixel_format" value="cmyk"/>"#),
        &[
            "scene.xml:3:86: \"cmyk\" is not a pixel_format of Mitsuba's",
            "  expected one of luminance, luminance_alpha, rgb, rgba, xyz, xyza",
        ],
    );
}

#[test]
fn border_of_mitsuba_2() {
    check(
        &film(r#"<boolean name="high_quality_edges" value="true"/>"#),
        &[
            "scene.xml:3:66: \"high_quality_edges\" is not supported",
            "  Mitsuba 3 calls it sample_border",
        ],
    );
}

/// Sensors that are not rendered are read strictly, too.
#[test]
fn mistake_in_another_sensor() {
    check(
        &scene(r#"<sensor type="perspective"><float name="fow" value="3"/></sensor>"#),
        &[
            "scene.xml:5:43: unknown property \"fow\" of the sensor \"perspective\"",
            "  its properties are far_clip, focal_length, focus_distance, fov, fov_axis, near_clip, principal_point_offset_x, principal_point_offset_y, shutter_close, shutter_open, to_world",
            "  did you mean \"fov\"?",
        ],
    );
}

/// Parts of sensors may stand in the scene, to be referred to.
#[test]
fn film_and_sampler_by_reference() {
    let text = sensor("<ref id=\"film\"/><ref id=\"sampler\"/>").replace(
        "</scene>",
        "<film type=\"hdrfilm\" id=\"film\"><integer name=\"width\" value=\"7\"/></film>\
         <sampler type=\"sobol\" id=\"sampler\"/></scene>",
    );
    let scene = load(&text);
    assert_eq!(scene.film.size, [7, 576]);
    assert_eq!(scene.settings.sampler, capwalk_scene::SamplerKind::Sobol);
}
