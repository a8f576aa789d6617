//! Materials for the cases.

use capwalk_scene::bsdf::NormalLimits;
use capwalk_scene::lobe::{
    Conductor, Dielectric, Diffuse, Distribution, Lobe, Microfacets, Null, Plastic,
    PolarizedPlastic, Principled, PrincipledThin, RoughConductor, RoughDielectric, RoughPlastic,
    ThinDielectric,
};
use capwalk_scene::number::{Indices, PrincipledIndex};
use capwalk_scene::texture::{Bitmap, TexelFilter, UvTransform, Wrap};
use capwalk_scene::*;

use super::*;

/// A material's textures, named after their places in it.
pub struct Slots<'a> {
    pub scene: &'a mut Scene,
    pub material: String,
}

impl Slots<'_> {
    pub fn number(&mut self, slot: &str, value: f64) -> TextureId {
        let id = format!("{}.{slot}", self.material);
        self.scene.add_texture(Texture::number(id, value))
    }
    pub fn colour(&mut self, slot: &str, rgb: [f64; 3]) -> TextureId {
        let id = format!("{}.{slot}", self.material);
        self.scene.add_texture(Texture::colour(id, Rgb::from(rgb)))
    }
    pub fn copper(&mut self) -> Conductor<TextureId> {
        Conductor {
            eta: self.colour("eta", [0.3, 0.9, 1.2]),
            k: self.colour("k", [3.3, 2.6, 2.4]),
            specular_reflectance: self.colour("specular_reflectance", [0.9, 0.8, 0.9]),
        }
    }
    pub fn mirror(&mut self) -> Conductor<TextureId> {
        Conductor {
            eta: self.colour("eta", [0.0; 3]),
            k: self.colour("k", [1.0; 3]),
            specular_reflectance: self.colour("specular_reflectance", [0.9; 3]),
        }
    }
    pub fn facets(&mut self, distribution: Distribution, alpha: f64) -> Microfacets<TextureId> {
        Microfacets::isotropic(distribution, self.number("alpha", alpha))
    }
    fn indices(&mut self) -> Indices {
        Indices {
            int_ior: self.number("int_ior", 1.5),
            ext_ior: self.number("ext_ior", 1.0),
        }
    }
    pub fn glass(&mut self) -> Dielectric<TextureId> {
        Dielectric {
            eta: self.indices(),
            specular_reflectance: self.colour("specular_reflectance", [1.0; 3]),
            specular_transmittance: self.colour("specular_transmittance", [0.7, 0.9, 0.8]),
        }
    }
    pub fn pane(&mut self) -> ThinDielectric<TextureId> {
        let Dielectric {
            eta,
            specular_reflectance,
            specular_transmittance,
        } = self.glass();
        ThinDielectric {
            eta,
            specular_reflectance,
            specular_transmittance,
        }
    }
    pub fn coat(&mut self, nonlinear: bool) -> Plastic<TextureId> {
        Plastic {
            eta: self.indices(),
            diffuse_reflectance: self.colour("diffuse_reflectance", [0.7, 0.3, 0.2]),
            specular_reflectance: self.colour("specular_reflectance", [0.9; 3]),
            nonlinear,
        }
    }
    pub fn principled(&mut self, glass: f64) -> Principled<TextureId> {
        Principled {
            base_color: self.colour("base_color", [0.8, 0.5, 0.3]),
            roughness: self.number("roughness", 0.5),
            anisotropic: self.number("anisotropic", 0.2),
            metallic: self.number("metallic", 0.3),
            spec_trans: self.number("spec_trans", glass),
            eta: PrincipledIndex::Eta(self.number("eta", 1.5)),
            spec_tint: self.number("spec_tint", 0.4),
            sheen: self.number("sheen", 0.6),
            sheen_tint: self.number("sheen_tint", 0.3),
            flatness: self.number("flatness", 0.2),
            clearcoat: self.number("clearcoat", 0.5),
            clearcoat_gloss: self.number("clearcoat_gloss", 0.05),
            explored: (),
        }
    }
    pub fn principled_thin(&mut self) -> PrincipledThin<TextureId> {
        PrincipledThin {
            base_color: self.colour("base_color", [0.8, 0.5, 0.3]),
            roughness: self.number("roughness", 0.6),
            anisotropic: self.number("anisotropic", 0.2),
            spec_trans: self.number("spec_trans", 0.4),
            eta: self.number("eta", 1.5),
            spec_tint: self.number("spec_tint", 0.4),
            sheen: self.number("sheen", 0.6),
            sheen_tint: self.number("sheen_tint", 0.3),
            flatness: self.number("flatness", 0.2),
            diff_trans: self.number("diff_trans", 0.8),
            explored: (),
        }
    }
    /// A material of its own, to be mixed.
    pub fn part(&mut self, name: &str, bsdf: impl Into<Bsdf>) -> BsdfId {
        let bsdf = bsdf.into();
        let id = format!("{}.{name}", self.material);
        self.scene.materials.push(Material { id, bsdf });
        BsdfId(self.scene.materials.len() as u32 - 1)
    }
    pub fn diffuse(&mut self, name: &str, rgb: [f64; 3]) -> BsdfId {
        let reflectance = self.colour(&format!("{name}.reflectance"), rgb);
        self.part(name, Diffuse { reflectance })
    }
}

