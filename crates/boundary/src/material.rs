//! What the materials of shapes ask of a surface, and which of their specular events
//! keep images in shape.

use capwalk_math::{Real, Vec3};
use capwalk_scene::lobe::{Event, Lobe};
use capwalk_scene::material::{Anisotropy, MaterialTraits};
use capwalk_scene::{Bsdf, BsdfId, Integrator, Pattern, Scene, Shape, Texture, TextureId};

/// True if the value or a derivative depends on how a material is rotated about the
/// normal.
pub fn needs_tangent(scene: &Scene, id: BsdfId) -> bool {
    any_part(scene, id, |bsdf| {
        bsdf.traits().anisotropy != Anisotropy::Isotropic
    }) || scene.map_in(id).is_some()
}

/// True if shading depends on where on a face of a shape a ray hits it, besides the
/// position: by interpolated normals, textures, or AOVs of these.
pub fn needs_place(scene: &Scene, shape: &Shape) -> bool {
    let mut textures = textures_of(scene, shape).into_iter();
    shape.normals.per_vertex().is_some()
        || textures.any(|texture| !texture.is_constant())
        || matches!(scene.settings.integrator, Integrator::Aov(_))
}

/// True if the value depends on how a material is rotated about the normal.
pub fn depends_on_rotation(scene: &Scene, id: BsdfId) -> bool {
    any_part(scene, id, |bsdf| is_anisotropic(scene, bsdf))
}

fn is_anisotropic(scene: &Scene, bsdf: &Bsdf) -> bool {
    match bsdf.traits().anisotropy {
        Anisotropy::Isotropic => false,
        Anisotropy::Anisotropic => true,
        Anisotropy::By(amount) => {
            let amount = scene.texture(amount);
            let is_attribute = matches!(amount.pattern, Pattern::MeshAttribute { .. });
            is_attribute || amount.data.iter().any(|&x| x != 0.0)
        }
    }
}

/// True if a material can reflect, refract or pass light in one direction alone.
pub fn may_be_specular(scene: &Scene, id: BsdfId) -> bool {
    any_part(scene, id, |bsdf| {
        let traits = bsdf.traits();
        traits.is_specular || traits.passes_light
    })
}

/// True if a material blends two that may refract light in two directions, or reflect it, with a normal map in one of
/// them.
pub fn blends_images(scene: &Scene, id: BsdfId) -> bool {
    let Bsdf::Blend { nested, .. } = &scene.material(id).bsdf else {
        return false;
    };
    let both = |has: fn(&MaterialTraits) -> bool| {
        let has = |&part: &BsdfId| any_part(scene, part, |bsdf| has(&bsdf.traits()));
        nested.iter().all(has)
    };
    let is_turned = nested.iter().any(|&part| scene.map_in(part).is_some());
    both(|traits| traits.refracts) || is_turned && both(|traits| traits.is_specular)
}

/// True if a material does nothing but reflect, refract or pass light in one direction.
pub fn is_purely_specular(scene: &Scene, id: BsdfId) -> bool {
    let all = |nested: &[BsdfId]| nested.iter().all(|&part| is_purely_specular(scene, part));
    match &scene.material(id).bsdf {
        Bsdf::Plain(Lobe::Conductor(_) | Lobe::Dielectric(_) | Lobe::ThinDielectric(_)) => true,
        Bsdf::TwoSided { front, back } => all(&[*front, *back]),
        Bsdf::Mask { nested, .. }
        | Bsdf::NormalMap { nested, .. }
        | Bsdf::BumpMap { nested, .. } => all(&[*nested]),
        Bsdf::Blend { nested, .. } => all(nested),
        Bsdf::Plain(_) => false,
    }
}

/// Which perfectly specular events at a shape keep images in shape.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FlatEvents {
    /// Reflection by a plane.
    reflects: bool,
    /// Passing straight on.
    passes: bool,
}

impl FlatEvents {
    /// The events.
    pub fn iter(self) -> impl Iterator<Item = Event> {
        let reflects = self.reflects.then_some(Event::Reflect);
        let passes = self.passes.then_some(Event::Pass);
        reflects.into_iter().chain(passes)
    }

    /// True if the event is one of them.
    pub fn contains(self, event: Event) -> bool {
        self.iter().any(|own| own == event)
    }

    /// True if there are none.
    pub fn is_empty(self) -> bool {
        self.iter().next().is_none()
    }
}

/// Which perfectly specular events at a shape keep images in shape: mirrors must
/// be flat, panes may be bent.
pub fn flat_events(scene: &Scene, shape: &Shape) -> FlatEvents {
    let turns = scene.map_in(shape.bsdf).is_some();
    let is_flat = shape.normals.per_vertex().is_none() && !turns;
    FlatEvents {
        reflects: is_flat && any_part(scene, shape.bsdf, |bsdf| bsdf.traits().is_specular),
        passes: any_part(scene, shape.bsdf, |bsdf| bsdf.traits().passes_light),
    }
}

/// True if a shape shows bent images in perfectly specular reflection or refraction: the
/// silhouettes in them are not covered.
pub fn bends_images(scene: &Scene, shape: &Shape) -> bool {
    let has =
        |of: fn(&MaterialTraits) -> bool| any_part(scene, shape.bsdf, |bsdf| of(&bsdf.traits()));
    let is_flat = flat_events(scene, shape).contains(Event::Reflect);
    has(|traits| traits.refracts) || (has(|traits| traits.is_specular) && !is_flat)
}

/// True if something holds for a material, or one that it is made of.
fn any_part(scene: &Scene, id: BsdfId, holds: impl Fn(&Bsdf) -> bool) -> bool {
    let mut parts = scene.materials_below(id).into_iter();
    parts.any(|part| holds(&scene.material(part).bsdf))
}

/// How the position on a face of a shape changes with each texture coordinate,
/// for edges from its first corner to the others; `None` without usable texture
/// coordinates.
pub fn tangents_of_face<R: Real>(
    shape: &Shape,
    face: usize,
    edges: [Vec3<R>; 2],
) -> Option<[Vec3<R>; 2]> {
    let [[u0, v0], [u1, v1], [u2, v2]] = shape.uvs.as_ref()?[face];
    let (du1, dv1, du2, dv2) = (u1 - u0, v1 - v0, u2 - u0, v2 - v0);
    let scale = 1.0 / (du1 * dv2 - du2 * dv1);
    let along = |a: f64, b: f64| {
        let [a, b] = [a, b].map(|x| R::constant(x * scale));
        edges[0] * a + edges[1] * b
    };
    let tangents = [along(dv2, -dv1), along(-du2, du1)];
    let are_finite = tangents.iter().all(|tangent| tangent.value().is_finite());
    are_finite.then_some(tangents)
}

/// The textures on which the appearance of a shape depends: those of its materials and of
/// its emission, with attributes in place of the textures that refer to them.
pub fn textures_of<'s>(scene: &'s Scene, shape: &Shape) -> Vec<&'s Texture> {
    let mut ids: Vec<TextureId> = shape
        .emitter
        .map(|id| scene.emitter(id).radiance())
        .into_iter()
        .collect();
    ids.extend(
        scene
            .slots_below(shape.bsdf)
            .iter()
            .map(|slot| slot.texture),
    );
    let shown = |id| scene.texture(scene.numbers_of(id, shape));
    ids.into_iter().map(shown).collect()
}
