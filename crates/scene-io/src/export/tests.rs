use std::sync::Arc;

use super::*;
use crate::LoadError;
use capwalk_math::{Affine, Rgb, Vec3};
use capwalk_scene::BsdfId;
use capwalk_scene::lobe::Diffuse;
use capwalk_scene::{
    Bsdf, Emitter, Filter, Integrator, Material, Optic, SamplerKind, SensorModel, ShadingNormals,
    Texture, TextureId, builtin, primitive,
};

fn load(path: &Path) -> Result<Scene, LoadError> {
    crate::load_scene(path, &[]).map(|loaded| loaded.scene)
}

struct Directory(PathBuf);

impl Directory {
    fn new(name: &str) -> Self {
        let name = format!("capwalk-export-{name}-{}", std::process::id());
        Self(std::env::temp_dir().join(name))
    }
}

impl Drop for Directory {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn mesh_files_have_plain_and_different_names() {
    let mut scene = builtin::scene("box-room").expect("built in");
    for (shape, id) in scene.shapes_mut().zip(["a/b", "A b", "a_b", "../x", "é.1"]) {
        shape.id = id.into();
    }
    let names = file_names(scene.shapes.iter().map(|s| s.id.as_str()), "ply");
    assert_eq!(
        names[..5],
        ["a_b.ply", "A_b_2.ply", "a_b_3.ply", "_._x.ply", "é.1.ply"]
    );
}

#[test]
fn unwritable_places_are_named() {
    let directory = Directory::new("unwritable");
    fs::create_dir_all(&directory.0).expect("writable");
    let file = directory.0.join("file");
    fs::write(&file, "in the way").expect("writable");
    let scene = builtin::scene("leaf").expect("built in");
    let error = write_scene(&scene, &file).expect_err("a file is no directory");
    assert!(error.to_string().contains("file"), "{error}");
}

/// Writes and loads a scene, and checks that it is the same but for rounding
/// in the sensor's rotation and field of view and in given normals.
fn check_round_trip(scene: &Scene, name: &str) {
    let directory = Directory::new(name);
    let path = write_scene(scene, &directory.0).expect("writable");
    let mut loaded = load(&path).unwrap_or_else(|error| panic!("{name}: {error}"));
    let (own, other) = (&scene.sensor, &mut loaded.sensor);
    for axis in 0..3 {
        let difference = own.world_from_camera.rows[axis] - other.world_from_camera.rows[axis];
        assert!(difference.length() < 1e-15, "{name}: row {axis}");
    }
    if let Some(fov_x) = other.model.optic_mut(Optic::FovX) {
        let expected = own.model.optic(Optic::FovX).expect("the same model");
        assert!((*fov_x - expected).abs() < 1e-15, "{name}");
        *fov_x = expected;
    }
    other.world_from_camera.rows = own.world_from_camera.rows;
    for (a, b) in scene.shapes.iter().zip(loaded.shapes_mut()) {
        // Not printed: they may be long.
        assert!(a.mesh == b.mesh, "{name}: {}", a.id);
        if let (ShadingNormals::Given(a), ShadingNormals::Given(b)) = (&a.normals, &mut b.normals) {
            let same = |(n, m): (&Vec3, &Vec3)| (*n - *m).length() < 1e-15;
            assert!(a.iter().zip(&*b).all(same), "{name}: normals");
            b.clone_from(a);
        }
    }
    // Everything else, with its own names first to keep messages short.
    assert_eq!(scene.materials, loaded.materials, "{name}");
    assert_eq!(scene.emitters, loaded.emitters, "{name}");
    assert_eq!(scene.textures, loaded.textures, "{name}");
    assert_eq!(
        (&scene.film, &scene.settings),
        (&loaded.film, &loaded.settings),
        "{name}"
    );
    assert!(*scene == loaded, "{name}");
}

#[test]
fn built_in_scenes_come_back() {
    for name in builtin::names() {
        check_round_trip(&builtin::scene(name).expect("it is listed"), name);
    }
}

/// Everything that the built-in scenes do not have: shared and two-coloured
/// materials, odd names, computed normals, an environment, other settings.
#[test]
fn every_setting_comes_back() {
    let mut scene = builtin::scene("leaf").expect("built in");
    // In the order in which the file tells them, the area emitter's behind its shape.
    let colours = [
        ("shared <&> \"red\"", 0.7),
        ("front", 0.2),
        ("floor.bsdf", 0.4),
        ("lamp.emitter", 70.0),
        ("leaf.bsdf.brdf_0", 0.5),
        ("leaf.bsdf.brdf_1", 0.6),
    ];
    let texture = |(id, r): (&str, f64)| match id {
        "lamp.emitter" => Texture::colour("lamp.emitter.radiance", Rgb::splat(r)),
        _ => Texture::colour(
            format!("{id}.reflectance"),
            Rgb::new(r, 0.1 + 0.2, 1.0 / 3.0),
        ),
    };
    scene.textures = colours.map(|colour| texture(colour).into()).to_vec();
    for emitter in &mut scene.emitters {
        if let Emitter::Area { radiance, .. } = emitter {
            *radiance = TextureId(3);
        }
    }
    let diffuse = |id: &str, texture: usize| Material {
        id: id.into(),
        bsdf: Bsdf::from(Diffuse {
            reflectance: TextureId(texture as u32),
        }),
    };
    let two_sided = |front, back| Bsdf::TwoSided {
        front: BsdfId(front),
        back: BsdfId(back),
    };
    // In the order in which the file tells them: named ones first.
    scene.materials = vec![
        diffuse("shared <&> \"red\"", 0),
        diffuse("front", 1),
        Material {
            id: "both".into(),
            bsdf: two_sided(0, 1),
        },
        diffuse("floor.bsdf", 2),
        diffuse("leaf.bsdf.brdf_0", 4),
        diffuse("leaf.bsdf.brdf_1", 5),
        Material {
            id: "leaf.bsdf".into(),
            bsdf: two_sided(4, 5),
        },
    ];
    for (shape, bsdf) in scene.shapes_mut().zip([3, 0, 6]) {
        shape.bsdf = BsdfId(bsdf);
    }
    let mut add = |id: &str, mesh, normals, bsdf| {
        let shape = capwalk_scene::Shape::new(id, mesh, normals, BsdfId(bsdf));
        scene.add_shape(shape);
    };
    let mesh = primitive::icosphere(3);
    let normals = ShadingNormals::computed(&mesh);
    add("a/b: 1", mesh, normals, 2);
    let mesh = primitive::icosphere(2);
    let normals = mesh.positions.iter().map(|p| p.normalized()).collect();
    add("a_b_ 1", mesh, ShadingNormals::Given(normals), 0);
    let radiance = Texture::colour("sky.radiance", Rgb::new(0.1, 0.2, 1e-300));
    let radiance = scene.add_texture(radiance);
    scene.emitters.push(Emitter::Constant {
        id: "sky".into(),
        radiance,
    });
    scene.sensor.id = "eye".into();
    scene.sensor.world_from_camera = Affine::translate(Vec3::new(0.1, -1e-17, 3e5))
        * Affine::rotate(Vec3::new(0.3, 1.0, -0.2), 2.0);
    scene.sensor.model = SensorModel::Perspective {
        fov_x: 1.234567890123,
        principal_point_offset: [0.1, -0.3],
    };
    scene.sensor.near_clip = 0.3;
    scene.sensor.far_clip = 77.7;
    scene.film.crop_offset = [10, 20];
    scene.film.crop_size = [100, 50];
    scene.film.sample_border = true;
    scene.film.filter = Filter::Gaussian { stddev: 0.7 };
    scene.settings.spp = 17;
    scene.settings.seed = 1 << 40;
    scene.settings.sampler = SamplerKind::Sobol;
    scene.settings.integrator = Integrator::Path {
        max_depth: None,
        rr_depth: 9,
        hide_emitters: true,
    };
    check_round_trip(&scene, "everything");

    scene.film.filter = Filter::Tent { radius: 1.5 };
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(3),
        rr_depth: 5,
        hide_emitters: false,
    };
    check_round_trip(&scene, "tent");
    scene.settings.integrator = Integrator::Direct {
        emitter_samples: 3,
        bsdf_samples: 0,
        hide_emitters: true,
    };
    check_round_trip(&scene, "direct");
    scene.sensor.model = SensorModel::ThinLens {
        fov_x: 0.4,
        aperture_radius: 0.1 + 0.2,
        focus_distance: 7.0,
    };
    check_round_trip(&scene, "lens");
    scene.sensor.model = SensorModel::Orthographic;
    scene.sensor.world_from_camera =
        scene.sensor.world_from_camera * Affine::scale(Vec3::new(3.0, -0.1, 2.0));
    check_round_trip(&scene, "orthographic");
}

