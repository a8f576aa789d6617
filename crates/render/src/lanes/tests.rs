//! Samples of lanes against those of [`Tracer`], and which scenes they are for.

use std::fs;
use std::path::Path;

use capwalk_boundary::{Counts, Draw, Sampler};
use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Rgb, Vec3};
use capwalk_scene::bsdf::NormalLimits;
use capwalk_scene::lobe::{
    Conductor, Dielectric, Diffuse, Distribution, Lobe, Microfacets, Null, Plastic,
    PolarizedPlastic, Principled, PrincipledThin, RoughConductor, RoughDielectric, RoughPlastic,
    ThinDielectric,
};
use capwalk_scene::number::{Indices, PrincipledIndex};
use capwalk_scene::primitive::icosphere;
use capwalk_scene::texture::{Bitmap, TexelFilter, UvTransform, Wrap};
use capwalk_scene::{
    Bsdf, BsdfId, Filter, Integrator, Material, Pattern, SamplerKind, Scene, SensorModel,
    ShadingNormals, Shape, Texture, builtin,
};
use capwalk_scene_io::load_scene;

use super::*;
use crate::scene_eval::Primal;
use crate::tiles::count_samples;
use crate::tracer::Tracer;

fn direct(hide_emitters: bool) -> Integrator {
    Integrator::Direct {
        emitter_samples: 1,
        bsdf_samples: 1,
        hide_emitters,
    }
}

fn path(max_depth: Option<u32>) -> Integrator {
    Integrator::Path {
        max_depth,
        rr_depth: 2,
        hide_emitters: false,
    }
}

/// A built-in scene of 24 × 18 pixels.
fn scene(name: &str, integrator: Integrator) -> Scene {
    let mut scene = builtin::scene(name).expect("built in");
    scene.film.size = [24, 18];
    scene.film.crop_size = [24, 18];
    scene.settings.integrator = integrator;
    scene
}

/// The scene with an image on all surfaces.
fn painted(mut scene: Scene) -> Scene {
    let colours = scene
        .materials
        .iter()
        .filter_map(|material| match material.bsdf {
            Bsdf::Plain(Lobe::Diffuse(Diffuse { reflectance })) => Some(reflectance),
            _ => None,
        });
    let colours: Vec<_> = colours.collect();
    for id in colours {
        let texture = std::sync::Arc::make_mut(&mut scene.textures[id.0 as usize]);
        texture.channels = 3;
        texture.data = (0..48).map(|i| f64::from(i * 7 % 10) / 10.0).collect();
        texture.pattern = Pattern::Bitmap(Bitmap {
            width: 4,
            height: 4,
            filter: TexelFilter::Bilinear,
            wrap: Wrap::Repeat,
            to_uv: UvTransform::IDENTITY,
        });
    }
    for shape in &mut scene.shapes {
        let shape = std::sync::Arc::make_mut(shape);
        let corners = |i: usize| {
            let [a, b] = [0.37, 0.61].map(|k| (i as f64 * k).fract());
            [[a, b], [a + 0.8, b], [a, b + 0.9]]
        };
        shape.uvs = Some((0..shape.mesh.faces.len()).map(corners).collect());
    }
    scene.check().expect("a valid scene");
    scene
}

/// Sample by sample the same light, but for rays that pass an edge so near that single precision
/// does not resolve it, and what becomes of these paths.
fn samples_are_those_of_the_tracer(what: &str, scene: Scene) {
    let Compared {
        differ, lit, means, ..
    } = compare(&PreparedScene::new(scene), 20_005, RayPrecision::Resolving);
    assert!(lit > 5000, "{what}: {lit}");
    assert!(differ < 8, "{what}: {differ} differ");
    assert!(
        (means[0] / means[1] - 1.0).abs() < 0.01,
        "{what}: {means:?}"
    );
}

/// Samples of lanes beside those of the tracer.
struct Compared {
    /// How many differ, and how many of the tracer's are not black.
    differ: u32,
    lit: u32,
    /// Means of both.
    means: [f64; 2],
    /// The place of one that differs, and both samples.
    example: Option<([u32; 2], [Rgb; 2])>,
}

