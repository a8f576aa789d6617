//! How what a surface scatters depends on the values of its textures: the material is evaluated with
//! numbers that have derivatives, three at a time.

use capwalk_math::rgb::LUMINANCE;
use capwalk_math::{Dual, Frame, Real, Rgb, Vec3};
use capwalk_scene::lobe::{LocalBsdf, Side, Specular};
use capwalk_scene::resolve::{Resolver, TexturesAt};
use capwalk_scene::{BsdfId, Scene, Shape, Slot, TextureId};

use crate::lanes::step::Vertices;
use crate::scene_eval::Primal;
use crate::shading::Textures;

/// A vertex of one of the paths.
pub struct Place<'a> {
    /// The face that it is on.
    pub face: u32,
    /// Which path.
    pub lane: usize,
    /// The vertices of all.
    pub vertices: &'a Vertices,
}

/// Light that arrives at a surface.
#[derive(Clone, Copy, Debug)]
pub struct Arriving {
    /// The unit direction that it comes from.
    pub direction: Vec3,
    /// The specular event by which it is seen.
    pub specular: Option<Specular>,
    /// On the BSDF times the cosine, or on the fraction of light of the event; of what is diffuse, on
    /// the reflectance.
    pub covector: Rgb,
}

/// A number of a texture's value that derivatives are asked for with respect to.
#[derive(Clone, Copy, Debug)]
pub struct AskedNumber {
    texture: TextureId,
    channel: Channel,
}

/// Which number of a texture's value.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Channel {
    /// The only one of a grey.
    Grey,
    /// The luminance, which is all of a colour that matters.
    Luminance,
    /// One of three.
    Of(usize),
}

/// The covector on the value of a texture.
pub enum OnTexture {
    /// By channels of light: those of the value change one each, or its only one all.
    Alike(Rgb),
    /// For each channel of the value by channels of light.
    Mixed([Rgb; 3]),
}

/// How many derivatives are taken together.
const TOGETHER: usize = 3;

/// The numbers in some places of a material, each texture once, and all channels of one one after
/// the other.
pub fn asked_numbers(
    scene: &Scene,
    shape: &Shape,
    slots: impl Iterator<Item = Slot>,
) -> Vec<AskedNumber> {
    let mut textures: Vec<(TextureId, bool)> = slots
        .map(|slot| (slot.texture, slot.quantity.is_number()))
        .collect();
    // One that is a colour somewhere comes first, as that.
    textures.sort_unstable();
    textures.dedup_by_key(|(texture, _)| *texture);
    let numbers = textures.into_iter().flat_map(|(texture, is_number)| {
        let channels = scene.texture(scene.numbers_of(texture, shape)).channels;
        let of_texture = match (channels, is_number) {
            (1, _) => vec![Channel::Grey],
            (_, true) => vec![Channel::Luminance],
            (_, false) => [0, 1, 2].map(Channel::Of).to_vec(),
        };
        let asked = move |channel| AskedNumber { texture, channel };
        of_texture.into_iter().map(asked)
    });
    numbers.collect()
}

/// A surface that scatters light at a point.
pub struct Scatterer<'a> {
    pub scene: &'a Scene,
    pub resolver: &'a Resolver,
    pub material: BsdfId,
    /// Which side is seen, the shading frame outside, and the unit direction to who sees it.
    pub side: Side,
    pub frame: Frame<f64>,
    pub to_viewer: Vec3,
    pub textures: &'a mut Textures<'a, f64, Primal<'a>>,
}