/// A metal of microfacets.
pub fn rough_metal(
    metal: Conductor<TextureId>,
    microfacets: Microfacets<TextureId>,
) -> RoughConductor<TextureId> {
    RoughConductor {
        microfacets,
        eta: metal.eta,
        k: metal.k,
        specular_reflectance: metal.specular_reflectance,
    }
}

/// Glass of microfacets.
pub fn rough_glass(
    glass: Dielectric<TextureId>,
    microfacets: Microfacets<TextureId>,
) -> RoughDielectric<TextureId> {
    RoughDielectric {
        microfacets,
        eta: glass.eta,
        specular_reflectance: glass.specular_reflectance,
        specular_transmittance: glass.specular_transmittance,
    }
}

/// Plastic under a rough coat.
pub fn rough_plastic(
    plastic: Plastic<TextureId>,
    distribution: Distribution,
    alpha: TextureId,
) -> RoughPlastic<TextureId> {
    RoughPlastic {
        distribution,
        alpha,
        eta: plastic.eta,
        diffuse_reflectance: plastic.diffuse_reflectance,
        specular_reflectance: plastic.specular_reflectance,
        nonlinear: plastic.nonlinear,
        transmittance: (),
    }
}

/// The plastic of polarized light.
pub fn polarized_plastic(
    plastic: Plastic<TextureId>,
    microfacets: Microfacets<TextureId>,
) -> PolarizedPlastic<TextureId> {
    PolarizedPlastic {
        microfacets,
        eta: plastic.eta,
        diffuse_reflectance: plastic.diffuse_reflectance,
        specular_reflectance: plastic.specular_reflectance,
    }
}

/// Gives a shape the material, on both sides if it is one that has only one.
pub fn make<B: Into<Bsdf>>(scene: &mut Scene, shape: &str, material: impl FnOnce(&mut Slots) -> B) {
    let id = format!("{shape}.bsdf");
    let place = scene.materials.iter().position(|m| m.id == id);
    let place = place.expect("the material of a shape");
    let bsdf = material(&mut Slots {
        scene,
        material: id,
    });
    let bsdf = bsdf.into();
    let is_clear = matches!(
        bsdf,
        Bsdf::Plain(
            Lobe::Dielectric(_)
                | Lobe::RoughDielectric(_)
                | Lobe::ThinDielectric(_)
                | Lobe::Principled(_)
                | Lobe::PrincipledThin(_)
        ) | Bsdf::Mask { .. }
    );
    scene.materials[place].bsdf = bsdf;
    if is_clear {
        let shape = scene.shapes_mut().find(|s| s.id == shape);
        shape.expect("a shape").bsdf = BsdfId(place as u32);
        scene.materials[place + 1].bsdf = Null::default().into(); // not of this shape any more
    }
}

/// Numbers from 0 to 1 that look random.
fn scattered(count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(|i| ((i * i * 7 + i * 13) % 17) as f64 / 16.0)
}

/// A bitmap of `size` by `size` texels, repeated twice along both coordinates.
pub fn bitmap(id: String, size: usize, channels: usize, data: Vec<f64>) -> Texture {
    Texture {
        id,
        channels,
        data,
        pattern: Pattern::Bitmap(Bitmap {
            width: size as u32,
            height: size as u32,
            filter: TexelFilter::Bilinear,
            wrap: Wrap::Repeat,
            to_uv: UvTransform {
                rows: [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
            },
        }),
    }
}

impl Slots<'_> {
    /// A material under a map of normals that turn by up to 30 degrees.
    pub fn normal_map(&mut self, nested: BsdfId) -> Bsdf {
        let size = 4;
        let turns = scattered(2 * size * size).map(|x| 0.5 + 0.4 * (x - 0.5));
        let turns: Vec<f64> = turns.collect();
        let data = turns.chunks(2).flat_map(|xy| [xy[0], xy[1], 0.95]);
        let normals = bitmap(
            format!("{}.normalmap", self.material),
            size,
            3,
            data.collect(),
        );
        Bsdf::NormalMap {
            normals: self.scene.add_texture(normals),
            nested,
            limits: SMOOTH_LIMITS,
        }
    }

    /// A material under a map of bumps, of heights up to `height`.
    pub fn bump_map(&mut self, height: f64, nested: BsdfId) -> Bsdf {
        let size = 6;
        let data = scattered(size * size).collect();
        let heights = bitmap(format!("{}.heights", self.material), size, 1, data);
        Bsdf::BumpMap {
            heights: self.scene.add_texture(heights),
            scale: self.number("scale", height),
            nested,
            limits: SMOOTH_LIMITS,
        }
    }

    /// Half paint, half rough metal.
    pub fn glossy(&mut self) -> BsdfId {
        let metal = rough_metal(self.copper(), self.facets(Distribution::Ggx, 0.4));
        let blend = Bsdf::Blend {
            weight: self.number("weight", 0.5),
            nested: [
                self.diffuse("paint", [0.7, 0.5, 0.3]),
                self.part("metal", metal),
            ],
        };
        self.part("glossy", blend)
    }
}

/// What maps of normals do by default: nothing is discontinuous.
pub const SMOOTH_LIMITS: NormalLimits = NormalLimits {
    flip_invalid: true,
    shadowing: true,
};
