//! Lights without extent: a surface point sees each in one direction.

use std::f64::consts::PI;

use capwalk_math::{Real, Vec3};

use super::Emitter;
use crate::ids::TextureId;

/// What a surface point receives of a light without extent.
#[derive(Clone, Copy, Debug)]
pub struct DeltaLight<R> {
    /// Unit direction towards the light.
    pub direction: Vec3<R>,
    /// Its distance, world units; infinite for parallel light.
    pub distance: f64,
    /// Irradiance across the direction, per intensity (or irradiance) of the
    /// light.
    pub factor: R,
    /// Where in its image, for a light that projects one; otherwise its number is the
    /// same everywhere.
    pub uv: Option<[R; 2]>,
}

impl Emitter {
    /// The vectors that place a light without extent: first where it is, or where its light
    /// goes, as in [`Emitter::apex`], then its three unit axes, if it shines along the last of
    /// them. Other emitters have none.
    pub fn anchors(&self) -> Vec<Vec3> {
        match self {
            Self::Area { .. } | Self::Constant { .. } | Self::EnvironmentMap { .. } => Vec::new(),
            Self::Point { position, .. } => vec![*position],
            Self::Spot {
                world_from_emitter, ..
            }
            | Self::Projector {
                world_from_emitter, ..
            } => {
                let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
                let axes = axes.map(|axis| world_from_emitter.vector(axis.into()).normalized());
                let [x, y, z] = axes;
                vec![world_from_emitter.translation, x, y, z]
            }
            Self::Directional { direction, .. } => vec![*direction],
        }
    }

    /// True if an anchor is a point: it moves with the light; the others turn with it.
    pub fn anchor_is_point(&self, anchor: usize) -> bool {
        anchor == 0 && !matches!(self, Self::Directional { .. })
    }

    /// How a point receives the light, or `None` if the light has an extent or
    /// does not shine there. Continuous in the point, but at the light itself.
    /// `anchor` knows the [`anchors`](Self::anchors), `number` the numbers of constant
    /// textures.
    pub fn delta_light<R: Real>(
        &self,
        point: Vec3<R>,
        anchor: impl Fn(usize) -> Vec3<R>,
        number: impl Fn(TextureId) -> R,
    ) -> Option<DeltaLight<R>> {
        match self {
            Self::Area { .. } | Self::Constant { .. } | Self::EnvironmentMap { .. } => None,
            Self::Directional { .. } => Some(DeltaLight {
                direction: -anchor(0),
                distance: f64::INFINITY,
                factor: R::constant(1.0),
                uv: None,
            }),
            Self::Point { .. } => from_point(point, anchor(0)),
            Self::Spot {
                cutoff_angle,
                beam_width,
                texture,
                ..
            } => {
                let light = from_point(point, anchor(0))?;
                let cos = -light.direction.dot(anchor(3));
                let radians = |id| number(id) * R::constant(1.0_f64.to_radians());
                let falloff = falloff(cos, radians(*cutoff_angle), radians(*beam_width))?;
                let uv = texture.map(|_| {
                    let (sin, cos) = radians(*cutoff_angle).sin_cos();
                    let half = R::constant(0.5) * cos / sin;
                    let [x, y, depth] = seen_from_emitter(point, &anchor);
                    [x, y].map(|x| R::constant(0.5) + x / depth * half)
                });
                let factor = light.factor * falloff;
                Some(DeltaLight {
                    factor,
                    uv,
                    ..light
                })
            }
            Self::Projector { half_size, .. } => from_projector(point, anchor, *half_size),
        }
    }
}

fn from_point<R: Real>(point: Vec3<R>, position: Vec3<R>) -> Option<DeltaLight<R>> {
    let offset = position - point;
    let squared = offset.length_squared();
    if squared.value() == 0.0 {
        return None;
    }
    Some(DeltaLight {
        direction: offset.normalized(),
        distance: squared.value().sqrt(),
        factor: R::constant(1.0) / squared,
        uv: None,
    })
}

