use super::*;
use crate::ids::ShapeId;
use crate::material::bsdf::{Material, NormalLimits};
use crate::material::lobe::{
    Dielectric, Diffuse, Distribution, Microfacets, RoughConductor, RoughPlastic,
};
use crate::shape::Shape;
use crate::texture::{Bitmap, Pattern, TexelFilter, Texture, UvTransform, Wrap};
use capwalk_math::{Affine, Dual};

/// Textures with the values that a function says.
struct Values<F>(F);

impl<R: Real, F: Fn(TextureId) -> Rgb<R>> TexturesAt<R> for Values<F> {
    fn value(&mut self, id: TextureId) -> Rgb<R> {
        self.0(id)
    }
    fn gradient(&mut self, _: TextureId) -> [Rgb<R>; 2] {
        [0.25, -0.5].map(|slope| Rgb::constant(Rgb::splat(slope)))
    }
    fn may_change(&self, _: TextureId) -> bool {
        false
    }
}

/// A scene of materials made of each other: diffuse 0 and 1, glass 2, a rough
/// metal 3, and what is added.
struct Materials(Scene);

impl Materials {
    fn new() -> Self {
        let mut scene = crate::builtin::scene("leaf").expect("built in");
        scene.materials.clear();
        scene.textures.clear();
        scene.shapes.clear();
        scene.emitters.clear();
        let mut it = Self(scene);
        for reflectance in [[0.1, 0.2, 0.3], [0.5, 0.6, 0.7]] {
            let reflectance = it.texture(Texture::colour("c", reflectance.into()));
            it.add(Diffuse { reflectance });
        }
        let white = it.texture(Texture::colour("white", Rgb::splat(1.0)));
        let glass = Dielectric {
            eta: Indices {
                int_ior: it.number(1.5),
                ext_ior: it.number(1.2),
            },
            specular_reflectance: white,
            specular_transmittance: white,
        };
        it.add(glass);
        let metal = RoughConductor {
            microfacets: Microfacets {
                distribution: Distribution::Ggx,
                alpha_u: it.number(0.2),
                alpha_v: it.number(0.4),
            },
            eta: it.number(0.2),
            k: it.number(3.0),
            specular_reflectance: white,
        };
        it.add(metal);
        it
    }

    fn texture(&mut self, texture: Texture) -> TextureId {
        self.0.add_texture(texture)
    }

    fn number(&mut self, number: f64) -> TextureId {
        self.texture(Texture::number("n", number))
    }

    fn add(&mut self, bsdf: impl Into<Bsdf>) -> BsdfId {
        let bsdf = bsdf.into();
        let id = format!("m{}", self.0.materials.len());
        self.0.materials.push(Material { id, bsdf });
        BsdfId(self.0.materials.len() as u32 - 1)
    }

    fn resolve(&self, id: BsdfId, side: Side) -> Resolved<f64> {
        self.0.check_materials().expect("right");
        let textures = &mut Values(|id| self.0.texture(id).texel(0));
        Resolver::new(&self.0).resolve(&self.0, id, side, textures)
    }

    fn problem(&self) -> String {
        self.0.check_materials().expect_err("wrong").to_string()
    }
}

fn weights(resolved: &Resolved<f64>) -> Vec<(f64, Lobe)> {
    resolved.bsdf.lobes().cloned().collect()
}

fn diffuse(reflectance: [f64; 3]) -> Lobe {
    Lobe::Diffuse(lobe::Diffuse {
        reflectance: reflectance.into(),
    })
}

const FIRST: [f64; 3] = [0.1, 0.2, 0.3];
const SECOND: [f64; 3] = [0.5, 0.6, 0.7];

#[test]
fn two_sided_materials_turn_over() {
    let mut materials = Materials::new();
    let (front, back) = (BsdfId(0), BsdfId(1));
    let both = materials.add(Bsdf::TwoSided { front, back });
    let front = materials.resolve(both, Side::Front);
    assert_eq!(
        (weights(&front), front.flipped),
        (vec![(1.0, diffuse(FIRST))], false)
    );
    let back = materials.resolve(both, Side::Back);
    assert_eq!(
        (weights(&back), back.flipped),
        (vec![(1.0, diffuse(SECOND))], true)
    );
    // From behind, the frame has been turned over: it is seen from its front.
    let (wi, wo) = (Vec3::new(0.0, 0.6, 0.8), Vec3::new(0.6, 0.0, 0.8));
    assert!(back.bsdf.eval(wi, wo).r > 0.1);
    // A one-sided material is black from behind, a clear one is not.
    let behind = materials.resolve(BsdfId(0), Side::Back);
    assert_eq!((weights(&behind).len(), behind.flipped), (0, false));
    let inside = materials.resolve(BsdfId(2), Side::Back);
    let lobes = weights(&inside);
    let [(1.0, Lobe::Dielectric(glass))] = &lobes[..] else {
        panic!("{lobes:?}");
    };
    assert_eq!(glass.eta, 1.25);
}