impl Scatterer<'_> {
    /// From the covectors on what is scattered to those on the values of textures.
    pub fn pull(
        mut self,
        asked: &[AskedNumber],
        arrives: &[Option<Arriving>; 2],
        mut depends: impl FnMut(TextureId, OnTexture),
    ) {
        let mut rest = asked;
        while let Some(first) = rest.first() {
            // One texture, whose channels come one after the other, or some that have one number.
            let is_channel = |number: &AskedNumber| matches!(number.channel, Channel::Of(_));
            let count = match is_channel(first) {
                true => 3,
                false => {
                    let single = rest.iter().take_while(|number| !is_channel(number));
                    single.count().min(TOGETHER)
                }
            };
            let (some, others) = rest.split_at(count);
            rest = others;
            let on_numbers = match some.len() {
                1 => {
                    let [only] = self.derivatives::<1>(some, arrives);
                    [only, Rgb::zero(), Rgb::zero()]
                }
                _ => self.derivatives::<TOGETHER>(some, arrives),
            };
            if is_channel(first) {
                depends(first.texture, by_channels(on_numbers));
                continue;
            }
            for (number, covector) in some.iter().zip(on_numbers) {
                let on_texture = match number.channel {
                    Channel::Luminance => {
                        let shares = LUMINANCE.to_array();
                        OnTexture::Mixed(shares.map(|share| covector * share))
                    }
                    _ => OnTexture::Alike(covector),
                };
                depends(number.texture, on_texture);
            }
        }
    }

    /// The covectors on some numbers, by channels of light.
    fn derivatives<const N: usize>(
        &mut self,
        numbers: &[AskedNumber],
        arrives: &[Option<Arriving>; 2],
    ) -> [Rgb; N] {
        let mut bsdf = LocalBsdf::default();
        let mut textures = Varied {
            textures: self.textures,
            numbers,
        };
        let (scene, material) = (self.scene, self.material);
        let flipped =
            (self.resolver).resolve_into(scene, material, self.side, &mut textures, &mut bsdf);
        // What has no weight may have a derivative.
        bsdf.explore();
        let front = if flipped { -1.0 } else { 1.0 };
        let to_local = |direction| {
            let local = self.frame.to_local(direction);
            Vec3::<Dual<N>>::constant(Vec3::new(local.x, local.y, front * local.z))
        };
        let wi = to_local(self.to_viewer);
        let mut sums = [Rgb::zero(); N];
        for light in arrives.iter().flatten() {
            let scattered = match light.specular {
                Some(event) => bsdf.specular(event, wi).1,
                None => bsdf.eval(wi, to_local(light.direction)),
            };
            for (i, sum) in sums.iter_mut().enumerate() {
                *sum += scattered.map(|channel| channel.tangent[i]) * light.covector;
            }
        }
        sums
    }
}

/// The covectors on the channels of a value, which have one each if they change one each.
fn by_channels(covectors: [Rgb; 3]) -> OnTexture {
    let [r, g, b] = covectors;
    let others = [r.g, r.b, g.r, g.b, b.r, b.g];
    match others == [0.0; 6] {
        true => OnTexture::Alike(Rgb::new(r.r, g.g, b.b)),
        false => OnTexture::Mixed(covectors),
    }
}

/// The textures at a point, with derivatives with respect to some numbers of their values.
struct Varied<'a, 'b> {
    textures: &'a mut Textures<'b, f64, Primal<'b>>,
    numbers: &'a [AskedNumber],
}

impl<const N: usize> TexturesAt<Dual<N>> for Varied<'_, '_> {
    fn value(&mut self, id: TextureId) -> Rgb<Dual<N>> {
        let mut value = self.textures.value(id).map(Dual::constant);
        for (i, number) in self.numbers.iter().enumerate() {
            if number.texture == id {
                let channels = [&mut value.r, &mut value.g, &mut value.b];
                for (channel, x) in channels.into_iter().enumerate() {
                    let others = matches!(number.channel, Channel::Of(own) if own != channel);
                    x.tangent[i] = if others { 0.0 } else { 1.0 };
                }
            }
        }
        value
    }
    fn gradient(&mut self, id: TextureId) -> [Rgb<Dual<N>>; 2] {
        // Numbers that turn the surface are not asked for.
        let slopes = self.textures.gradient(id);
        slopes.map(|slope| slope.map(Dual::constant))
    }
    fn may_change(&self, id: TextureId) -> bool {
        self.textures.may_change(id)
    }
}