#[test]
fn xml_paths_name_the_file() {
    let directory = Directory::new("named");
    let scene = builtin::scene("leaf").expect("built in");
    let path = write_scene(&scene, &directory.0.join("my leaf.XML")).expect("writable");
    assert_eq!(path, directory.0.join("my leaf.XML"));
    assert!(directory.0.join("my leaf_meshes/leaf.ply").is_file());
    assert!(load(&path).is_ok());
}

/// Every sort of texture: alone and shared, on meshes with seams in their
/// texture coordinates, with attributes.
#[test]
fn textures_come_back() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    let text = r#"<scene version="3.0.0"><integrator type="direct"/><sensor type="perspective"/>
<texture type="bitmap" id="wood"><string name="filename" value="texels.png"/>
<string name="wrap_mode" value="mirror"/><transform name="to_uv"><matrix
value="1 2 3 0.1 5 6 7 0.2 9 10 11 0.3 0 0 0 1"/></transform></texture>
<bsdf type="twosided" id="both"><bsdf type="diffuse"><ref name="reflectance" id="wood"/></bsdf></bsdf>
<shape type="rectangle" id="a"><ref id="both"/></shape>
<shape type="disk" id="b"><bsdf type="diffuse"><texture type="bitmap" name="reflectance">
<string name="filename" value="texels.png"/><boolean name="raw" value="true"/>
<string name="filter_type" value="nearest"/></texture></bsdf></shape>
<shape type="ply" id="c"><string name="filename" value="attributes.ply"/>
<bsdf type="diffuse"><texture name="reflectance" type="mesh_attribute">
<string name="name" value="face_tint_color"/></texture></bsdf>
<emitter type="area"><texture type="checkerboard" name="radiance"><rgb name="color1"
value="1 2 3"/></texture></emitter></shape></scene>"#;
    let mut scene = crate::load_scene_str(text, &folder, "scene.xml", &[])
        .expect("right")
        .scene;
    // Texels are written in single precision.
    for texture in scene.textures.iter_mut().map(Arc::make_mut) {
        texture
            .data
            .iter_mut()
            .for_each(|x| *x = f64::from(*x as f32));
    }
    let directory = Directory::new("textures");
    let path = write_scene(&scene, &directory.0).expect("writable");
    let loaded = load(&path).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(scene.textures, loaded.textures);
    assert_eq!(scene.materials, loaded.materials);
    for (a, b) in scene.shapes.iter().zip(&loaded.shapes) {
        assert_eq!(a.attributes, b.attributes);
        // The centre of the disk has other coordinates in every triangle.
        assert_eq!(a.uvs, b.uvs, "{}", a.id);
        let corners = |s: &capwalk_scene::Shape, i: usize| s.mesh.corners(i);
        assert_eq!(a.mesh.faces.len(), b.mesh.faces.len());
        for face in 0..a.mesh.faces.len() {
            assert_eq!(corners(a, face), corners(b, face), "{}", a.id);
        }
    }
    assert_eq!(scene.shapes[0], loaded.shapes[0]);
    assert_eq!(loaded.shapes[1].mesh.positions.len(), 1 + 224 + 223 + 1);
}

