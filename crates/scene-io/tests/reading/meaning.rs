//! What properties mean. Numbers with many digits are what Mitsuba 3.9.1
//! (scalar_rgb) makes of the same text.

use std::f64::consts::PI;

use capwalk_math::{Rgb, Vec3};
use capwalk_scene::lobe::{Diffuse, Lobe};
use capwalk_scene::{
    Bsdf, Film, Filter, Integrator, Optic, SamplerKind, Scene, SensorModel, Settings,
    ShadingNormals,
};

use crate::common::*;

/// The images of the axes and of the origin under a transform, rounded as
/// Mitsuba's single precision is.
fn transform(steps: &str) -> [[f64; 4]; 3] {
    let text = scene(&format!(
        "<shape type=\"cube\"><transform name=\"to_world\">{steps}</transform></shape>"
    ));
    let corners = load(&text).shapes[0].mesh.positions.clone();
    let axis = |bit: usize| (corners[1 << bit] - corners[0]) * 0.5;
    let origin = (corners[0] + corners[7]) * 0.5;
    let columns = [axis(0), axis(1), axis(2), origin];
    [0, 1, 2].map(|row| columns.map(|column| column[row]))
}

fn assert_transform(steps: &str, expected: [[f64; 4]; 3]) {
    let found = transform(steps);
    let numbers = found.iter().flatten().zip(expected.iter().flatten());
    let worst = numbers.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(worst < 2e-6, "{steps}: {found:?}");
}

#[test]
fn transforms_act_in_the_order_of_the_text() {
    assert_transform(
        "<translate x=\"1\" y=\"2\"/><rotate y=\"1\" angle=\"30\"/><scale x=\"2\"/>",
        [
            [1.732051, 0.0, 1.0, 1.732051],
            [0.0, 1.0, 0.0, 2.0],
            [-0.5, 0.0, 0.866025, -0.5],
        ],
    );
    assert_transform(
        "<scale value=\"2, 3 4\"/><translate value=\"0.5 1 -1\"/>",
        [
            [2.0, 0.0, 0.0, 0.5],
            [0.0, 3.0, 0.0, 1.0],
            [0.0, 0.0, 4.0, -1.0],
        ],
    );
}

#[test]
fn rotations_are_counter_clockwise_in_degrees() {
    assert_transform(
        "<rotate value=\"0 0.6 0.8\" angle=\"-40\"/>",
        [
            [0.766044, 0.514230, -0.385673, 0.0],
            [-0.514230, 0.850268, 0.112299, 0.0],
            [0.385673, 0.112299, 0.915776, 0.0],
        ],
    );
}

#[test]
fn look_at_with_and_without_up() {
    assert_transform(
        "<lookat origin=\"1, 2, 3\" target=\"0, 0, 0\" up=\"0, 1, 0\"/>",
        [
            [-0.948683, -0.169031, -0.267261, 1.0],
            [0.0, 0.845154, -0.534522, 2.0],
            [0.316228, -0.507093, -0.801784, 3.0],
        ],
    );
    let without = [
        [0.209547, 0.930151, -0.301511, 1.0],
        [-0.371360, -0.209547, -0.904534, 2.0],
        [-0.904534, 0.301511, 0.301511, 3.0],
    ];
    assert_transform("<lookat origin=\"1 2 3\" target=\"0 -1 4\"/>", without);
    let zero = "<lookat origin=\"1 2 3\" target=\"0 -1 4\" up=\"0 0 0\"/>";
    assert_transform(zero, without);
    assert_transform(
        "<lookat origin=\"0 0 0\" target=\"0.6 0.64 -0.48\"/>",
        [
            [-0.259459, 0.756757, 0.6, 0.0],
            [0.723243, -0.259459, 0.64, 0.0],
            [0.64, 0.6, -0.48, 0.0],
        ],
    );
}

#[test]
fn matrices_are_given_row_by_row() {
    let rows = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 10.0]];
    let with = |t: [f64; 3]| [0, 1, 2].map(|i| [rows[i][0], rows[i][1], rows[i][2], t[i]]);
    assert_transform("<matrix value=\"1 2 3 4 5 6 7 8 10\"/>", with([0.0; 3]));
    assert_transform(
        "<matrix value=\"1 2 3 -1, 4 5 6 -2, 7 8 10 -3, 0 0 0 1\"/>",
        with([-1.0, -2.0, -3.0]),
    );
}

