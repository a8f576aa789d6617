use super::*;
use crate::{Scene, ShapeId, SurfacePoint, TextureId};
use capwalk_math::{Affine, Dual, Vec3};

#[test]
fn greys_have_three_equal_channels() {
    assert_eq!(Texture::number("a", 0.3).texel(0), Rgb::splat(0.3));
    let colour = Rgb::new(0.1, 0.2, 0.3);
    assert_eq!(Texture::colour("b", colour).texel(0), colour);
    assert_eq!(
        texel(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0], 3, 1),
        Rgb::new(4.0, 5.0, 6.0)
    );
    assert_eq!(texel(&[1.0, 2.0], 1, 1), Rgb::splat(2.0));
}

#[test]
fn bad_numbers_are_named() {
    let mut texture = bitmap(TexelFilter::Bilinear, Wrap::Repeat);
    texture.data[3 * 5 + 1] = f64::NAN;
    let message = texture.check().expect_err("bad").to_string();
    let expected = "wood.data, texel 5 is (";
    assert!(message.starts_with(expected), "{message}");
    let number = Texture::number("a.alpha", f64::INFINITY);
    let message = number.check().expect_err("bad").to_string();
    assert!(message.starts_with("a.alpha.value is (inf"), "{message}");
}

/// Lengths that do not fit are errors, not panics later.
#[test]
fn wrong_lengths_are_named() {
    let mut texture = bitmap(TexelFilter::Bilinear, Wrap::Repeat);
    texture.data.pop();
    let message = texture.check().expect_err("too short").to_string();
    let expected = "the texture \"wood\" has 35 numbers; expected 36";
    assert!(message.starts_with(expected), "{message}");
    texture.channels = 2;
    let message = texture.check().expect_err("two channels").to_string();
    assert_eq!(message, "wood.channels is 2; expected 1 or 3");
}

/// A bitmap of 4 x 3 texels without any symmetry.
fn bitmap(filter: TexelFilter, wrap: Wrap) -> Texture {
    let data = (0..36).map(|i| f64::from(i * i % 37) / 37.0).collect();
    Texture {
        id: "wood".into(),
        channels: 3,
        data,
        pattern: Pattern::Bitmap(Bitmap {
            width: 4,
            height: 3,
            filter,
            wrap,
            to_uv: UvTransform::IDENTITY,
        }),
    }
}

/// What a texture is at `uv`, by laying all copies of all texels out in the
/// plane and adding those within reach, each weighted by its tent.
fn slow_lookup(texture: &Texture, [u, v]: [f64; 2]) -> Rgb {
    let Pattern::Bitmap(bitmap) = &texture.pattern else {
        panic!("a bitmap");
    };
    let (w, h) = (bitmap.width as i64, bitmap.height as i64);
    let copy_of = |i: i64, n: i64| match bitmap.wrap {
        Wrap::Repeat => (i + 100 * n) % n,
        Wrap::Clamp => i.max(0).min(n - 1),
        Wrap::Mirror => {
            let mut i = i;
            while i < 0 || i >= n {
                i = if i < 0 { -1 - i } else { 2 * n - 1 - i };
            }
            i
        }
    };
    let mut sum = Rgb::zero();
    for x in -5 * w..6 * w {
        for y in -5 * h..6 * h {
            let across = u * w as f64 - (x as f64 + 0.5);
            let down = v * h as f64 - (y as f64 + 0.5);
            let weight = match bitmap.filter {
                TexelFilter::Bilinear => {
                    (1.0 - across.abs()).max(0.0) * (1.0 - down.abs()).max(0.0)
                }
                TexelFilter::Nearest => {
                    let inside = |d: f64| (-0.5..0.5).contains(&d);
                    f64::from(u8::from(inside(across) && inside(down)))
                }
            };
            let index = copy_of(y, h) * w + copy_of(x, w);
            sum += texture.texel(index as usize) * weight;
        }
    }
    sum
}

const PLACES: [[f64; 2]; 8] = [
    [0.31, 0.47],
    [0.02, 0.03],
    [0.97, 0.51],
    [0.4, 0.99],
    [-0.07, 0.2],
    [1.6, -0.3],
    [-2.3, 3.7],
    [3.41, -1.93],
];