/// Weights multiply, from the outside in; what is masked passes.
#[test]
fn blends_and_masks_have_weights() {
    let mut materials = Materials::new();
    let weight = materials.number(0.25);
    let opacity = materials.number(0.75);
    let blend = materials.add(Bsdf::Blend {
        weight,
        nested: [BsdfId(0), BsdfId(1)],
    });
    let nested = materials.add(Bsdf::Blend {
        weight,
        nested: [blend, BsdfId(3)],
    });
    let mask = materials.add(Bsdf::Mask { opacity, nested });
    let lobes = weights(&materials.resolve(mask, Side::Front));
    let found: Vec<f64> = lobes.iter().map(|(weight, _)| *weight).collect();
    assert_eq!(
        found,
        [0.75 * 0.75 * 0.75, 0.75 * 0.75 * 0.25, 0.75 * 0.25, 0.25]
    );
    assert_eq!(lobes[1].1, diffuse(SECOND));
    let Lobe::RoughConductor(metal) = &lobes[2].1 else {
        panic!("{lobes:?}");
    };
    assert_eq!(
        (metal.microfacets.alpha_u, metal.microfacets.alpha_v),
        (0.2, 0.4)
    );
    assert_eq!(lobes[3].1, Lobe::Null(lobe::Null::default()));
    // From behind only what passes is left.
    let behind = weights(&materials.resolve(mask, Side::Back));
    assert_eq!(behind, [(0.25, Lobe::Null(lobe::Null::default()))]);
}

/// Derivatives of textures get into weights and numbers; colours where numbers
/// are asked for count as their luminance.
#[test]
fn derivatives_pass_through() {
    let mut materials = Materials::new();
    let opacity = materials.texture(Texture::colour("o", Rgb::new(0.2, 0.4, 0.9)));
    let mask = materials.add(Bsdf::Mask {
        opacity,
        nested: BsdfId(0),
    });
    let scene = &materials.0;
    let textures = &mut Values(|id| {
        let value = scene.texture(id).texel(0);
        value.with_tangent(Rgb::new(1.0, 10.0, 100.0))
    });
    let resolver = Resolver::new(scene);
    let resolved = resolver.resolve::<Dual<1>>(scene, mask, Side::Front, textures);
    let lobes: Vec<_> = resolved.bsdf.lobes().collect();
    let luminance = 0.212671 * 0.2 + 0.715160 * 0.4 + 0.072169 * 0.9;
    assert!((lobes[0].0.value - luminance).abs() < 1e-15);
    let derivative = 0.212671 + 7.15160 + 7.2169;
    assert!((lobes[0].0.tangent[0] - derivative).abs() < 1e-12);
    assert!((lobes[1].0.tangent[0] + derivative).abs() < 1e-12);
    let Lobe::Diffuse(diffuse) = lobes[0].1 else {
        panic!("diffuse");
    };
    assert_eq!(diffuse.reflectance.tangent(0), Rgb::new(1.0, 10.0, 100.0));
}

const LIMITS: NormalLimits = NormalLimits {
    flip_invalid: true,
    shadowing: true,
};

impl Materials {
    /// A map of one normal around a material.
    fn normal_map(&mut self, nested: BsdfId) -> BsdfId {
        let normals = self.texture(Texture::colour("n", Rgb::new(0.5, 0.75, 1.0)));
        self.add(Bsdf::NormalMap {
            normals,
            nested,
            limits: LIMITS,
        })
    }
}