/// Of a film of 60 by 40 pixels.
fn fov_degrees(properties: &str) -> f64 {
    let film = "<film type=\"hdrfilm\"><integer name=\"width\" value=\"60\"/>\
                <integer name=\"height\" value=\"40\"/></film>";
    let scene = load(&sensor(&format!("{film}{properties}")));
    let fov_x = scene.sensor.model.optic(Optic::FovX);
    fov_x.expect("it has one").to_degrees()
}

#[test]
fn fields_of_view_along_every_axis() {
    let along = |axis: &str| {
        fov_degrees(&format!(
            "<float name=\"fov\" value=\"50\"/><string name=\"fov_axis\" value=\"{axis}\"/>"
        ))
    };
    for (axis, expected) in [
        ("x", 50.0),
        ("y", 69.942611),
        ("diagonal", 42.411652),
        ("smaller", 69.942611),
        ("larger", 50.0),
        ("Y", 69.942611),
    ] {
        assert!((along(axis) - expected).abs() < 1e-4, "{axis}");
    }
    assert!((fov_degrees("<integer name=\"fov\" value=\"50\"/>") - 50.0).abs() < 1e-12);
    assert!((fov_degrees("") - 39.597752).abs() < 1e-4);
    let focal = "<string name=\"focal_length\" value=\"35mm\"/>";
    assert!((fov_degrees(focal) - 54.432224).abs() < 1e-4);
}

/// A ray of Mitsuba's through a point of the film, with a principal point that
/// is not in the middle.
#[test]
fn principal_point_and_handedness() {
    let film = "<film type=\"hdrfilm\"><integer name=\"width\" value=\"60\"/>\
                <integer name=\"height\" value=\"40\"/></film>";
    let scene = load(&sensor(&format!(
        "{film}<float name=\"fov\" value=\"50\"/>\
         <float name=\"principal_point_offset_x\" value=\"0.1\"/>\
         <float name=\"principal_point_offset_y\" value=\"-0.2\"/>"
    )));
    let view = scene.sensor.view(&scene.film);
    let d = view.direction([0.1 * 60.0, 0.3 * 40.0]);
    assert!((d - Vec3::new(0.262027, 0.232913, 0.936532)).length() < 2e-6);
}

/// What a lens is in focus on where nothing says it, and that it has no
/// rounded rotation either.
#[test]
fn lenses_are_those_of_mitsuba() {
    let text =
        sensor("<float name=\"fov\" value=\"50\"/><float name=\"aperture_radius\" value=\"0.3\"/>");
    let scene = load(&text.replace("\"perspective\"", "\"thinlens\""));
    assert_eq!(
        scene.sensor.model,
        SensorModel::ThinLens {
            fov_x: scene.sensor.model.optic(Optic::FovX).expect("it has one"),
            aperture_radius: 0.3,
            focus_distance: 1e4,
        }
    );
}

/// The film of an orthographic sensor is two units wide, times the scale.
#[test]
fn orthographic_films_scale() {
    let text = sensor(
        "<film type=\"hdrfilm\"><integer name=\"width\" value=\"60\"/>\
         <integer name=\"height\" value=\"40\"/></film>\
         <transform name=\"to_world\"><scale x=\"3\" y=\"3\" z=\"2\"/></transform>",
    );
    let scene = load(&text.replace("\"perspective\"", "\"orthographic\""));
    let view = scene.sensor.view(&scene.film);
    let ray = view.ray(view.direction([0.0, 0.0]));
    assert!((ray.origin - Vec3::new(3.0, 2.0, 0.0)).length() < 1e-12);
    assert_eq!(ray.direction, Vec3::new(0.0, 0.0, 1.0));
    // The near plane scales, the distance between the planes does not.
    assert_eq!(ray.range, [0.02, 0.02 + (1e4 - 0.01)]);
}

/// Four digits are not quite a rotation; what is made of them is one.
#[test]
fn rounded_sensor_matrices_become_rigid() {
    let scene = load(&sensor(
        "<transform name=\"to_world\"><matrix value=\"0.8661 0 0.4999 1 0 1 0.0005 2 -0.4999 0 0.8661 3 \
         0 0 0 1\"/></transform>",
    ));
    let m = scene.sensor.world_from_camera;
    for (i, row) in m.rows.iter().enumerate() {
        assert!((row.length() - 1.0).abs() < 1e-15);
        assert!(row.dot(m.rows[(i + 1) % 3]).abs() < 1e-15);
    }
    let forward = Vec3::new(0.4999, 0.0005, 0.8661).normalized();
    assert!((m.vector(Vec3::new(0.0, 0.0, 1.0)) - forward).length() < 1e-15);
    assert_eq!(m.translation, Vec3::new(1.0, 2.0, 3.0));
    let mirrored = load(&sensor(
        "<transform name=\"to_world\"><scale x=\"-1\"/></transform>",
    ));
    assert_eq!(mirrored.sensor.world_from_camera.determinant(), -1.0);
}