#[test]
fn lookups_agree_with_the_slow_one() {
    for filter in [TexelFilter::Nearest, TexelFilter::Bilinear] {
        for wrap in [Wrap::Repeat, Wrap::Mirror, Wrap::Clamp] {
            let texture = bitmap(filter, wrap);
            for uv in PLACES {
                let value = texture.lookup(uv, |i| texture.texel(i));
                let error = (value - slow_lookup(&texture, uv)).length();
                assert!(error < 1e-13, "{filter:?} {wrap:?} {uv:?}: {error:e}");
            }
        }
    }
}

/// Derivatives by both texture coordinates, through the transform of them,
/// against central differences; a bilinear function has no error in them.
#[test]
fn lookups_differentiate_by_texture_coordinates() {
    let mut texture = bitmap(TexelFilter::Bilinear, Wrap::Mirror);
    if let Pattern::Bitmap(bitmap) = &mut texture.pattern {
        bitmap.to_uv.rows = [[0.9, -0.3, 0.1], [0.2, 1.1, -0.4]];
    }
    let value = |uv: [f64; 2]| texture.lookup(uv, |i| texture.texel(i));
    let h = 1e-6;
    let mut steepest: f64 = 0.0;
    for [u, v] in PLACES {
        let uv = [Dual::<2>::variable(u, 0), Dual::variable(v, 1)];
        let dual = texture.lookup(uv, |i| Rgb::constant(texture.texel(i)));
        assert_eq!(dual.value(), value([u, v]));
        let by_u = (value([u + h, v]) - value([u - h, v])) / (2.0 * h);
        let by_v = (value([u, v + h]) - value([u, v - h])) / (2.0 * h);
        for (axis, difference) in [by_u, by_v].into_iter().enumerate() {
            let error = (dual.tangent(axis) - difference).length();
            assert!(error < 1e-8, "({u}, {v}) axis {axis}: {error:e}");
            steepest = steepest.max(difference.length());
        }
    }
    assert!(steepest > 0.5, "nothing changes");
}

/// Lookups are linear in texels: the derivative with respect to one is its weight.
#[test]
fn lookups_differentiate_by_texels() {
    let texture = bitmap(TexelFilter::Bilinear, Wrap::Repeat);
    let h = 0.5;
    for uv in PLACES {
        for chosen in 0..texture.texels() {
            let dual = texture.lookup(uv.map(Dual::<1>::constant), |i| {
                let one = if i == chosen { 1.0 } else { 0.0 };
                texture.texel(i).with_tangent(Rgb::new(one, 0.0, 2.0 * one))
            });
            let mut changed = texture.clone();
            changed.data[3 * chosen] += h;
            changed.data[3 * chosen + 2] += 2.0 * h;
            let above = changed.lookup(uv, |i| changed.texel(i));
            let difference = (above - texture.lookup(uv, |i| texture.texel(i))) / h;
            let error = (dual.tangent(0) - difference).length();
            assert!(error < 1e-13, "{uv:?} texel {chosen}: {error:e}");
        }
    }
}

/// Values of Mitsuba 3.9.1 for a checkerboard with colours 0.4 and 0.2.
#[test]
fn checkerboard_alternates() {
    let texture = Texture {
        id: "board".into(),
        channels: 1,
        data: vec![0.4, 0.2],
        pattern: Pattern::Checkerboard {
            to_uv: UvTransform::from_affine(&Affine::scale(Vec3::new(2.0, 1.0, 1.0))),
        },
    };
    let at = |u, v| texture.lookup([u, v], |i| texture.texel(i)).r;
    for (uv, expected) in [
        ([0.05, 0.1], 0.4),
        ([0.3, 0.1], 0.2),
        ([0.3, 0.6], 0.4),
        ([-0.05, 0.1], 0.2),
        ([-0.05, -0.1], 0.4),
    ] {
        assert_eq!(at(uv[0], uv[1]), expected, "{uv:?}");
    }
}

