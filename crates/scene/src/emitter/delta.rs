//! Lights without extent: a surface point sees each in one direction.

use capwalk_math::{Affine, Real, Vec3};

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
}

impl Emitter {
    /// How a point receives the light, or `None` if the light has an extent or
    /// does not shine there. Continuous in the point, but at the light itself.
    /// `number` knows the numbers of constant textures.
    pub fn delta_light<R: Real>(
        &self,
        point: Vec3<R>,
        number: impl Fn(TextureId) -> R,
    ) -> Option<DeltaLight<R>> {
        match self {
            Self::Area { .. } | Self::Constant { .. } | Self::EnvironmentMap { .. } => None,
            Self::Directional { direction, .. } => Some(DeltaLight {
                direction: Vec3::constant(-*direction),
                distance: f64::INFINITY,
                factor: R::constant(1.0),
            }),
            Self::Point { position, .. } => from_point(point, *position),
            Self::Spot {
                world_from_emitter,
                cutoff_angle,
                beam_width,
                ..
            } => {
                let light = from_point(point, world_from_emitter.translation)?;
                let axis = spot_axis(world_from_emitter);
                let cos = -light.direction.dot(Vec3::constant(axis));
                let radians = |id| number(id) * R::constant(1.0_f64.to_radians());
                let falloff = falloff(cos, radians(*cutoff_angle), radians(*beam_width))?;
                let factor = light.factor * falloff;
                Some(DeltaLight { factor, ..light })
            }
        }
    }
}

/// Where a spot light shines, a unit vector.
fn spot_axis(world_from_emitter: &Affine) -> Vec3 {
    world_from_emitter
        .vector(Vec3::new(0.0, 0.0, 1.0))
        .normalized()
}

fn from_point<R: Real>(point: Vec3<R>, position: Vec3) -> Option<DeltaLight<R>> {
    let offset = Vec3::constant(position) - point;
    let squared = offset.length_squared();
    if squared.value() == 0.0 {
        return None;
    }
    Some(DeltaLight {
        direction: offset.normalized(),
        distance: squared.value().sqrt(),
        factor: R::constant(1.0) / squared,
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
    use capwalk_math::Dual;

    /// The spot's angles, degrees.
    fn angles(id: TextureId) -> f64 {
        [0.0, 30.0, 12.0][id.0 as usize]
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
            let light = spot().delta_light(world_from_emitter.point(local), angles);
            let light = light.expect("within the cone");
            assert!((light.factor - expected / 4.0).abs() < 1e-12, "{angle}");
            assert!((light.distance - 2.0).abs() < 1e-12);
        }
        for angle in [0.53, 1.0, 3.0] {
            let local = Vec3::new(f64::sin(angle), 0.0, f64::cos(angle));
            let point = world_from_emitter.point(local);
            assert!(spot().delta_light(point, angles).is_none(), "{angle}");
        }
    }

    /// Derivatives by the point, against central differences, in the beam, on
    /// its edge, and of the other lights.
    #[test]
    fn lights_differentiate_by_the_point() {
        let lights = [
            spot(),
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
                let at = |t: f64| {
                    light
                        .delta_light(point + velocity * t, angles)
                        .expect("lit")
                };
                let dual = light
                    .delta_light(point.with_tangent(velocity), |id| {
                        Dual::constant(angles(id))
                    })
                    .expect("lit");
                let (above, below) = (at(h), at(-h));
                let factor = (above.factor - below.factor) / (2.0 * h);
                let direction = (above.direction - below.direction) / (2.0 * h);
                assert!((dual.factor.tangent[0] - factor).abs() < 1e-8, "{light:?}");
                assert!((dual.direction.tangent(0) - direction).length() < 1e-8);
                assert_eq!(dual.direction.value(), at(0.0).direction);
            }
        }
    }
}