#[test]
fn defaults_are_those_of_mitsuba() {
    let scene = load(&sensor(""));
    assert_eq!((scene.sensor.near_clip, scene.sensor.far_clip), (1e-2, 1e4));
    let filter = Filter::Gaussian { stddev: 0.5 };
    assert_eq!(scene.film, Film::new(768, 576, filter));
    assert_eq!(
        scene.settings,
        Settings {
            integrator: Integrator::Path {
                max_depth: None,
                rr_depth: 5,
                hide_emitters: false,
            },
            spp: 4,
            sampler: SamplerKind::Independent,
            seed: 0,
        }
    );
    let direct = load(&sensor("").replace("\"path\"", "\"direct\""));
    let expected = Integrator::Direct {
        emitter_samples: 1,
        bsdf_samples: 1,
        hide_emitters: false,
    };
    assert_eq!(direct.settings.integrator, expected);
}

#[test]
fn integrators_and_samplers_are_set() {
    let text = sensor(
        "<sampler type=\"ldsampler\"><integer name=\"sample_count\" value=\"64\"/>\
         <integer name=\"seed\" value=\"7\"/></sampler>",
    );
    let with =
        |integrator: &str| load(&text.replace("<integrator type=\"path\"/>", integrator)).settings;
    let settings = with(
        "<integrator type=\"path\"><integer name=\"max_depth\" value=\"3\"/>\
         <integer name=\"rr_depth\" value=\"9\"/>\
         <boolean name=\"hide_emitters\" value=\"true\"/></integrator>",
    );
    let expected = Integrator::Path {
        max_depth: Some(3),
        rr_depth: 9,
        hide_emitters: true,
    };
    assert_eq!(settings.integrator, expected);
    assert_eq!((settings.spp, settings.seed), (64, 7));
    assert_eq!(settings.sampler, SamplerKind::Sobol);
    let settings = with(
        "<integrator type=\"direct\"><integer name=\"emitter_samples\" value=\"2\"/>\
         <integer name=\"bsdf_samples\" value=\"0\"/></integrator>",
    );
    let expected = Integrator::Direct {
        emitter_samples: 2,
        bsdf_samples: 0,
        hide_emitters: false,
    };
    assert_eq!(settings.integrator, expected);
}

/// Mitsuba's integrators of derivatives stand for the images that they make,
/// with its defaults for them.
#[test]
fn integrators_of_derivatives_are_read_as_those_of_their_images() {
    let with = |plugin: &str, properties: &str| {
        let integrator = format!("<integrator type=\"{plugin}\">{properties}</integrator>");
        let text = sensor("").replace("<integrator type=\"path\"/>", &integrator);
        load(&text).settings.integrator
    };
    let depths =
        "<integer name=\"max_depth\" value=\"3\"/><integer name=\"rr_depth\" value=\"9\"/>";
    let hidden = "<boolean name=\"hide_emitters\" value=\"true\"/>";
    for plugin in ["prb", "prb_basic", "prb_projective", "prb_reparam"] {
        let path = |max_depth, rr_depth, hide_emitters| Integrator::Path {
            max_depth: Some(max_depth),
            rr_depth,
            hide_emitters,
        };
        assert_eq!(with(plugin, ""), path(6, 5, false));
        assert_eq!(with(plugin, depths), path(3, 9, false));
        assert_eq!(with(plugin, hidden), path(6, 5, true));
    }
    for plugin in ["direct_projective", "direct_reparam"] {
        let expected = Integrator::Direct {
            emitter_samples: 1,
            bsdf_samples: 1,
            hide_emitters: true,
        };
        assert_eq!(with(plugin, &format!("{depths}{hidden}")), expected);
    }
    let knobs = "<integer name=\"sppc\" value=\"1\"/><string name=\"guiding\" value=\"grid\"/>";
    assert_eq!(with("prb_projective", knobs), with("prb_projective", ""));
    let unbounded = with("path", "<boolean name=\"strict_normals\" value=\"false\"/>");
    assert_eq!(unbounded, load(&sensor("")).settings.integrator);
}