/// A transform of space acts in the plane z = 0, as in Mitsuba.
#[test]
fn transforms_of_texture_coordinates() {
    let affine = Affine {
        rows: [
            Vec3::new(1.0, 2.0, 3.0),
            Vec3::new(5.0, 6.0, 7.0),
            Vec3::new(9.0, 10.0, 11.0),
        ],
        translation: Vec3::new(4.0, 8.0, 12.0),
    };
    let to_uv = UvTransform::from_affine(&affine);
    assert_eq!(to_uv.rows, [[1.0, 2.0, 4.0], [5.0, 6.0, 8.0]]);
    assert_eq!(to_uv.apply([0.5, 0.25]), [5.0, 12.0]);
}

/// Attributes are interpolated over faces, or the same all over each; what a
/// texture asks for by name is the shape's own.
#[test]
fn attributes_of_shapes() {
    let (scene, [by_vertex, by_face, by_name]) = scene_with_attributes();
    let at = SurfacePoint {
        shape: ShapeId(0),
        face: 1,
        barycentric: [0.5, 0.3, 0.2],
        uv: [0.0, 0.0],
    };
    let value = |id| scene.lookup(id, &at, |id, i| scene.texture(id).texel(i));
    // The corners of face 1 are the vertices 0, 2 and 3.
    assert_eq!(value(by_vertex).r, 0.5 * 1.0 + 0.3 * 3.0 + 0.2 * 4.0);
    assert_eq!(value(by_face), Rgb::new(0.4, 0.5, 0.6));
    assert_eq!(value(by_name), Rgb::splat(10.0 * value(by_vertex).r));
    // Derivatives by the vertices' numbers are the weights.
    let moving = SurfacePoint {
        shape: at.shape,
        face: at.face,
        barycentric: at.barycentric.map(Dual::<1>::constant),
        uv: at.uv.map(Dual::constant),
    };
    let dual = scene.lookup(by_name, &moving, |id, i| {
        let speed = if i == 3 { 1.0 } else { 0.0 };
        scene.texture(id).texel(i).with_tangent(Rgb::splat(speed))
    });
    assert_eq!(dual.tangent(0), Rgb::splat(10.0 * 0.2));
}

/// A rectangle with an attribute per vertex, one per face, and a texture that
/// asks for the first by its name.
fn scene_with_attributes() -> (Scene, [TextureId; 3]) {
    let mut scene = crate::builtin::scene("leaf").expect("built in");
    let texture = |id: &str, channels, data: &[f64], pattern| Texture {
        id: id.into(),
        channels,
        data: data.to_vec(),
        pattern,
    };
    let ids = [
        texture(
            "floor.vertex_heat",
            1,
            &[1.0, 2.0, 3.0, 4.0],
            Pattern::PerVertex,
        ),
        texture(
            "floor.face_color",
            3,
            &[0.1, 0.2, 0.3, 0.4, 0.5, 0.6],
            Pattern::PerFace,
        ),
        texture(
            "floor.bsdf.reflectance",
            1,
            &[],
            Pattern::MeshAttribute {
                name: "vertex_heat".into(),
                scale: 10.0,
            },
        ),
    ]
    .map(|texture| scene.add_texture(texture));
    let names = ["vertex_heat", "face_color"];
    scene.shape_mut(ShapeId(0)).attributes = names
        .into_iter()
        .zip(ids)
        .map(|(name, texture)| crate::shape::Attribute {
            name: name.into(),
            texture,
        })
        .collect();
    (scene, ids)
}