fn compare(prepared: &PreparedScene, samples: u32, precision: RayPrecision) -> Compared {
    let (scene, tracer) = (prepared.scene(), Tracer::primal(prepared));
    let lanes = LaneTracer::of_light(tracer.plan, prepared, precision).expect("an image of light");
    let sampler = Sampler::new(&scene.settings, 3, 64);
    let [width, height] = scene.film.crop_size;
    let run = |i: u32| {
        let (pixel, number) = (i * 29 % (width * height), i / (width * height));
        SampleRun {
            pixel: [pixel % width, pixel / width],
            streams: sampler.in_pixel(u64::from(pixel)),
            numbers: number..number + 1,
        }
    };
    let runs: Vec<SampleRun> = (0..samples).map(run).collect();
    let mut taken = Vec::new();
    lanes.take(&runs, &mut taken);
    assert_eq!(taken.len(), runs.len());
    let eval = Primal(prepared.accel());
    let mut compared = Compared {
        differ: 0,
        lit: 0,
        means: [0.0; 2],
        example: None,
    };
    for (run, sample) in runs.iter().zip(&taken) {
        let draw = Draw {
            stream: &run.streams.stream(run.numbers.start),
            counts: &Counts::default(),
        };
        let expected: Rgb = tracer.pixel(&eval, run.pixel, draw);
        let found = Rgb::from(sample.numbers);
        compared.lit += u32::from(expected.r > 0.0);
        let error = (found - expected).to_array().map(f64::abs);
        let size = expected.max_component().max(1e-3);
        // True for NaN.
        if !error.iter().all(|&error| error <= 1e-9 * size) {
            compared.differ += 1;
            compared.example = Some((run.pixel, [found, expected]));
        }
        compared.means[0] += found.r;
        compared.means[1] += expected.r;
    }
    compared
}

/// In all scenes that the project has, with their emitters, sensors, textures and depths: the same
/// samples where rays are single, nearly all where they come in packets.
#[test]
fn lanes_sample_all_scenes() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests");
    let files_in = |folder: &str| {
        let entries = fs::read_dir(tests.join(folder)).expect("a folder of scenes");
        let entries: Vec<_> = entries
            .map(|entry| entry.expect("readable").path())
            .collect();
        entries
    };
    let folders = files_in("scenes")
        .into_iter()
        .map(|folder| folder.join("scene.xml"));
    let mut files: Vec<_> = folders.chain(files_in("parity")).collect();
    files.retain(|file| file.extension().is_some_and(|kind| kind == "xml") && file.exists());
    files.sort();
    let (mut wrong, mut with_packets) = (Vec::new(), 0);
    for file in &files {
        let loaded = load_scene(file, &[]).expect("a valid scene");
        let prepared = PreparedScene::new(loaded.scene);
        if matches!(prepared.scene().settings.integrator, Integrator::Aov(_)) {
            continue;
        }
        let has_packets = rays::Meets::new(prepared.accel(), RayPrecision::Resolving).has_packets();
        with_packets += u32::from(has_packets);
        let compared = compare(&prepared, 403, RayPrecision::Resolving);
        let allowed = if has_packets { 2 } else { 0 };
        if compared.differ > allowed {
            let name = file.strip_prefix(&tests).unwrap_or(file).display();
            let (
                Compared {
                    differ, example, ..
                },
                kind,
            ) = (compared, if has_packets { "packets" } else { "single" });
            wrong.push(format!("{name} ({kind}): {differ} differ, as {example:?}"));
        }
    }
    assert!(
        files.len() > 100 && with_packets > 20,
        "{} {with_packets}",
        files.len()
    );
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn lanes_sample_what_the_tracer_does() {
    for (name, integrator) in [
        ("leaf", direct(false)),
        ("box-room", direct(true)),
        ("box-room", path(Some(3))),
        ("box-room", path(None)),
    ] {
        samples_are_those_of_the_tracer(name, scene(name, integrator));
    }
}

/// What finite differences are made of: where an image has packets, too, rays are in double precision if
/// that is asked for.
#[test]
fn lanes_in_double_precision_sample_the_same() {
    let prepared = PreparedScene::new(scene("box-room", path(Some(3))));
    let plan = Plan::new(prepared.scene());
    let has_packets = [RayPrecision::Resolving, RayPrecision::Double].map(|precision| {
        let lanes = LaneTracer::of_light(plan, &prepared, precision);
        lanes.expect("an image of light").has_packets()
    });
    assert_eq!(has_packets, [true, false]);
    let compared = compare(&prepared, 5_000, RayPrecision::Double);
    assert_eq!(compared.differ, 0, "{:?}", compared.example);
}