/// Every plugin, with what differs from its defaults, alone and inside others.
#[test]
fn materials_come_back() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    let text = r#"<scene version="3.0.0"><integrator type="direct"/><sensor type="perspective"/>
<bsdf type="conductor" id="gold"><string name="material" value="Au"/>
<rgb name="specular_reflectance" value="0.9 0.8 0.7"/></bsdf>
<bsdf type="roughconductor" id="brushed"><string name="distribution" value="ggx"/>
<float name="alpha_u" value="0.1"/><float name="alpha_v" value="0.3"/></bsdf>
<bsdf type="dielectric" id="water"><string name="int_ior" value="water"/></bsdf>
<bsdf type="roughdielectric" id="ice"><float name="int_ior" value="1.31"/>
<float name="alpha" value="0.2"/></bsdf>
<bsdf type="thindielectric" id="pane"/>
<bsdf type="plastic" id="ball"><boolean name="nonlinear" value="true"/></bsdf>
<bsdf type="roughplastic" id="toy"><string name="distribution" value="ggx"/>
<texture type="checkerboard" name="diffuse_reflectance"/></bsdf>
<bsdf type="principled" id="car"><float name="eta" value="1.4"/><float name="sheen" value="0.3"/></bsdf>
<bsdf type="principled" id="cloth"><float name="specular" value="0.4"/></bsdf>
<bsdf type="null" id="air"/>
<bsdf type="blendbsdf" id="mix"><float name="weight" value="0.2"/><ref id="gold"/>
<bsdf type="mask"><float name="opacity" value="0.7"/><bsdf type="diffuse"/></bsdf></bsdf>
<bsdf type="twosided" id="sheet"><bsdf type="normalmap"><boolean name="use_shadowing_function" value="false"/>
<texture name="normalmap" type="checkerboard"/><bsdf type="diffuse"/></bsdf></bsdf>
<bsdf type="bumpmap" id="rough"><float name="scale" value="3"/>
<boolean name="flip_invalid_normals" value="false"/>
<texture name="whatever" type="bitmap"><string name="filename" value="sky.exr"/></texture>
<bsdf type="plastic"/></bsdf>
<shape type="rectangle" id="a"><ref id="mix"/></shape></scene>"#;
    let scene = crate::load_scene_str(text, &folder, "scene.xml", &[])
        .expect("right")
        .scene;
    let directory = Directory::new("materials");
    let path = write_scene(&scene, &directory.0).expect("writable");
    let loaded = load(&path).unwrap_or_else(|error| panic!("{error}"));
    let plugins = |scene: &Scene| -> Vec<_> {
        let materials = scene.materials.iter();
        materials.map(|m| (m.id.clone(), m.bsdf.plugin())).collect()
    };
    assert_eq!(plugins(&scene), plugins(&loaded));
    assert_eq!(scene.textures, loaded.textures);
    assert_eq!(scene.materials, loaded.materials);
}

