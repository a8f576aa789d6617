//! Gradients against finite differences, one scene per phenomenon: textures.
//! What is demanded of each case, and how often it raises a false alarm, is said
//! in `phenomena_shadows.rs`.

mod common;

use capwalk_math::Affine;
use capwalk_render::{GradientOptions, Options, Unwatched, WalkSettings, gradient};
use capwalk_scene::primitive::rectangle;
use capwalk_scene::texture::{Bitmap, TexelFilter, UvTransform, Wrap};
use capwalk_scene::*;
use common::agree::*;
use common::stages::*;
use common::*;

/// A picture of 4 x 4 colours that look random.
fn colours(id: &str, filter: TexelFilter) -> Texture {
    let number = |i: usize| 0.1 + 0.8 * ((i * i * 7 + i * 13) % 17) as f64 / 16.0;
    Texture {
        id: id.into(),
        channels: 3,
        data: (0..48).map(number).collect(),
        pattern: Pattern::Bitmap(Bitmap {
            width: 4,
            height: 4,
            filter,
            wrap: Wrap::Repeat,
            to_uv: UvTransform::IDENTITY,
        }),
    }
}

/// Gives the shape's material a texture instead of its reflectance.
fn paint(scene: &mut Scene, shape: &str, texture: Texture) {
    let id = scene.add_texture(texture);
    let name = format!("{shape}.bsdf");
    let material = scene.materials.iter_mut().find(|m| m.id == name);
    material.expect("the material of a shape").bsdf = Bsdf::Diffuse { reflectance: id };
}

/// Gives the shape an attribute, and its material the texture that looks it up.
fn paint_by_attribute(
    scene: &mut Scene,
    shape: &str,
    pattern: Pattern,
    channels: usize,
    data: Vec<f64>,
) {
    let attribute = scene.add_texture(Texture {
        id: format!("{shape}.color"),
        channels,
        data,
        pattern,
    });
    let found = scene.shapes.iter_mut().find(|s| s.id == shape);
    let attributes = &mut found.expect("a shape").attributes;
    attributes.push(capwalk_scene::shape::Attribute {
        name: "color".into(),
        texture: attribute,
    });
    let by_attribute = Texture {
        id: "by_attribute".into(),
        channels,
        data: Vec::new(),
        pattern: Pattern::MeshAttribute {
            name: "color".into(),
            scale: 1.0,
        },
    };
    paint(scene, shape, by_attribute);
}

/// A painted plane under a lamp, seen from near by.
fn painted_floor() -> Scene {
    let mut scene = empty(v(0.3, -2.0, 2.5), v(0.0, 0.0, 0.0), 40.0, 36);
    add_floor(&mut scene, 3.0);
    unit_square(&mut scene, "floor");
    paint(
        &mut scene,
        "floor",
        colours("colours", TexelFilter::Bilinear),
    );
    add_lamp(&mut scene, v(0.1, 0.0, 3.0), 0.8, 0.3, 10.0);
    scene
}

fn visible(spp: u32) -> Case {
    Case {
        step: 4e-3,
        gradient_spp: spp,
        reference_spp: 2 * spp,
        ..Case::default()
    }
}

/// The texture moves with the plane.
#[test]
fn textured_plane_moves() {
    let scene = painted_floor();
    let motion = motion(&scene, "floor.translate.x + 0.3*floor.rotate.z");
    agree("textured plane", scene, &motion, visible(100));
}

/// The camera moves over a texture, past a thing and its shadow.
#[test]
fn camera_over_a_texture() {
    let mut scene = painted_floor();
    let thing = placed(small_ball(), Affine::translate(v(0.0, 0.3, -0.4)));
    add(&mut scene, "thing", thing, ShadingNormals::Face, 0.5);
    let motion = motion(&scene, "sensor.translate.y + 0.2*sensor.rotate.z");
    agree("camera over a texture", scene, &motion, visible(400));
}

/// The numbers of a texture themselves.
#[test]
fn texels() {
    let scene = painted_floor();
    let mut motion = Motion::zero(&scene);
    let index = scene.textures.iter().position(|t| t.id == "colours");
    let velocities = (0..48).map(|i| f64::from(i % 5) - 1.5).collect();
    motion.textures[index.expect("painted")] = Some(velocities);
    agree("texels", scene, &motion, visible(64));
}

/// A lamp with a picture on it, seen, and as the light of a moving shadow.
#[test]
fn textured_lamp() {
    let mut scene = visible_cube();
    unit_square(&mut scene, "lamp");
    let lamp = scene.add_texture(colours("picture", TexelFilter::Bilinear));
    for emitter in &mut scene.emitters {
        if let Emitter::Area { radiance, .. } = emitter {
            *radiance = lamp;
        }
    }
    for value in &mut scene.textures[lamp.0 as usize].data {
        *value *= 20.0;
    }
    let motion = motion(
        &scene,
        "lamp.translate.x - 0.5*lamp.rotate.z + thing.translate.y",
    );
    agree("textured lamp", scene, &motion, visible(400));
}

