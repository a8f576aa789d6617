//! Light is not made, and paths can be walked both ways.

use std::sync::Arc;

use capwalk_math::{Rgb, Vec3};
use capwalk_scene::lobe::*;

use crate::table::{self, beckmann, ggx};
use crate::tools::{Random, direction, sphere_integral};

/// Radiance that arrives from inside counts `eta²` less, flux does not.
fn flux_scale(lobe: &Lobe, wi: Vec3, wo: Vec3) -> f64 {
    let eta = match lobe {
        Lobe::Dielectric(lobe) => lobe.eta,
        Lobe::RoughDielectric(lobe) => lobe.eta,
        Lobe::Principled(lobe) => lobe.eta,
        _ => return 1.0,
    };
    if wi.z * wo.z > 0.0 {
        1.0
    } else if wi.z > 0.0 {
        eta * eta
    } else {
        1.0 / (eta * eta)
    }
}

/// All that a surface gives back from a furnace.
fn albedo(lobe: &Lobe, wi: Vec3) -> f64 {
    let [smooth] = sphere_integral(24, |wo| {
        [lobe.eval(wi, wo).max_component() * flux_scale(lobe, wi, wo)]
    });
    let events = match lobe {
        Lobe::Conductor(_) | Lobe::Plastic(_) => vec![Event::Reflect],
        Lobe::Dielectric(_) => vec![Event::Reflect, Event::Transmit],
        Lobe::ThinDielectric(_) => vec![Event::Reflect, Event::Pass],
        Lobe::Null(_) => vec![Event::Pass],
        _ => vec![],
    };
    let specular: f64 = events
        .into_iter()
        .map(|event| {
            let (wo, throughput) = lobe.specular(Specular { lobe: 0, event }, wi);
            throughput.max_component() * flux_scale(lobe, wi, wo)
        })
        .sum();
    smooth + specular
}

const WHITE: Rgb = Rgb::new(1.0, 1.0, 1.0);

#[test]
fn white_surfaces_that_lose_nothing_give_back_all() {
    let dielectric = |eta| {
        Lobe::Dielectric(Dielectric {
            eta,
            specular_reflectance: WHITE,
            specular_transmittance: WHITE,
        })
    };
    let lobes = [
        Lobe::Diffuse(Diffuse { reflectance: WHITE }),
        Lobe::Conductor(Conductor {
            eta: Rgb::zero(),
            k: WHITE,
            specular_reflectance: WHITE,
        }),
        dielectric(1.5),
        dielectric(0.6),
        Lobe::ThinDielectric(ThinDielectric {
            eta: 1.5,
            specular_reflectance: WHITE,
            specular_transmittance: WHITE,
        }),
        Lobe::Null(Null::default()),
        Lobe::DiffuseTransmitter(DiffuseTransmitter {
            reflectance: WHITE * 0.3,
            transmittance: WHITE * 0.7,
        }),
    ];
    for lobe in lobes {
        for wi in table::views(&lobe) {
            let albedo = albedo(&lobe, wi);
            assert!(
                (albedo - 1.0).abs() < 1e-9,
                "{lobe:?}, wi = {wi:?}: {albedo}"
            );
        }
    }
}

/// Single scattering between facets loses light, never makes some; facets that
/// hardly shadow each other lose little.
#[test]
fn rough_surfaces_give_back_at_most_all() {
    for microfacets in [
        beckmann(0.2, 0.2),
        ggx(0.2, 0.2),
        beckmann(0.6, 0.3),
        ggx(0.3, 0.7),
    ] {
        let metal = Lobe::RoughConductor(RoughConductor {
            microfacets,
            eta: Rgb::zero(),
            k: WHITE,
            specular_reflectance: WHITE,
        });
        let glass = |eta| {
            Lobe::RoughDielectric(RoughDielectric {
                microfacets,
                eta,
                specular_reflectance: WHITE,
                specular_transmittance: WHITE,
            })
        };
        for lobe in [metal, glass(1.5), glass(0.6)] {
            for wi in table::views(&lobe) {
                let albedo = albedo(&lobe, wi);
                assert!(albedo < 1.0 + 1e-4, "{lobe:?}, wi = {wi:?}: {albedo}");
                // The tails of GGX send up to a tenth below the surface.
                let least = match microfacets.distribution {
                    Distribution::Beckmann => 0.98,
                    Distribution::Ggx => 0.9,
                };
                if microfacets.alpha_u == 0.2 && wi.z > 0.7 {
                    assert!(albedo > least, "{lobe:?}, wi = {wi:?}: {albedo}");
                }
            }
        }
    }
}

/// A white base under a clear coat loses nothing but what the fit of the
/// internal reflectance is off; under a rough one, what facets hide. (The
/// principled material does not conserve energy: coat and sheen are added.)
#[test]
fn white_plastic_gives_back_all() {
    for eta in [1.3, 1.5, 1.9] {
        for nonlinear in [false, true] {
            let smooth = Lobe::Plastic(Plastic {
                eta,
                diffuse_reflectance: WHITE,
                specular_reflectance: WHITE,
                nonlinear,
            });
            let alpha = 0.2;
            let table = RoughTransmittance::new(Distribution::Ggx, alpha, eta);
            let rough = Lobe::RoughPlastic(RoughPlastic {
                distribution: Distribution::Ggx,
                eta,
                alpha,
                diffuse_reflectance: WHITE,
                specular_reflectance: WHITE,
                nonlinear,
                transmittance: Arc::new(table),
            });
            for wi in table::views(&smooth) {
                let albedo_smooth = albedo(&smooth, wi);
                assert!(
                    (albedo_smooth - 1.0).abs() < 0.01,
                    "{eta} {wi:?}: {albedo_smooth}"
                );
                let albedo_rough = albedo(&rough, wi);
                assert!(
                    (0.6..1.01).contains(&albedo_rough),
                    "{eta} {wi:?}: {albedo_rough}"
                );
            }
        }
    }
}

/// Helmholtz, and its version for refraction: radiance over the square of the
/// refractive index.
#[test]
fn paths_can_be_walked_both_ways() {
    let mut random = Random::new(3);
    let mut count = 0;
    for (name, lobe) in table::smooth() {
        for _ in 0..200 {
            let mut drawn = || direction(2.0 * random.next() - 1.0, 7.0 * random.next());
            let (wi, wo) = (drawn(), drawn());
            if !lobe.is_two_sided() && (wi.z < 0.0 || wo.z < 0.0) {
                continue;
            }
            // Its facets cut off what they transmit by `wo` alone, as in Mitsuba.
            if matches!(lobe, Lobe::PrincipledThin(_)) && wi.z * wo.z < 0.0 {
                continue;
            }
            let forth = lobe.eval(wi, wo) * (flux_scale(&lobe, wi, wo) / wo.z.abs());
            let back = lobe.eval(wo, wi) * (1.0 / wi.z.abs());
            let error = (forth - back).length();
            assert!(
                error <= 1e-9 * forth.length(),
                "{name}, {wi:?}, {wo:?}: {error}"
            );
            count += usize::from(forth.length() > 0.0);
        }
    }
    assert!(count > 500, "only {count} pairs of directions scatter");
}