/// Two balls with normals at vertices, in the room: one of few triangles, and a sphere, whose shape has a
/// vertex before it.
fn with_balls(mut scene: Scene) -> Scene {
    let places = [
        ("ball", 3, Vec3::new(-0.9, 0.5, 0.8)),
        ("sphere", 20, Vec3::new(0.8, 0.5, 0.9)),
    ];
    for (name, frequency, centre) in places {
        let mut ball = icosphere(frequency);
        if name == "sphere" {
            ball.positions.insert(0, Vec3::new(0.0, 0.0, 1.0));
            ball.faces.iter_mut().flatten().for_each(|i| *i += 1);
        }
        let normals = ShadingNormals::Given(ball.positions.clone());
        let place = |p: &mut Vec3| *p = *p * 0.4 + centre;
        ball.positions.iter_mut().for_each(place);
        let bsdf = scene.shapes[0].bsdf;
        scene.add_shape(Shape::new(name, ball, normals, bsdf));
    }
    scene
}

/// Materials of which each side has a colour of its own: the floor's, and that of the first wall.
fn two_sided(mut scene: Scene) -> Scene {
    let [front, back] = [scene.shapes[0].bsdf, scene.shapes[3].bsdf];
    scene.materials.push(Material {
        id: "both".into(),
        bsdf: Bsdf::TwoSided { front, back },
    });
    let both = BsdfId(scene.materials.len() as u32 - 1);
    for shape in &mut scene.shapes {
        std::sync::Arc::make_mut(shape).bsdf = both;
    }
    // Some faces show their back.
    let boxes = scene.shapes.iter_mut().find(|shape| shape.id == "box");
    let mesh = &mut std::sync::Arc::make_mut(boxes.expect("a box")).mesh;
    mesh.faces.iter_mut().for_each(|face| face.swap(1, 2));
    scene.check().expect("a valid scene");
    scene
}

/// With a texture on all surfaces, both sides of them, normals at vertices, points that are not
/// independent, filters with weights, and an emitter that is wide where it is near.
#[test]
fn lanes_sample_other_surfaces() {
    let room = || scene("box-room", path(Some(4)));
    samples_are_those_of_the_tracer("both sides", two_sided(room()));
    let mut textured = painted(with_balls(room()));
    textured.settings.sampler = SamplerKind::Sobol;
    textured.film.filter = Filter::Gaussian { stddev: 0.5 };
    samples_are_those_of_the_tracer("textured", textured);
    let mut wide = scene("box-room", direct(false));
    let emitter = wide.shapes.iter_mut().find(|shape| shape.emitter.is_some());
    let mesh = &mut std::sync::Arc::make_mut(emitter.expect("an emitter")).mesh;
    let (low, high) = mesh.bounds();
    let centre = (low + high) * 0.5;
    let wider = |p: &mut Vec3| *p = centre + (*p - centre) * 3.0;
    mesh.positions.iter_mut().for_each(wider);
    samples_are_those_of_the_tracer("wide", wide);
}

