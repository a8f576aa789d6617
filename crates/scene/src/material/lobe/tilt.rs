//! Lobes about a normal of their own, as normal and bump maps give them.

use capwalk_math::{Frame, Real, Vec3};

use crate::material::bsdf::NormalLimits;

/// The frame of a lobe within the shading frame: the surface looks as if it were
/// tilted, but stays where it is.
///
/// Light comes and goes on the side of both normals, the shading normal and this
/// one, as in Mitsuba 3's `normalmap` and `bumpmap`. A viewer whom the normal
/// turns away from sees the lobe mirrored at it, like one behind an interpolated
/// normal: Mitsuba turns the normal over, which would be a discontinuity that no edge
/// carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tilt<R = f64> {
    frame: Frame<R>,
    limits: NormalLimits,
}

impl<R: Real> Tilt<R> {
    /// The tilt to a normal, given in the shading frame with any length but zero.
    /// The first tangent stays as it is as far as it can.
    pub fn new(normal: Vec3<R>, limits: NormalLimits) -> Self {
        let tangent = Vec3::constant(Vec3::new(1.0, 0.0, 0.0));
        Self {
            frame: Frame::from_normal_and_tangent(normal.normalized(), tangent),
            limits,
        }
    }

    /// A direction of the shading frame in the lobe's frame.
    #[inline]
    pub(super) fn turned(&self, w: Vec3<R>) -> Vec3<R> {
        self.frame.to_local(w)
    }

    /// A direction of the lobe's frame in the shading frame.
    #[inline]
    pub(super) fn turned_back(&self, w: Vec3<R>) -> Vec3<R> {
        self.frame.to_world(w)
    }

    /// True if a viewer sees nothing: the normal turns away, and is not to be
    /// turned back.
    #[inline]
    pub(super) fn is_turned_away(&self, wi: Vec3<R>) -> bool {
        !self.limits.flip_invalid && !self.is_on_one_side(wi)
    }

    /// True if a direction of the shading frame is on the same side of the shading
    /// normal and of the lobe's.
    #[inline]
    pub(super) fn is_on_one_side(&self, w: Vec3<R>) -> bool {
        w.z.value() * self.frame.n.dot(w).value() > 0.0
    }

    /// The fraction of light to or from `wo` that the bumps do not hide, after
    /// Estevez, Lecocq and Stein, "A Microfacet-Based Shadowing Function to Solve
    /// the Bump Terminator Problem" (Ray Tracing Gems, 2019): Smith's shadowing
    /// by facets as rough as the normal is tilted. Zero on the wrong side.
    #[inline]
    pub(super) fn shown(&self, wo: Vec3<R>) -> R {
        let one = R::constant(1.0);
        if !self.is_on_one_side(wo) {
            return R::constant(0.0);
        }
        if !self.limits.shadowing {
            return one;
        }
        let cos2 = self.frame.n.z.squared();
        let alpha2 = R::constant(0.125) * (one - cos2) / cos2;
        let alpha2 = if alpha2.value() < 1.0 { alpha2 } else { one };
        let cos = wo.z.abs();
        let spread = (cos.squared() + alpha2 * (one - cos.squared())).sqrt();
        R::constant(2.0) * cos / (cos + spread)
    }

    pub(super) fn map<S: Real>(&self, f: &mut impl FnMut(R) -> S) -> Tilt<S> {
        let mut map = |v: Vec3<R>| Vec3::new(f(v.x), f(v.y), f(v.z));
        Tilt {
            frame: Frame {
                s: map(self.frame.s),
                t: map(self.frame.t),
                n: map(self.frame.n),
            },
            limits: self.limits,
        }
    }
}