/// A point in the coordinates of an emitter with axes.
fn seen_from_emitter<R: Real>(point: Vec3<R>, anchor: &impl Fn(usize) -> Vec3<R>) -> [R; 3] {
    let offset = point - anchor(0);
    [1, 2, 3].map(|axis| offset.dot(anchor(axis)))
}

/// What a point receives of an image, with the falloff of Mitsuba's `projector`, by which
/// a plane across the axis is lit as brightly everywhere.
fn from_projector<R: Real>(
    point: Vec3<R>,
    anchor: impl Fn(usize) -> Vec3<R>,
    half_size: [f64; 2],
) -> Option<DeltaLight<R>> {
    let light = from_point(point, anchor(0))?;
    let [x, y, depth] = seen_from_emitter(point, &anchor);
    if depth.value() <= 0.0 {
        return None;
    }
    // Images begin at the top left, where x and y are largest.
    let place = |x: R, half: f64| R::constant(0.5) - x / depth * R::constant(0.5 / half);
    let uv = [place(x, half_size[0]), place(y, half_size[1])];
    if uv.iter().any(|x| !(0.0..=1.0).contains(&x.value())) {
        return None;
    }
    // π / (depth² cos), where cos = depth / distance and the factor is 1 / distance².
    let factor = R::constant(PI) / (light.factor.sqrt() * depth * depth * depth);
    Some(DeltaLight {
        factor,
        uv: Some(uv),
        ..light
    })
}