/// The scene with some shapes of other materials, the same all over each, some of which turn with
/// texture coordinates; those named with "true" are turned inside out.
fn of_all_materials(mut scene: Scene, shown: &[(&str, u32, bool)]) -> Scene {
    let mut number = |x: f64| scene.add_texture(Texture::colour("number", Rgb::splat(x)));
    let [zero, alpha, half, one, index, extinction] =
        [0.0, 0.2, 0.5, 1.0, 1.5, 3.0].map(&mut number);
    let metal = Conductor {
        eta: half,
        k: extinction,
        specular_reflectance: one,
    };
    let eta = Indices {
        int_ior: index,
        ext_ior: one,
    };
    let glass = Dielectric {
        eta,
        specular_reflectance: one,
        specular_transmittance: one,
    };
    let facets = |distribution| Microfacets {
        distribution,
        alpha_u: alpha,
        alpha_v: match distribution {
            Distribution::Beckmann => alpha,
            Distribution::Ggx => half,
        },
    };
    let rough_metal = |distribution| RoughConductor {
        microfacets: facets(distribution),
        eta: metal.eta,
        k: metal.k,
        specular_reflectance: metal.specular_reflectance,
    };
    let coat = RoughPlastic {
        distribution: Distribution::Beckmann,
        alpha,
        eta,
        diffuse_reflectance: half,
        specular_reflectance: one,
        nonlinear: true,
        transmittance: (),
    };
    let principled = Principled {
        base_color: half,
        roughness: half,
        anisotropic: half,
        metallic: alpha,
        spec_trans: zero,
        eta: PrincipledIndex::Eta(index),
        spec_tint: half,
        sheen: half,
        sheen_tint: half,
        flatness: half,
        clearcoat: half,
        clearcoat_gloss: half,
        explored: (),
    };
    let thin = PrincipledThin {
        base_color: half,
        roughness: half,
        anisotropic: zero,
        spec_trans: half,
        eta: index,
        spec_tint: half,
        sheen: half,
        sheen_tint: half,
        flatness: half,
        diff_trans: one,
        explored: (),
    };
    let normals = scene.add_texture(Texture::colour("normals", Rgb::new(0.6, 0.45, 0.9)));
    let [floor, wall] = [scene.shapes[0].bsdf, scene.shapes[3].bsdf];
    let first = scene.materials.len() as u32;
    let [coated, brushed, mirror] = [0, 1, 5].map(|i| BsdfId(first + i));
    let materials = [
        Bsdf::from(coat.clone()),
        rough_metal(Distribution::Ggx).into(),
        Bsdf::from(Plastic {
            eta,
            diffuse_reflectance: half,
            specular_reflectance: one,
            nonlinear: true,
        }),
        Bsdf::from(PolarizedPlastic {
            microfacets: facets(Distribution::Ggx),
            eta,
            diffuse_reflectance: half,
            specular_reflectance: one,
        }),
        principled.into(),
        metal.into(),
        Bsdf::TwoSided {
            front: brushed,
            back: coated,
        },
        Bsdf::Blend {
            weight: alpha,
            nested: [brushed, mirror],
        },
        Bsdf::from(RoughDielectric {
            microfacets: facets(Distribution::Beckmann),
            eta,
            specular_reflectance: one,
            specular_transmittance: one,
        }),
        thin.into(),
        // Diffuse where it is seen from behind, but the frame turns with texture coordinates.
        Bsdf::TwoSided {
            front: brushed,
            back: floor,
        },
        glass.into(),
        Bsdf::from(ThinDielectric {
            eta,
            specular_reflectance: one,
            specular_transmittance: one,
        }),
        Bsdf::Mask {
            opacity: half,
            nested: coated,
        },
        Bsdf::Blend {
            weight: half,
            nested: [floor, wall],
        },
        Bsdf::NormalMap {
            normals,
            nested: floor,
            limits: NormalLimits {
                flip_invalid: true,
                shadowing: true,
            },
        },
        Null::default().into(),
        // The other distributions, and a coat that is thinner inside.
        rough_metal(Distribution::Beckmann).into(),
        Bsdf::from(RoughPlastic {
            distribution: Distribution::Ggx,
            eta: Indices {
                int_ior: one,
                ext_ior: index,
            },
            ..coat
        }),
    ];
    for (i, bsdf) in materials.into_iter().enumerate() {
        let id = format!("material {i}");
        scene.materials.push(Material { id, bsdf });
    }
    let corners = [[0.1, 0.2], [0.9, 0.3], [0.2, 0.7]];
    for (name, material, is_turned) in shown {
        let shape = scene.shapes.iter_mut().find(|shape| shape.id == *name);
        let shape = std::sync::Arc::make_mut(shape.expect("a shape"));
        shape.bsdf = BsdfId(first + material);
        shape.uvs = Some(vec![corners; shape.mesh.faces.len()]);
        if *is_turned {
            shape.mesh.faces.iter_mut().for_each(|face| face.swap(1, 2));
        }
    }
    scene.check().expect("a valid scene");
    scene
}

/// A sheet below the emitter.
fn with_sheet(mut scene: Scene) -> Scene {
    let back = scene.shapes.iter().find(|shape| shape.id == "back");
    let mut sheet = Shape::clone(back.expect("a wall"));
    sheet.id = "sheet".into();
    let low = |p: &mut Vec3| *p = Vec3::new(0.3 * p.x + 0.4, 2.4, 0.3 * (p.y - 1.5) + 1.2);
    sheet.mesh.positions.iter_mut().for_each(low);
    scene.add_shape(sheet);
    scene
}

