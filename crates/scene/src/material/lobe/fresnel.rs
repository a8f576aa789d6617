//! How much light a smooth interface reflects, unpolarized.

use capwalk_math::{Real, Rgb};

/// Cosine of the refracted direction (at least 0) for light that arrives with
/// the cosine `cos_i` (at least 0) at an interface whose far side is optically
/// denser by the factor `eta`; `None` for total internal reflection.
#[inline]
pub fn cos_refracted<R: Real>(cos_i: R, eta: R) -> Option<R> {
    let one = R::constant(1.0);
    let squared = one - (one - cos_i.squared()) / eta.squared(); // Snell's law
    (squared.value() > 0.0).then(|| squared.sqrt())
}

/// Fraction of light reflected by the surface of a dielectric, Fresnel's
/// equations. `cos_i` at least 0, `eta` the refractive index of the far side
/// relative to the near one. One for total internal reflection and, up to
/// rounding, at grazing incidence; zero if the two sides are the same.
#[inline]
pub fn fresnel_dielectric<R: Real>(cos_i: R, eta: R) -> R {
    let one = R::constant(1.0);
    // Snell's law: `eta` times the refracted cosine.
    let eta2 = eta.squared();
    let squared = eta2 - (one - cos_i.squared());
    if squared.value() <= 0.0 {
        return one;
    }
    let refracted = squared.sqrt();
    // Both quotients from one division.
    let (s_sum, p_sum) = (cos_i + refracted, eta2 * cos_i + refracted);
    let inverse = one / (s_sum * p_sum);
    let senkrecht = (cos_i - refracted) * p_sum * inverse;
    let parallel = (eta2 * cos_i - refracted) * s_sum * inverse;
    R::constant(0.5) * (senkrecht.squared() + parallel.squared())
}

/// Fraction of light reflected by a conductor with the complex index
/// `eta + i k`, per channel; `cos_i` at least 0.
#[inline]
pub fn fresnel_conductor<R: Real>(cos_i: R, eta: Rgb<R>, k: Rgb<R>) -> Rgb<R> {
    // Often only the roughness has a derivative, and this has none.
    let numbers = [cos_i, eta.r, eta.g, eta.b, k.r, k.g, k.b];
    match numbers.iter().all(|x| x.is_constant()) {
        true => Rgb::constant(conductor(cos_i.value(), eta.value(), k.value())),
        false => conductor(cos_i, eta, k),
    }
}

fn conductor<R: Real>(cos_i: R, eta: Rgb<R>, k: Rgb<R>) -> Rgb<R> {
    Rgb::new(
        conductor_channel(cos_i, eta.r, k.r),
        conductor_channel(cos_i, eta.g, k.g),
        conductor_channel(cos_i, eta.b, k.b),
    )
}

#[inline]
fn conductor_channel<R: Real>(cos_i: R, eta: R, k: R) -> R {
    let one = R::constant(1.0);
    let half = R::constant(0.5);
    let cos2 = cos_i.squared();
    let sin2 = one - cos2;
    // (a + i b)² = (eta + i k)² - sin². The root of the larger of a² and b²
    // first, the other from their product: nothing cancels, and eta = 0 has a
    // derivative.
    let real = eta.squared() - k.squared() - sin2;
    let product = eta * k;
    if real.value() == 0.0 && product.value() == 0.0 {
        return one; // the critical angle, or an index of zero: all is reflected
    }
    let modulus = (real.squared() + R::constant(4.0) * product.squared()).sqrt();
    // `a` over `scale`, so that all of it takes one division.
    let (a, scale) = if real.value() < 0.0 {
        (product, (half * (modulus - real)).sqrt())
    } else {
        ((half * (modulus + real)).sqrt(), one)
    };
    // Of the perpendicular polarization `(s_sum - s) / (s_sum + s)` is reflected, of the parallel one
    // that times `(p_sum - p) / (p_sum + p)`, where `p = s sin²`: their mean.
    let s = R::constant(2.0) * a * cos_i;
    let s_sum = (modulus + cos2) * scale;
    let p_sum = (modulus * cos2 + sin2.squared()) * scale;
    (s_sum - s) * p_sum / ((s_sum + s) * (p_sum + s * sin2))
}