/// Each part of a blend has its own normal; what passes has none, and goes
/// straight on.
#[test]
fn maps_tilt_what_is_in_them() {
    let mut materials = Materials::new();
    let half = materials.number(0.5);
    let map = materials.normal_map(BsdfId(0));
    let nested = [map, BsdfId(1)];
    let blend = materials.add(Bsdf::Blend {
        weight: half,
        nested,
    });
    let veil = materials.add(Bsdf::Mask {
        opacity: half,
        nested: blend,
    });
    let resolved = materials.resolve(veil, Side::Front);
    let tilt = Tilt::new(Vec3::new(0.0, 0.5, 1.0), LIMITS);
    let mut expected = lobe::LocalBsdf::default();
    expected.push_tilted(0.25, diffuse(FIRST), Some(tilt));
    expected.push(0.25, diffuse(SECOND));
    expected.push(0.5, Lobe::Null(lobe::Null::default()));
    assert_eq!(resolved.bsdf, expected.clone().seen_from(Side::Front));
    // The same the other way round: only what is opaque is tilted.
    let veil = materials.add(Bsdf::Mask {
        opacity: half,
        nested: BsdfId(0),
    });
    let map = materials.normal_map(veil);
    let resolved = materials.resolve(map, Side::Front);
    let mut expected = lobe::LocalBsdf::default();
    expected.push_tilted(0.5, diffuse(FIRST), Some(tilt));
    expected.push(0.5, Lobe::Null(lobe::Null::default()));
    assert_eq!(resolved.bsdf, expected.seen_from(Side::Front));
}

/// A surface that rises along an axis is tilted against it.
#[test]
fn heights_tilt_against_their_slope() {
    let mut materials = Materials::new();
    let heights = materials.texture(Texture {
        id: "h".into(),
        channels: 3,
        data: vec![0.0; 3],
        pattern: Pattern::Bitmap(Bitmap {
            width: 1,
            height: 1,
            filter: TexelFilter::Bilinear,
            wrap: Wrap::Repeat,
            to_uv: UvTransform::IDENTITY,
        }),
    });
    let scale = materials.number(2.0);
    let map = materials.add(Bsdf::BumpMap {
        heights,
        scale,
        nested: BsdfId(1),
        limits: LIMITS,
    });
    let resolved = materials.resolve(map, Side::Front);
    let [x, y] = [0.25, -0.5].map(|slope| -2.0 * slope);
    let mut expected = lobe::LocalBsdf::default();
    let tilt = Tilt::new(Vec3::new(x, y, 1.0), LIMITS);
    expected.push_tilted(1.0, diffuse(SECOND), Some(tilt));
    assert_eq!(resolved.bsdf, expected.seen_from(Side::Front));
}

/// Around a two-sided material, a map turns one surface with two sides: from behind, its
/// normal points the other way. Inside, each side has the map to itself.
#[test]
fn maps_around_two_sides_turn_over() {
    let mut materials = Materials::new();
    let (front, back) = (BsdfId(0), BsdfId(1));
    let both = materials.add(Bsdf::TwoSided { front, back });
    let around = materials.normal_map(both);
    let inside = materials.normal_map(BsdfId(1));
    let inside = materials.add(Bsdf::TwoSided {
        front: inside,
        back: inside,
    });
    for (map, side, reflectance, y) in [
        (around, Side::Front, FIRST, 0.5),
        (around, Side::Back, SECOND, -0.5),
        (inside, Side::Front, SECOND, 0.5),
        (inside, Side::Back, SECOND, 0.5),
    ] {
        let resolved = materials.resolve(map, side);
        assert_eq!(resolved.flipped, side == Side::Back);
        let tilt = Tilt::new(Vec3::new(0.0, y, 1.0), LIMITS);
        let mut expected = lobe::LocalBsdf::default();
        expected.push_tilted(1.0, diffuse(reflectance), Some(tilt));
        assert_eq!(resolved.bsdf, expected.seen_from(Side::Front), "{side:?}");
    }
}

#[test]
fn rough_coats_have_their_table() {
    let mut materials = Materials::new();
    let white = materials.texture(Texture::colour("white", Rgb::splat(1.0)));
    let (distribution, alpha) = (Distribution::Beckmann, materials.number(0.3));
    let coat = RoughPlastic {
        distribution,
        alpha,
        eta: Indices {
            int_ior: materials.number(1.5),
            ext_ior: materials.number(1.0),
        },
        diffuse_reflectance: white,
        specular_reflectance: white,
        nonlinear: false,
        transmittance: (),
    };
    let int_ior = coat.eta.int_ior;
    let rough = materials.add(coat);
    let lobes = weights(&materials.resolve(rough, Side::Front));
    let Lobe::RoughPlastic(lobe) = &lobes[0].1 else {
        panic!("{lobes:?}");
    };
    assert_eq!((lobe.alpha, lobe.eta), (0.3, 1.5));
    let expected = RoughTransmittance::new(distribution, 0.3, 1.5);
    assert_eq!(*lobe.transmittance, expected);
    // Tables are kept as long as their numbers are the same.
    let mut resolver = Resolver::new(&materials.0);
    let table =
        |resolver: &Resolver| Arc::clone(resolver.coats.iter().flatten().next().expect("one"));
    let first = table(&resolver);
    materials.0.texture_mut(white).data[0] = 0.5;
    resolver.update(&materials.0);
    assert!(Arc::ptr_eq(&first, &table(&resolver)));
    materials.0.texture_mut(alpha).data[0] = 0.2;
    resolver.update(&materials.0);
    let expected = RoughTransmittance::new(distribution, 0.2, 1.5);
    assert_eq!(*table(&resolver), expected);
    // Its tables cannot be made where the coat is no surface, or smooth.
    materials.0.texture_mut(int_ior).data[0] = 1.0;
    assert!(materials.problem().contains("index of its outside"));
    materials.0.texture_mut(int_ior).data[0] = 1.4;
    materials.0.texture_mut(alpha).data[0] = 0.0;
    assert!(materials.problem().contains("write plastic"));
}