/// Lobes of all kinds, on faces and on interpolated normals, seen from both sides.
#[test]
fn lanes_sample_other_materials() {
    let room = with_sheet(scene("box-room", path(Some(5))));
    let shown = [
        ("floor", 0, false),
        ("ceiling", 7, false),
        ("back", 2, false),
        ("left", 6, true),
        ("right", 3, false),
        ("box", 10, true),
        ("sheet", 9, false),
    ];
    samples_are_those_of_the_tracer("materials", of_all_materials(room, &shown));
    let room = with_balls(scene("box-room", direct(false)));
    let shown = [
        ("ball", 4, false),
        ("left", 5, false),
        ("box", 8, false),
        ("floor", 0, false),
        ("back", 1, false),
    ];
    samples_are_those_of_the_tracer("ball and mirror", of_all_materials(room, &shown));
    // Rough surfaces of all kinds, also where interpolated normals turn away.
    for ball in [0, 1, 17, 18] {
        let room = with_balls(scene("box-room", path(Some(4))));
        let shown = [
            ("ball", ball, false),
            ("floor", 17, false),
            ("back", 18, false),
            ("left", 0, false),
            ("box", 1, false),
        ];
        samples_are_those_of_the_tracer("rough", of_all_materials(room, &shown));
    }
    // Lobes that are diffuse, where the emitter alone is sampled.
    let shown = [
        ("floor", 14, false),
        ("back", 15, false),
        ("left", 10, true),
        ("box", 10, true),
    ];
    let room = of_all_materials(scene("box-room", direct(false)), &shown);
    samples_are_those_of_the_tracer("diffuse lobes", room);
    // What lets light pass, and an emitter that reflects.
    let room = with_balls(with_sheet(scene("box-room", path(None))));
    let shown = [
        ("box", 11, false),
        ("sheet", 12, false),
        ("floor", 13, false),
        ("ball", 16, false),
        ("lamp", 0, false),
    ];
    samples_are_those_of_the_tracer("passing light", of_all_materials(room, &shown));
}

/// Whatever is taken along with it, a sample is the same to the bit.
#[test]
fn samples_do_not_depend_on_each_other() {
    let room = || scene("box-room", path(None));
    let rough = [
        ("box", 1, true),
        ("floor", 7, false),
        ("back", 0, false),
        ("left", 18, false),
        ("lamp", 0, false),
    ];
    let mut by_sobol = room();
    by_sobol.settings.sampler = SamplerKind::Sobol;
    for scene in [room(), of_all_materials(room(), &rough), by_sobol] {
        samples_are_the_same_in_other_packets(scene);
    }
}

fn samples_are_the_same_in_other_packets(scene: Scene) {
    let prepared = PreparedScene::new(scene);
    let tracer = Tracer::primal(&prepared);
    let lanes =
        LaneTracer::of_light(tracer.plan, &prepared, RayPrecision::Resolving).expect("for lanes");
    let sampler = Sampler::new(&prepared.scene().settings, 5, 64);
    // Runs of different lengths; what is left out is at the beginning of one, or all of it.
    let run = |i: u32| SampleRun {
        pixel: [i % 24, i / 24 % 18],
        streams: sampler.in_pixel(u64::from(i % 432)),
        numbers: 2..3 + i % 23,
    };
    let runs: Vec<SampleRun> = (0..432).map(run).collect();
    let mut fewer = runs[2..].to_vec();
    fewer[0].numbers.start = 4;
    let (mut together, mut shifted) = (Vec::new(), Vec::new());
    lanes.take(&runs, &mut together);
    lanes.take(&fewer, &mut shifted);
    let [all, left] = [&runs, &fewer].map(|runs| count_samples(runs));
    assert_eq!((together.len(), shifted.len()), (all, left));
    for (a, b) in together[all - left..].iter().zip(&shifted) {
        assert_eq!((a.numbers, a.effort), (b.numbers, b.effort));
    }
}