/// Fraction of diffuse light reflected by the surface of a dielectric, for
/// light that arrives on its near side. Fits by Egan and Hilgeman (1973) for
/// `eta < 1`, by d'Eon and Irving (2011) above; better than 1 % for relative
/// indices from 1/2 to 10.
pub fn fresnel_diffuse<R: Real>(eta: R) -> R {
    let horner = |coefficients: &[f64], x: R| {
        coefficients
            .iter()
            .fold(R::constant(0.0), |sum, &c| sum * x + R::constant(c))
    };
    let inverse = R::constant(1.0) / eta;
    if eta.value() < 1.0 {
        horner(&[-1.4399, 0.7099, 0.6681], eta) + R::constant(0.0636) * inverse
    } else {
        let coefficients = [-1.36881, 4.98554, -7.80989, 6.75335, -3.4793, 0.919317];
        horner(&coefficients, inverse)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Normal incidence, Brewster's angle, the critical angle, equal indices.
    #[test]
    fn dielectric_has_its_landmarks() {
        let eta: f64 = 1.5;
        assert!((fresnel_dielectric(1.0, eta) - 0.04).abs() < 1e-15);
        assert!((fresnel_dielectric(1.0, 1.0 / eta) - 0.04).abs() < 1e-15);
        // At Brewster's angle only one polarization is left: half of
        // ((eta² - 1) / (eta² + 1))².
        let brewster = (1.0 / (1.0 + eta * eta)).sqrt();
        let left = 0.5 * ((eta * eta - 1.0) / (eta * eta + 1.0)).powi(2);
        assert!((fresnel_dielectric(brewster, eta) - left).abs() < 1e-15);
        let critical = (1.0 - 1.0 / (eta * eta)).sqrt();
        assert_eq!(fresnel_dielectric(critical * 0.999, 1.0 / eta), 1.0);
        assert!(fresnel_dielectric(critical * 1.001, 1.0 / eta) < 0.9);
        assert_eq!(fresnel_dielectric(0.0, eta), 1.0);
        assert!(fresnel_dielectric(0.3, 1.0) < 1e-30);
    }

    /// What one side reflects, so does the other along the refracted direction.
    #[test]
    fn dielectric_is_the_same_from_both_sides() {
        for cos_i in [0.05, 0.4, 0.9] {
            let cos_t = cos_refracted(cos_i, 1.7).expect("no total reflection from outside");
            let difference = fresnel_dielectric(cos_i, 1.7) - fresnel_dielectric(cos_t, 1.0 / 1.7);
            assert!(difference.abs() < 1e-12, "{cos_i}: {difference:e}");
        }
    }

    /// A conductor that does not absorb is a dielectric, with total reflection;
    /// eta = 0, k = 1 is a perfect mirror; normal incidence is known.
    #[test]
    fn conductor_has_its_landmarks() {
        let at = |cos_i, eta, k| conductor_channel(cos_i, eta, k);
        for cos_i in [0.01, 0.3, 0.7, 1.0] {
            for eta in [0.6, 1.5, 3.0] {
                let difference: f64 = at(cos_i, eta, 0.0) - fresnel_dielectric(cos_i, eta);
                assert!(difference.abs() < 1e-7, "{cos_i} {eta}: {difference:e}");
            }
            assert!((at(cos_i, 0.0, 1.0) - 1.0).abs() < 1e-15);
        }
        let (eta, k) = (0.2004_f64, 3.9129_f64);
        let normal = ((eta - 1.0).powi(2) + k * k) / ((eta + 1.0).powi(2) + k * k);
        assert!((at(1.0, eta, k) - normal).abs() < 1e-14);
        assert!((at(0.0, eta, k) - 1.0).abs() < 1e-14);
    }

    /// The fits against the integral of `2 cos F`.
    #[test]
    fn diffuse_reflectance_is_the_mean_over_the_hemisphere() {
        for eta in [1.0 / 1.9, 1.0 / 1.5, 1.0 / 1.1, 1.1, 1.5, 1.9, 3.0] {
            let n = 100_000;
            let mean = (0..n)
                .map(|i| (i as f64 + 0.5) / n as f64)
                .map(|cos_i| 2.0 * cos_i * fresnel_dielectric(cos_i, eta) / n as f64)
                .sum::<f64>();
            let fit = fresnel_diffuse(eta);
            assert!((fit / mean - 1.0).abs() < 0.01, "{eta}: {fit} {mean}");
        }
    }
}