/// A scene in which a shape lacks what its texture asks for is refused.
#[test]
fn shapes_must_have_what_textures_ask_for() {
    let (mut scene, [_, _, by_name]) = scene_with_attributes();
    let set = |scene: &mut Scene, id| {
        let floor = scene.shapes[0].bsdf.0 as usize;
        scene.materials[floor].bsdf = crate::lobe::Diffuse { reflectance: id }.into();
    };
    set(&mut scene, by_name);
    assert_eq!(scene.check(), Ok(()));
    let heat = scene.shape_mut(ShapeId(0)).attributes.remove(0);
    let message = scene.check().expect_err("no heat").to_string();
    assert!(message.contains("asks for \"vertex_heat\""), "{message}");
    assert!(message.contains("has only face_color"), "{message}");
    // Its range is that of its use.
    scene.texture_mut(heat.texture).data[2] = -1.0;
    scene.shape_mut(ShapeId(0)).attributes.push(heat);
    let message = scene.check().expect_err("negative").to_string();
    assert!(
        message.starts_with("floor.vertex_heat, texel 2 is (-1"),
        "{message}"
    );

    let wood = scene.add_texture(bitmap(TexelFilter::Bilinear, Wrap::Repeat));
    set(&mut scene, wood);
    let message = scene.check().expect_err("no coordinates").to_string();
    assert!(message.contains("needs texture coordinates"), "{message}");
    let uvs = crate::primitive::rectangle_uvs(Affine::IDENTITY);
    scene.shape_mut(ShapeId(0)).uvs = Some(uvs);
    assert_eq!(scene.check(), Ok(()));
    scene.texture_mut(wood).data[4] = -0.5;
    let message = scene.check().expect_err("negative").to_string();
    assert!(message.starts_with("wood.data, texel 1 is ("), "{message}");
    assert!(message.ends_with("at least 0"), "{message}");
}

/// Derivatives are those of one smooth function: `∂/∂v` of that by `u` is `∂/∂u` of
/// that by `v`, through a transform of coordinates and at borders; they are
/// continuous at the centres of texels, and linear in texels.
#[test]
fn derivatives_of_bitmaps() {
    for wrap in [Wrap::Repeat, Wrap::Mirror, Wrap::Clamp] {
        let Pattern::Bitmap(mut bitmap) = bitmap(TexelFilter::Bilinear, wrap).pattern else {
            panic!("a bitmap");
        };
        let texels = self::bitmap(TexelFilter::Bilinear, wrap);
        bitmap.to_uv.rows = [[0.9, -0.3, 0.1], [0.2, 1.1, -0.4]];
        let at = |uv: [f64; 2]| bitmap.gradient(uv, |i| texels.texel(i));
        for [u, v] in PLACES {
            let uv = [Dual::<2>::variable(u, 0), Dual::variable(v, 1)];
            let [by_u, by_v] = bitmap.gradient(uv, |i| Rgb::constant(texels.texel(i)));
            assert_eq!([by_u.value(), by_v.value()], at([u, v]));
            let curl = by_u.tangent(1) - by_v.tangent(0);
            assert!(curl.length() < 1e-12, "({u}, {v}): {curl:?}");
            // Beyond the border of a clamped one nothing changes along it.
            let is_flat = by_u.tangent(1).length() < 1e-3;
            assert!(!is_flat || wrap == Wrap::Clamp, "({u}, {v})");
        }
        for step in 0..40 {
            let u = 0.1 * f64::from(step) - 1.0;
            let [before, behind] = [-1e-9, 1e-9].map(|d| at([u + d, 0.7 * u])[0]);
            assert!((before - behind).length() < 1e-6, "discontinuous at {u}");
        }
    }
}

/// A ramp has the same derivative everywhere, that of the function that its texels
/// follow.
#[test]
fn derivative_of_a_ramp() {
    let bitmap = Bitmap {
        width: 8,
        height: 5,
        filter: TexelFilter::Bilinear,
        wrap: Wrap::Clamp,
        to_uv: UvTransform::IDENTITY,
    };
    // 2 u - 3 v at the centres.
    let height = |i: usize| {
        let (x, y) = ((i % 8) as f64 + 0.5, (i / 8) as f64 + 0.5);
        Rgb::splat(2.0 * x / 8.0 - 3.0 * y / 5.0)
    };
    for uv in [[0.3, 0.4], [0.5, 0.5], [0.71, 0.33]] {
        let [by_u, by_v] = bitmap.gradient(uv, height);
        assert!((by_u - Rgb::splat(2.0)).length() < 1e-13, "{by_u:?}");
        assert!((by_v + Rgb::splat(3.0)).length() < 1e-13, "{by_v:?}");
    }
}