/// Every light, with what differs from its defaults. Rotations and directions
/// are normalised anew and may differ in the last digit.
#[test]
fn emitters_come_back() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    let text = r#"<scene version="3.0.0"><integrator type="direct"/><sensor type="perspective"/>
<texture type="checkerboard" id="spot.texture"/>
<texture type="bitmap" id="beamer.irradiance"><string name="filename" value="sky.exr"/></texture>
<emitter type="envmap" id="sky"><string name="filename" value="sky.exr"/><float name="scale" value="3"/>
<transform name="to_world"><rotate y="1" angle="30"/></transform></emitter>
<emitter type="point" id="bulb"><point name="position" x="1" y="2" z="3"/></emitter>
<emitter type="spot" id="spot"><ref name="texture" id="spot.texture"/><float name="cutoff_angle" value="33.3"/><rgb name="intensity" value="1 2 3"/>
<transform name="to_world"><translate x="1" z="-4.5"/></transform></emitter>
<emitter type="projector" id="beamer"><float name="fov" value="20"/><float name="scale" value="2"/><ref name="irradiance" id="beamer.irradiance"/>
<transform name="to_world"><translate x="1" z="-4.5"/></transform></emitter>
<emitter type="directional" id="sun"><vector name="direction" x="0.1" y="-1" z="3"/></emitter></scene>"#;
    let scene = crate::load_scene_str(text, &folder, "scene.xml", &[])
        .expect("right")
        .scene;
    let directory = Directory::new("emitters");
    let path = write_scene(&scene, &directory.0).expect("writable");
    let mut loaded = load(&path).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(scene.textures, loaded.textures);
    for (own, other) in scene.emitters.iter().zip(&mut loaded.emitters) {
        match (own, other) {
            (Emitter::EnvironmentMap { map: a, .. }, Emitter::EnvironmentMap { map: b, .. }) => {
                let pairs = a.world_from_map.rows.iter().zip(&b.world_from_map.rows);
                assert!(pairs.map(|(a, b)| (*a - *b).length()).all(|e| e < 1e-15));
                b.world_from_map = a.world_from_map;
            }
            (
                Emitter::Directional { direction: a, .. },
                Emitter::Directional { direction: b, .. },
            ) => {
                assert!((*a - *b).length() < 1e-15);
                *b = *a;
            }
            (Emitter::Projector { half_size: a, .. }, Emitter::Projector { half_size: b, .. }) => {
                assert!((0..2).all(|i| (a[i] - b[i]).abs() < 1e-15));
                *b = *a;
            }
            _ => {}
        }
    }
    assert_eq!(scene.emitters, loaded.emitters);
}