/// Texture coordinates that jump at the diagonal of a rectangle: a boundary
/// between coplanar faces.
#[test]
fn seam_of_texture_coordinates() {
    let mut scene = empty(v(0.3, -2.0, 2.5), v(0.0, 0.0, 0.0), 19.0, 36);
    add_floor(&mut scene, 0.6);
    // Each triangle shows the picture in its own way.
    let both = [
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]],
        [[0.9, 0.1], [0.2, 0.7], [0.4, 0.3]],
    ];
    scene.shapes[0].uvs = Some(both.to_vec());
    paint(
        &mut scene,
        "floor",
        colours("colours", TexelFilter::Bilinear),
    );
    add_lamp(&mut scene, v(0.1, 0.0, 3.0), 0.8, 0.3, 10.0);
    let motion = motion(&scene, "floor.translate.x + floor.rotate.z");
    agree("seam", scene, &motion, visible(200));
}

/// A colour for each face of a mesh.
#[test]
fn faces_of_different_colours() {
    let mut scene = empty(v(0.3, -2.0, 2.5), v(0.0, 0.0, 0.0), 19.0, 36);
    let (mesh, normals) = rectangle(Affine::scale(v(0.7, 0.5, 1.0)));
    add(&mut scene, "floor", mesh, normals, 0.5);
    let colours = vec![0.9, 0.2, 0.1, 0.1, 0.3, 0.8];
    paint_by_attribute(&mut scene, "floor", Pattern::PerFace, 3, colours);
    add_lamp(&mut scene, v(0.1, 0.0, 3.0), 0.8, 0.3, 10.0);
    let motion = motion(&scene, "floor.translate.x + floor.rotate.z");
    let case = Case {
        size: 52,
        ..visible(200)
    };
    agree("colours of faces", scene, &motion, case);
}

/// Two triangles of a floor with vertices of their own, and a colour for each
/// vertex: the colours jump where the triangles meet.
#[test]
fn vertices_of_different_colours() {
    let mut scene = empty(v(0.3, -2.0, 2.5), v(0.0, 0.0, 0.0), 19.0, 36);
    let corner = |x: f64, y: f64| v(0.6 * x, 0.6 * y, 0.0);
    let mesh = capwalk_geometry::Mesh {
        positions: vec![
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(1.0, 1.0),
            corner(-1.0, -1.0),
            corner(1.0, 1.0),
            corner(-1.0, 1.0),
        ],
        faces: vec![[0, 1, 2], [3, 4, 5]],
    };
    add(&mut scene, "floor", mesh, ShadingNormals::Face, 0.5);
    let greys = vec![0.9, 0.8, 0.9, 0.1, 0.2, 0.1];
    paint_by_attribute(&mut scene, "floor", Pattern::PerVertex, 1, greys);
    add_lamp(&mut scene, v(0.1, 0.0, 3.0), 0.8, 0.3, 10.0);
    let motion = motion(&scene, "floor.translate.x + floor.rotate.z");
    agree("colours of vertices", scene, &motion, visible(200));
}

/// Texture coordinates that agree where two triangles meet, but turn an
/// anisotropic material differently.
#[test]
fn seam_of_tangents() {
    let mut scene = empty(v(0.3, -2.0, 2.5), v(0.0, 0.0, 0.0), 19.0, 36);
    add_floor(&mut scene, 0.6);
    let faces = scene.shapes[0].mesh.faces.clone();
    let turned = |face: usize| {
        faces[face].map(|i| {
            let p = scene.shapes[0].mesh.positions[i as usize];
            // The same on the diagonal x = y.
            if face == 0 { [p.x, p.y] } else { [p.y, p.x] }
        })
    };
    scene.shapes[0].uvs = Some(vec![turned(0), turned(1)]);
    let mut number = |id: &str, x: f64| scene.add_texture(Texture::number(id, x));
    let alpha = [number("alpha_u", 0.6), number("alpha_v", 0.15)];
    let metal = capwalk_scene::bsdf::Metal {
        eta: number("eta", 0.2),
        k: number("k", 3.0),
        specular_reflectance: number("white", 1.0),
    };
    let facets = capwalk_scene::bsdf::Facets {
        distribution: capwalk_scene::lobe::Distribution::Ggx,
        alpha,
    };
    let material = scene.materials.iter_mut().find(|m| m.id == "floor.bsdf");
    material.expect("the floor's").bsdf = Bsdf::RoughConductor(metal, facets);
    add_lamp(&mut scene, v(0.1, 1.5, 2.0), 1.5, 0.3, 10.0);
    let motion = motion(&scene, "floor.translate.x + floor.rotate.z");
    agree("seam of tangents", scene, &motion, visible(400));
}

/// Textures that jump are refused if something moves, and only then.
#[test]
fn nearest_texels_are_refused() {
    let mut scene = painted_floor();
    paint(&mut scene, "floor", colours("blocks", TexelFilter::Nearest));
    scene.film.size = [4; 2];
    scene.film.crop_size = [4; 2];
    let settings = GradientOptions {
        options: Options {
            spp: 2,
            seed: 1,
            threads: None,
        },
        walk: WalkSettings::default(),
    };
    let run = |name: &str| gradient(&scene, &motion(&scene, name), &settings, &Unwatched);
    let refusal = run("floor.translate.x").expect_err("it jumps");
    assert!(refusal.reason.contains("\"blocks\""), "{refusal}");
    assert!(run("lamp.emitter.radiance.value").is_ok());
}