/// Part of the full intensity at an angle to the axis with this cosine.
fn falloff<R: Real>(cos: R, cutoff_angle: R, beam_width: R) -> Option<R> {
    let angle = cos.value().clamp(-1.0, 1.0).acos();
    if angle >= cutoff_angle.value() {
        return None;
    }
    if angle <= beam_width.value() {
        return Some(R::constant(1.0));
    }
    // d acos(x) = -dx / sin, and sin is not zero here: the angle is above
    // `beam_width` and below `cutoff_angle`.
    let derivative = R::constant(-1.0 / angle.sin());
    let moving = R::constant(angle) + (cos - R::constant(cos.value())) * derivative;
    Some((cutoff_angle - moving) / (cutoff_angle - beam_width))
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_math::{Affine, Dual};

    /// The spot's angles, degrees.
    fn angles(id: TextureId) -> f64 {
        [0.0, 30.0, 12.0][id.0 as usize]
    }

    /// The light where it stands.
    fn light_at(emitter: &Emitter, point: Vec3) -> Option<DeltaLight<f64>> {
        let anchors = emitter.anchors();
        emitter.delta_light(point, |i| anchors[i], angles)
    }

    fn spot() -> Emitter {
        let up = Vec3::new(0.0, 1.0, 0.0);
        let (origin, target) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(0.5, -1.0, 2.0));
        Emitter::Spot {
            id: "spot".into(),
            world_from_emitter: Affine::look_at(origin, target, up).expect("not along up"),
            intensity: TextureId(0),
            cutoff_angle: TextureId(1),
            beam_width: TextureId(2),
            texture: Some(TextureId(3)),
        }
    }

    fn projector() -> Emitter {
        let Emitter::Spot {
            world_from_emitter, ..
        } = spot()
        else {
            unreachable!()
        };
        Emitter::Projector {
            id: "projector".into(),
            world_from_emitter,
            half_size: [0.8, 0.5],
            irradiance: TextureId(0),
            scale: TextureId(1),
        }
    }

    /// The top left corner of an image is in the direction of `+x` and `+y`; a plane across
    /// the axis receives as much everywhere, π at distance 1; outside it is dark.
    #[test]
    fn projectors_throw_their_image_upright() {
        let Emitter::Projector {
            world_from_emitter, ..
        } = projector()
        else {
            unreachable!()
        };
        let at = |local: Vec3| light_at(&projector(), world_from_emitter.point(local));
        for (x, y, uv) in [(0.4, 0.25, [0.25, 0.25]), (-0.64, -0.1, [0.9, 0.6])] {
            let light = at(Vec3::new(x, y, 1.0) * 2.0).expect("in the image");
            let found = light.uv.expect("an image");
            assert!(
                (0..2).all(|i| (found[i] - uv[i]).abs() < 1e-12),
                "{found:?}"
            );
            let cos = 1.0 / Vec3::new(x, y, 1.0).length();
            assert!((light.factor * cos - PI / 4.0).abs() < 1e-12);
        }
        for outside in [[0.81, 0.0, 1.0], [0.0, -0.51, 1.0], [0.1, 0.1, -1.0]] {
            assert!(at(outside.into()).is_none(), "{outside:?}");
        }
    }

    /// Points at known angles to the axis.
    #[test]
    fn spots_fall_off_linearly_with_the_angle() {
        let Emitter::Spot {
            world_from_emitter, ..
        } = spot()
        else {
            unreachable!()
        };
        for (degrees, expected) in [(0.0, 1.0), (11.9, 1.0), (21.0, 0.5), (29.4, 1.0 / 30.0)] {
            let angle = f64::to_radians(degrees);
            let local = Vec3::new(0.0, f64::sin(angle), f64::cos(angle)) * 2.0;
            let light = light_at(&spot(), world_from_emitter.point(local));
            let light = light.expect("within the cone");
            assert!((light.factor - expected / 4.0).abs() < 1e-12, "{angle}");
            assert!((light.distance - 2.0).abs() < 1e-12);
            // The border of the cone is at the border of the image.
            let [u, v] = light.uv.expect("an image");
            let expected = 0.5 + 0.5 * angle.tan() / f64::to_radians(30.0).tan();
            assert!((u - 0.5).abs() < 1e-12 && (v - expected).abs() < 1e-12);
        }
        for angle in [0.53, 1.0, 3.0] {
            let local = Vec3::new(f64::sin(angle), 0.0, f64::cos(angle));
            let point = world_from_emitter.point(local);
            assert!(light_at(&spot(), point).is_none(), "{angle}");
        }
    }

    /// Derivatives by the point and by what places the light, against central differences, in
    /// the beam, on its edge, and of the other lights.
    #[test]
    fn lights_differentiate_by_places() {
        let lights = [
            spot(),
            projector(),
            Emitter::Point {
                id: "point".into(),
                position: Vec3::new(0.4, 0.1, 2.0),
                intensity: TextureId(0),
            },
            Emitter::Directional {
                id: "sun".into(),
                direction: Vec3::new(0.0, -0.6, 0.8),
                irradiance: TextureId(0),
            },
        ];
        let h = 1e-6;
        for light in lights {
            for point in [Vec3::new(0.7, 0.2, 2.4), Vec3::new(1.3, 0.9, 2.2)] {
                let velocity = Vec3::new(0.3, -1.0, 0.7);
                // Axes stay unit vectors.
                let anchors = light.anchors();
                let turn = Vec3::new(0.5, 0.1, -0.3);
                let turns: Vec<Vec3> = anchors.iter().map(|&anchor| turn.cross(anchor)).collect();
                let at = |t: f64| {
                    let anchor = |i: usize| anchors[i] + turns[i] * t;
                    let light = light.delta_light(point + velocity * t, anchor, angles);
                    light.expect("lit")
                };
                let dual = light
                    .delta_light(
                        point.with_tangent(velocity),
                        |i| anchors[i].with_tangent(turns[i]),
                        |id| Dual::constant(angles(id)),
                    )
                    .expect("lit");
                let (above, below) = (at(h), at(-h));
                let factor = (above.factor - below.factor) / (2.0 * h);
                let direction = (above.direction - below.direction) / (2.0 * h);
                assert!((dual.factor.tangent[0] - factor).abs() < 1e-8, "{light:?}");
                assert!((dual.direction.tangent(0) - direction).length() < 1e-8);
                let uvs = [dual.uv, None].into_iter().flatten().flatten();
                let differences = above
                    .uv
                    .zip(below.uv)
                    .map(|(a, b)| [a[0] - b[0], a[1] - b[1]]);
                for (uv, difference) in uvs.zip(differences.into_iter().flatten()) {
                    assert!((uv.tangent[0] - difference / (2.0 * h)).abs() < 1e-8);
                }
                assert_eq!(dual.direction.value(), at(0.0).direction);
            }
        }
    }
}