#[test]
fn stratified_samplers_are_read_as_sobol() {
    for plugin in ["multijitter", "orthogonal", "stratified"] {
        let scene = load(&sensor(&format!("<sampler type=\"{plugin}\"/>")));
        assert_eq!(scene.settings.sampler, SamplerKind::Sobol);
    }
}

#[test]
fn films_have_crops_filters_and_borders() {
    let scene = load(&film(
        "<integer name=\"width\" value=\"60\"/><integer name=\"height\" value=\"40\"/>\
         <integer name=\"crop_offset_x\" value=\"7\"/><integer name=\"crop_offset_y\" value=\"9\"/>\
         <integer name=\"crop_width\" value=\"20\"/><integer name=\"crop_height\" value=\"10\"/>\
         <boolean name=\"sample_border\" value=\"true\"/>\
         <rfilter type=\"tent\"><float name=\"radius\" value=\"1.5\"/></rfilter>",
    ));
    let expected = Film {
        size: [60, 40],
        crop_offset: [7, 9],
        crop_size: [20, 10],
        filter: Filter::Tent { radius: 1.5 },
        sample_border: true,
    };
    assert_eq!(scene.film, expected);
    let filter = |text: &str| load(&film(text)).film.filter;
    assert_eq!(
        filter("<rfilter type=\"tent\"/>"),
        Filter::Tent { radius: 1.0 }
    );
    assert_eq!(filter("<rfilter type=\"box\"/>"), Filter::Box);
    assert_eq!(
        filter("<rfilter type=\"gaussian\"><float name=\"stddev\" value=\"0.4\"/></rfilter>"),
        Filter::Gaussian { stddev: 0.4 }
    );
    assert_eq!(
        filter("<rfilter type=\"mitchell\"><float name=\"B\" value=\"0.2\"/></rfilter>"),
        Filter::Mitchell {
            b: 0.2,
            c: 1.0 / 3.0
        }
    );
    assert_eq!(
        filter("<rfilter type=\"catmullrom\"/>"),
        Filter::Mitchell { b: 0.0, c: 0.5 }
    );
    assert_eq!(
        filter("<rfilter type=\"lanczos\"/>"),
        Filter::Lanczos { lobes: 3 }
    );
}

fn reflectance(value: &str) -> Rgb {
    let scene = load(&scene(&format!(
        "<shape type=\"cube\"><bsdf type=\"diffuse\">{value}</bsdf></shape>"
    )));
    match &scene.material(scene.shapes[0].bsdf).bsdf {
        Bsdf::Plain(Lobe::Diffuse(Diffuse { reflectance })) => scene.texture(*reflectance).texel(0),
        other => panic!("{other:?}"),
    }
}

/// Mitsuba distorts by axes that are not of length 1: its matrix for this text.
#[test]
fn long_axes_of_rotations() {
    assert_transform(
        r#"<rotate x="1" z="1" angle="30"/>"#,
        [
            [1.0, -0.5, 0.133975, 0.0],
            [0.5, 0.866025, -0.5, 0.0],
            [0.133975, 0.5, 1.0, 0.0],
        ],
    );
}