#[test]
fn contradictions_are_refused() {
    type Make = fn(&mut Materials);
    let cases: [(Make, &str); 9] = [
        (
            |m| {
                let (front, back) = (BsdfId(2), BsdfId(0));
                m.add(Bsdf::TwoSided { front, back });
            },
            "made of clear ones",
        ),
        (
            |m| {
                let (front, back) = (BsdfId(0), BsdfId(1));
                let both = m.add(Bsdf::TwoSided { front, back });
                let (front, back) = (BsdfId(0), both);
                m.add(Bsdf::TwoSided { front, back });
            },
            "made of two-sided ones",
        ),
        (
            |m| {
                let (front, back) = (BsdfId(0), BsdfId(1));
                let both = m.add(Bsdf::TwoSided { front, back });
                let weight = m.number(0.5);
                let nested = [both, BsdfId(2)];
                m.add(Bsdf::Blend { weight, nested });
            },
            "a two-sided and a clear material",
        ),
        (
            |m| {
                let weight = m.number(0.5);
                let mut nested = BsdfId(0);
                for _ in 0..4 {
                    let both = [nested, BsdfId(1)];
                    nested = m.add(Bsdf::Blend {
                        weight,
                        nested: both,
                    });
                }
            },
            "too many materials",
        ),
        (
            |m| {
                let nested = m.normal_map(BsdfId(0));
                m.normal_map(nested);
            },
            "perturbed twice",
        ),
        (
            |m| {
                m.normal_map(BsdfId(0));
                let normal = TextureId(m.0.textures.len() as u32 - 1);
                m.0.texture_mut(normal).data = vec![0.5; 3];
            },
            "a normal in its map is 0",
        ),
        (
            |m| {
                let normals = m.number(0.7);
                m.add(Bsdf::NormalMap {
                    normals,
                    nested: BsdfId(0),
                    limits: LIMITS,
                });
            },
            "three channels",
        ),
        (
            |m| {
                let [heights, scale] = [m.number(0.5), m.number(1.0)];
                m.add(Bsdf::BumpMap {
                    heights,
                    scale,
                    nested: BsdfId(0),
                    limits: LIMITS,
                });
            },
            "a bitmap with the filter bilinear",
        ),
        (
            |m| {
                // Each made of the next, so that the first is the deepest.
                let opacity = m.number(1.0);
                for next in 5..2000 {
                    let nested = BsdfId(next);
                    m.add(Bsdf::Mask { opacity, nested });
                }
                let nested = BsdfId(0);
                m.add(Bsdf::Mask { opacity, nested });
            },
            "too deep",
        ),
    ];
    for (make, expected) in cases {
        let mut materials = Materials::new();
        make(&mut materials);
        let problem = materials.problem();
        assert!(problem.contains(expected), "{problem}");
        assert!(problem.starts_with("the material \"m"), "{problem}");
    }
}

/// Maps turn normals in directions that texture coordinates give.
#[test]
fn maps_need_texture_coordinates() {
    let mut materials = Materials::new();
    let bsdf = materials.normal_map(BsdfId(0));
    let mut scene = materials.0;
    let (mesh, normals) = crate::primitive::rectangle(Affine::IDENTITY);
    scene.shapes = vec![Shape::new("floor", mesh, normals, bsdf).into()];
    let message = scene.check().expect_err("no coordinates").to_string();
    assert!(message.contains("\"floor\" has none"), "{message}");
    let uvs = crate::primitive::rectangle_uvs(Affine::IDENTITY);
    scene.shape_mut(ShapeId(0)).uvs = Some(uvs);
    assert_eq!(scene.check(), Ok(()));
}
