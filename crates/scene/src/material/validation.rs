//! Which materials contradict themselves.

use capwalk_math::Rgb;

use super::bsdf::Bsdf;
use super::lobe;
use crate::ids::BsdfId;
use crate::scene::Scene;
use crate::scene_error::SceneError;

/// How deep materials may be made of materials.
const MAX_DEPTH: usize = 8;

/// What matters of a material when others are made of it.
#[derive(Clone, Copy, Default)]
struct Summary {
    lobes: usize,
    /// Some part of it shows the same to both sides of itself, but not alike.
    has_inside: bool,
    is_two_sided: bool,
    is_perturbed: bool,
}

impl Scene {
    /// Checks that materials can be resolved: not too many lobes, and nothing
    /// in them that contradicts itself.
    pub(crate) fn check_materials(&self) -> Result<(), SceneError> {
        for (i, material) in self.materials.iter().enumerate() {
            let bad = |problem| SceneError::Material {
                material: material.id.clone(),
                problem,
            };
            self.summary(BsdfId(i as u32), 0).map_err(bad)?;
            self.check_numbers(&material.bsdf).map_err(bad)?;
        }
        Ok(())
    }

    /// Checks what the range of each number alone does not say.
    fn check_numbers(&self, bsdf: &Bsdf) -> Result<(), &'static str> {
        match bsdf {
            Bsdf::Plain(lobe) => lobe.check(&|id| self.texture(id))?,
            Bsdf::NormalMap { normals, .. } => {
                let normals = self.texture(*normals);
                let no_normal = |i: usize| normals.texel(i) == Rgb::splat(0.5);
                if normals.channels != 3 {
                    return Err("a map of normals must have three channels");
                }
                if (0..normals.texels()).any(no_normal) {
                    return Err("a normal in its map is 0 (the colour 0.5, 0.5, 0.5)");
                }
            }
            Bsdf::BumpMap { heights, scale, .. } => {
                if !self.texture(*heights).has_derivatives() {
                    return Err(
                        "the heights of a bump map must be a bitmap with the filter \
                                bilinear",
                    );
                }
                if !self.texture(*scale).is_constant() {
                    return Err("the scale of a bump map must be one number");
                }
            }
            Bsdf::TwoSided { .. } | Bsdf::Mask { .. } | Bsdf::Blend { .. } => {}
        }
        Ok(())
    }

    fn summary(&self, id: BsdfId, depth: usize) -> Result<Summary, &'static str> {
        if depth > MAX_DEPTH {
            return Err("materials stand inside each other too deep; at most 8 may");
        }
        let below = |id: BsdfId| self.summary(id, depth + 1);
        let summary = match &self.material(id).bsdf {
            Bsdf::TwoSided { front, back } => {
                let (front, back) = (below(*front)?, below(*back)?);
                if front.is_two_sided || back.is_two_sided {
                    return Err("a two-sided material must not be made of two-sided ones");
                }
                if front.has_inside || back.has_inside {
                    return Err("a two-sided material must not be made of clear ones");
                }
                Summary {
                    lobes: front.lobes.max(back.lobes),
                    is_two_sided: true,
                    is_perturbed: front.is_perturbed || back.is_perturbed,
                    ..Summary::default()
                }
            }
            Bsdf::Mask { nested, .. } => {
                let nested = below(*nested)?;
                Summary {
                    lobes: nested.lobes + 1,
                    ..nested
                }
            }
            Bsdf::Blend { nested, .. } => {
                let [a, b] = [below(nested[0])?, below(nested[1])?];
                if a.is_two_sided && b.has_inside || b.is_two_sided && a.has_inside {
                    return Err("a blend must not be made of a two-sided and a clear material");
                }
                Summary {
                    lobes: a.lobes + b.lobes,
                    has_inside: a.has_inside || b.has_inside,
                    is_two_sided: a.is_two_sided || b.is_two_sided,
                    is_perturbed: a.is_perturbed || b.is_perturbed,
                }
            }
            Bsdf::NormalMap { nested, .. } | Bsdf::BumpMap { nested, .. } => {
                let nested = below(*nested)?;
                if nested.is_perturbed {
                    return Err("normals are perturbed twice");
                }
                Summary {
                    is_perturbed: true,
                    ..nested
                }
            }
            Bsdf::Plain(lobe) => Summary {
                lobes: 1,
                has_inside: lobe.has_inside(&|id| self.texture(id)),
                ..Summary::default()
            },
        };
        match summary.lobes > lobe::LocalBsdf::<f64>::MAX_LOBES {
            true => Err("it is made of too many materials; at most 4 may be mixed"),
            false => Ok(summary),
        }
    }
}