/// Other integrators of the same image, and those that only add channels to one.
#[test]
fn integrators_that_make_the_image_of_others() {
    let with = |integrator: &str| {
        let text = format!("{HEAD}{integrator}<sensor type=\"perspective\"/></scene>");
        load(&text).settings.integrator
    };
    let path = |max_depth| Integrator::Path {
        max_depth,
        rr_depth: 5,
        hide_emitters: false,
    };
    for plugin in ["bdpt", "mlt", "ptracer", "volpath", "volpathmis"] {
        let text = |inside: &str| format!("<integrator type=\"{plugin}\">{inside}</integrator>");
        assert_eq!(with(&text("")), path(None));
        let depth = r#"<integer name="max_depth" value="3"/>"#;
        assert_eq!(with(&text(depth)), path(Some(3)));
    }
    assert_eq!(with(r#"<integrator type="prbvolpath"/>"#), path(Some(6)));
    let depth = Integrator::Aov(capwalk_scene::Aov::Depth);
    assert_eq!(with(r#"<integrator type="depth"/>"#), depth);
    let nested = r#"<integrator type="path"/><integrator type="direct"/>"#;
    for wrapper in [
        format!("<integrator type=\"moment\">{nested}</integrator>"),
        format!(
            "<integrator type=\"aov\"><string name=\"aovs\" value=\"d:depth,n:uv\"/>{nested}</integrator>"
        ),
    ] {
        assert_eq!(with(&wrapper), path(None));
    }
}

fn radiance(value: &str) -> Rgb {
    let text = format!(
        "{HEAD}<integrator type=\"path\"/><sensor type=\"perspective\"/>\
         <emitter type=\"constant\">{value}</emitter></scene>"
    );
    let scene = load(&text);
    scene.texture(scene.emitters[0].radiance()).texel(0)
}

#[test]
fn reflectances() {
    assert_eq!(reflectance(""), Rgb::splat(0.5));
    let named = |tag: &str, value: &str| {
        reflectance(&format!("<{tag} name=\"reflectance\" value=\"{value}\"/>"))
    };
    assert_eq!(named("rgb", "0.1, 0.2 0.3"), Rgb::new(0.1, 0.2, 0.3));
    assert_eq!(named("rgb", "0.4"), Rgb::splat(0.4));
    assert_eq!(named("float", "0.4"), Rgb::splat(0.4));
    assert_eq!(named("integer", "1"), Rgb::splat(1.0));
    assert_eq!(named("spectrum", "0.4"), Rgb::splat(0.4));
    // 0x80 is 0.2158605 in linear light, 0x0a is on the straight part.
    let hex = named("rgb", "#ff800a");
    assert!((hex - Rgb::new(1.0, 0.215860500, 0.003035270)).length() < 1e-9);
}

#[test]
fn radiances() {
    assert_eq!(radiance(""), Rgb::splat(1.0));
    let named =
        |tag: &str, value: &str| radiance(&format!("<{tag} name=\"radiance\" value=\"{value}\"/>"));
    assert_eq!(named("rgb", "1, 2, 30"), Rgb::new(1.0, 2.0, 30.0));
    assert_eq!(named("float", "3"), Rgb::splat(3.0));
    // Equal energy at all wavelengths is not the white of sRGB.
    let flat = named("spectrum", "2");
    assert!((flat - Rgb::new(2.40959, 1.89658, 1.81783)).length() < 1e-5);
}

/// Grey without a material, black for emitters.
#[test]
fn default_materials() {
    let scene = load(&scene(
        "<shape type=\"cube\"/><shape type=\"disk\"><emitter type=\"area\"/></shape>",
    ));
    let reflectance = |i: usize| match &scene.material(scene.shapes[i].bsdf).bsdf {
        Bsdf::Plain(Lobe::Diffuse(Diffuse { reflectance })) => scene.texture(*reflectance).texel(0),
        other => panic!("{other:?}"),
    };
    assert_eq!(reflectance(0), Rgb::splat(0.5));
    assert_eq!(reflectance(1), Rgb::zero());
    let emitter = scene.shapes[1].emitter.expect("an emitter");
    let radiance = scene.texture(scene.emitter(emitter).radiance());
    assert_eq!(radiance.texel(0), Rgb::splat(1.0));
}

#[test]
fn one_nested_material_is_on_both_sides() {
    let scene = load(&scene(
        "<bsdf type=\"twosided\" id=\"m\"><bsdf type=\"diffuse\"/></bsdf>",
    ));
    let sides = scene.materials.iter().find(|m| m.id == "m");
    let Some(Bsdf::TwoSided { front, back }) = sides.map(|m| &m.bsdf) else {
        panic!("two sides");
    };
    assert_eq!(front, back);
    assert_eq!(scene.material(*front).id, "m.brdf_0");
}

#[test]
fn sensors_are_chosen_by_number_or_name() {
    let path = folder().join("two_sensors.xml");
    let sensor = |choice: &str| {
        let options = capwalk_scene_io::LoadOptions {
            sensor: choice.parse().ok(),
            ..Default::default()
        };
        capwalk_scene_io::load_scene_with(&path, &options).map(|loaded| loaded.scene.sensor.id)
    };
    for (choice, name) in [
        ("0", "left"),
        ("1", "right"),
        ("left", "left"),
        ("right", "right"),
    ] {
        assert_eq!(sensor(choice).as_deref(), Ok(name));
    }
    for (choice, expected) in [
        ("2", "the scene has no sensor 2\n  its sensors are 0 to 1"),
        ("up", "there is no sensor \"up\"\n  there are left, right"),
    ] {
        let error = sensor(choice).expect_err("there are two").to_string();
        let expected = format!("two_sensors.xml:1:1: {expected}");
        assert!(error.ends_with(&expected), "{error}");
    }
}

/// Signed volume about the origin: positive if faces are wound outward.
fn volume(scene: &Scene) -> f64 {
    let mesh = &scene.shapes[0].mesh;
    let six = (0..mesh.faces.len()).map(|face| {
        let [a, b, c] = mesh.corners(face);
        a.dot(b.cross(c))
    });
    six.sum::<f64>() / 6.0
}

/// Mirroring turns spheres inside out and leaves cubes as they are; flipping
/// turns both, and a negative radius mirrors.
#[test]
fn fronts_of_solids() {
    let solid = |plugin: &str, more: &str| {
        load(&scene(&format!("<shape type=\"{plugin}\">{more}</shape>")))
    };
    let mirror = "<transform name=\"to_world\"><scale x=\"-1\"/></transform>";
    let flip = "<boolean name=\"flip_normals\" value=\"true\"/>";
    let both = format!("{mirror}{flip}");
    for (more, cube_side, sphere_side) in [
        ("", 1.0, 1.0),
        (mirror, 1.0, -1.0),
        (flip, -1.0, -1.0),
        (both.as_str(), -1.0, 1.0),
    ] {
        let cube = volume(&solid("cube", more));
        assert!((cube - 8.0 * cube_side).abs() < 1e-12, "cube {more}");
        let ball = solid("sphere", more);
        let expected = 4.0 / 3.0 * PI * sphere_side;
        assert!(
            (volume(&ball) / expected - 1.0).abs() < 3e-4,
            "sphere {more}"
        );
        let ShadingNormals::Given(normals) = &ball.shapes[0].normals else {
            panic!("a sphere is smooth");
        };
        for (p, n) in ball.shapes[0].mesh.positions.iter().zip(normals) {
            assert!((*p * sphere_side - *n).length() < 1e-12, "sphere {more}");
        }
    }
    let negative = solid("sphere", "<float name=\"radius\" value=\"-2\"/>");
    assert!((volume(&negative) / (-32.0 / 3.0 * PI) - 1.0).abs() < 3e-4);
}

#[test]
fn spheres_are_placed_by_centre_radius_and_transform() {
    let scene = load(&scene(
        "<shape type=\"sphere\"><point name=\"center\" x=\"1\" y=\"0\" z=\"0\"/>\
         <float name=\"radius\" value=\"0.5\"/><transform name=\"to_world\">\
         <scale value=\"2\"/><rotate z=\"1\" angle=\"90\"/></transform></shape>",
    ));
    for p in &scene.shapes[0].mesh.positions {
        assert!(((*p - Vec3::new(0.0, 2.0, 0.0)).length() - 1.0).abs() < 1e-12);
    }
}

/// The parameter is the matrix of the file; a sphere's makes it of the unit one.
#[test]
fn to_world_is_that_of_the_file() {
    let text = scene(
        "<shape type=\"rectangle\" id=\"r\"><transform name=\"to_world\">\
         <scale x=\"2\"/><translate z=\"5\"/></transform></shape>\
         <shape type=\"sphere\" id=\"s\"><point name=\"center\" x=\"1\" y=\"0\" z=\"0\"/>\
         <float name=\"radius\" value=\"0.5\"/><transform name=\"to_world\">\
         <scale value=\"3\"/></transform></shape>",
    );
    let scene = load(&text);
    let matrix = |name: &str| {
        let registry = capwalk_scene::params::Registry::new(&scene);
        let array = registry.array(name).expect("one array").expect(name);
        array.get(&scene)
    };
    let rows = |diagonal: [f64; 3], translation: [f64; 3]| {
        let mut numbers = vec![0.0; 16];
        for i in 0..3 {
            numbers[5 * i] = diagonal[i];
            numbers[4 * i + 3] = translation[i];
        }
        numbers[15] = 1.0;
        numbers
    };
    assert_eq!(matrix("r.to_world"), rows([2.0, 1.0, 1.0], [0.0, 0.0, 5.0]));
    assert_eq!(matrix("s.to_world"), rows([1.5; 3], [3.0, 0.0, 0.0]));
}