/// What single precision does not resolve has single rays.
#[test]
fn other_scenes_have_single_rays() {
    let has_packets = |scene: Scene| {
        let prepared = PreparedScene::new(scene);
        rays::Meets::new(prepared.accel(), RayPrecision::Resolving).has_packets()
    };
    let room = || scene("box-room", path(None));
    assert!(has_packets(room()));
    let changed = |change: fn(&mut Scene)| {
        let mut scene = room();
        change(&mut scene);
        has_packets(scene)
    };
    /// The mesh of a shape.
    fn mesh<'a>(scene: &'a mut Scene, name: &str) -> &'a mut Mesh {
        let shape = scene.shapes.iter_mut().find(|shape| shape.id == name);
        &mut std::sync::Arc::make_mut(shape.expect("a shape")).mesh
    }
    assert!(!changed(
        |scene| scene.sensor.model = SensorModel::Orthographic
    ));
    // A thin box, a board just before a wall, an emitter just before the ceiling, and a large image.
    assert!(!changed(|scene| {
        let positions = &mut mesh(scene, "box").positions;
        positions.iter_mut().for_each(|p| p.x *= 1e-3);
    }));
    let before = |distance: f64| {
        let mut scene = room();
        let (mut board, bsdf) = (mesh(&mut scene, "back").clone(), scene.shapes[0].bsdf);
        let moved = |p: &mut Vec3| *p = *p * 0.5 + Vec3::new(0.0, 0.7, -1.0 + distance);
        board.positions.iter_mut().for_each(moved);
        scene.add_shape(Shape::new("board", board, ShadingNormals::Face, bsdf));
        has_packets(scene)
    };
    assert!(before(0.1) && !before(1e-6));
    assert!(!changed(|scene| {
        let positions = &mut mesh(scene, "lamp").positions;
        positions.iter_mut().for_each(|p| p.y = 3.0 - 1e-6);
    }));
    assert!(!changed(
        |scene| (scene.film.size, scene.film.crop_size) = ([4096; 2], [4096; 2])
    ));
    // Something near the camera; but behind it or beside the image only if something is specular.
    let beside = |towards: [f64; 3], is_specular: bool| {
        let mut scene = room();
        let view = scene.sensor.view(&scene.film);
        let [left, up, forward] = view.axes();
        let [x, y, z] = towards;
        let place = view.origin + (left * x + up * y + forward * z) * 0.05;
        let positions = &mut mesh(&mut scene, "box").positions;
        let sum = positions.iter().fold(Vec3::zero(), |sum, &p| sum + p);
        let centre = sum / positions.len() as f64;
        let moved = |p: &mut Vec3| *p = place + (*p - centre) * 0.04;
        positions.iter_mut().for_each(moved);
        if is_specular {
            scene.materials.push(Material {
                id: "pane".into(),
                // It passes light in one direction, as mirrors reflect it.
                bsdf: Null::default().into(),
            });
            let bsdf = BsdfId(scene.materials.len() as u32 - 1);
            std::sync::Arc::make_mut(&mut scene.shapes[0]).bsdf = bsdf;
        }
        has_packets(scene)
    };
    assert!(!beside([0.0, 0.0, 1.0], false));
    let elsewhere = [[0.0, -1.0], [1.0, 0.2], [-1.0, 0.2]];
    for [x, z] in elsewhere {
        for towards in [[x, 0.0, z], [0.0, x, z]] {
            let packets = [false, true].map(|is_specular| beside(towards, is_specular));
            assert_eq!(packets, [true, false], "{towards:?}");
        }
    }
    // A coarse sphere, a face of which lies just above the floor.
    let lifted = |height: f64| {
        let mut scene = room();
        let mut ball = icosphere(4);
        let turn = Affine::rotate(Vec3::new(0.3, 0.2, 1.0), 0.4);
        let normal = turn.vector(ball.face_cross(7)).normalized();
        let down = Vec3::new(0.0, -1.0, 0.0);
        let turn = Affine::rotate(normal.cross(down), normal.dot(down).acos()) * turn;
        let turned = |p: &mut Vec3| *p = turn.point(*p) * 0.3;
        ball.positions.iter_mut().for_each(turned);
        let low = ball.bounds().0.y;
        let placed = |p: &mut Vec3| p.y += height - low;
        ball.positions.iter_mut().for_each(placed);
        let bsdf = scene.shapes[0].bsdf;
        scene.add_shape(Shape::new("ball", ball, ShadingNormals::Face, bsdf));
        has_packets(scene)
    };
    assert!(lifted(0.1) && !lifted(1e-7));
    // Many faces, right before the camera: but those of a sphere are met in double precision.
    let with_ball = |is_sphere: bool| {
        let mut scene = room();
        let view = scene.sensor.view(&scene.film);
        let mut ball = icosphere(8);
        let place = |p: &mut Vec3| *p = *p * 0.02 + view.origin + view.axes()[2] * 0.05;
        ball.positions.iter_mut().for_each(place);
        if !is_sphere {
            ball.faces.reverse();
        }
        let bsdf = scene.shapes[0].bsdf;
        scene.add_shape(Shape::new("ball", ball, ShadingNormals::Face, bsdf));
        has_packets(scene)
    };
    assert!(with_ball(true) && !with_ball(false));
}
