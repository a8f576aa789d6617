//! The lobes that the laws are tested on.

use std::sync::Arc;

use capwalk_math::{Rgb, Vec3};
use capwalk_scene::lobe::*;

/// Gold, about.
const ETA: Rgb = Rgb::new(0.14, 0.37, 1.44);
const K: Rgb = Rgb::new(3.98, 2.39, 1.60);
const TINT: Rgb = Rgb::new(0.9, 0.6, 0.3);
const OTHER_TINT: Rgb = Rgb::new(0.4, 0.8, 0.95);

pub fn beckmann(alpha_u: f64, alpha_v: f64) -> Microfacets {
    Microfacets {
        distribution: Distribution::Beckmann,
        alpha_u,
        alpha_v,
    }
}

pub fn ggx(alpha_u: f64, alpha_v: f64) -> Microfacets {
    Microfacets {
        distribution: Distribution::Ggx,
        ..beckmann(alpha_u, alpha_v)
    }
}

fn rough_conductor(microfacets: Microfacets) -> Lobe {
    Lobe::RoughConductor(RoughConductor {
        microfacets,
        eta: ETA,
        k: K,
        specular_reflectance: TINT,
    })
}

fn rough_dielectric(microfacets: Microfacets, eta: f64) -> Lobe {
    Lobe::RoughDielectric(RoughDielectric {
        microfacets,
        eta,
        specular_reflectance: TINT,
        specular_transmittance: OTHER_TINT,
    })
}

fn plastic(nonlinear: bool) -> Lobe {
    Lobe::Plastic(Plastic {
        eta: 1.5,
        diffuse_reflectance: OTHER_TINT,
        specular_reflectance: TINT,
        nonlinear,
    })
}

fn rough_plastic(distribution: Distribution, alpha: f64, eta: f64, nonlinear: bool) -> Lobe {
    Lobe::RoughPlastic(RoughPlastic {
        distribution,
        eta,
        alpha,
        diffuse_reflectance: OTHER_TINT,
        specular_reflectance: TINT,
        nonlinear,
        transmittance: Arc::new(RoughTransmittance::new(distribution, alpha, eta)),
    })
}

/// A principled material of which nothing is special.
pub const PLAIN: Principled = Principled {
    base_color: Rgb::new(0.8, 0.5, 0.2),
    roughness: 0.5,
    anisotropic: 0.0,
    metallic: 0.0,
    spec_trans: 0.0,
    eta: 1.5,
    spec_tint: 0.0,
    sheen: 0.0,
    sheen_tint: 0.0,
    flatness: 0.0,
    clearcoat: 0.0,
    clearcoat_gloss: 0.0,
    explored: Explored {
        base: false,
        glass: false,
        coat: false,
    },
};

fn principled() -> Vec<(&'static str, Principled)> {
    vec![
        ("principled", PLAIN),
        (
            "principled metallic",
            Principled {
                roughness: 0.6,
                anisotropic: 0.7,
                metallic: 0.8,
                spec_tint: 0.3,
                eta: 1.4,
                ..PLAIN
            },
        ),
        (
            "principled cloth",
            Principled {
                roughness: 0.7,
                sheen: 0.8,
                sheen_tint: 0.6,
                flatness: 0.5,
                eta: 1.33,
                ..PLAIN
            },
        ),
        (
            "principled clearcoat",
            Principled {
                roughness: 0.6,
                clearcoat: 0.9,
                clearcoat_gloss: 0.1,
                spec_tint: 0.5,
                ..PLAIN
            },
        ),
        (
            "principled explored",
            Principled {
                explored: Explored {
                    base: true,
                    glass: true,
                    coat: true,
                },
                metallic: 0.9,
                spec_trans: 0.02,
                ..PLAIN
            },
        ),
        (
            "principled transmitting",
            Principled {
                roughness: 0.6,
                metallic: 0.2,
                spec_trans: 0.7,
                anisotropic: 0.4,
                clearcoat: 0.4,
                clearcoat_gloss: 0.3,
                ..PLAIN
            },
        ),
    ]
}

/// A sheet of which nothing is special.
pub const PLAIN_THIN: PrincipledThin = PrincipledThin {
    base_color: Rgb::new(0.8, 0.5, 0.2),
    roughness: 0.6,
    anisotropic: 0.0,
    spec_trans: 0.0,
    eta: 1.5,
    spec_tint: 0.0,
    sheen: 0.0,
    sheen_tint: 0.0,
    flatness: 0.0,
    diff_trans: 0.0,
    explored: ExploredThin {
        facets: false,
        transmission: false,
    },
};

fn principled_thin() -> Vec<(&'static str, PrincipledThin)> {
    vec![
        ("principledthin", PLAIN_THIN),
        (
            "principledthin leaf",
            PrincipledThin {
                diff_trans: 1.2,
                sheen: 0.6,
                sheen_tint: 0.7,
                flatness: 0.4,
                ..PLAIN_THIN
            },
        ),
        (
            "principledthin pane",
            PrincipledThin {
                spec_trans: 0.7,
                spec_tint: 0.4,
                diff_trans: 0.5,
                anisotropic: 0.5,
                ..PLAIN_THIN
            },
        ),
        (
            "principledthin explored",
            PrincipledThin {
                spec_trans: 1.0,
                eta: 1.33,
                explored: ExploredThin {
                    facets: true,
                    transmission: true,
                },
                ..PLAIN_THIN
            },
        ),
    ]
}

/// Lobes that are not perfectly specular, of moderate roughness: integrals over
/// the sphere resolve them.
pub fn smooth() -> Vec<(&'static str, Lobe)> {
    use Distribution::{Beckmann, Ggx};
    let mut lobes = vec![
        ("diffuse", Lobe::Diffuse(Diffuse { reflectance: TINT })),
        (
            "roughconductor beckmann",
            rough_conductor(beckmann(0.3, 0.3)),
        ),
        (
            "roughconductor beckmann anisotropic",
            rough_conductor(beckmann(0.5, 0.2)),
        ),
        ("roughconductor ggx", rough_conductor(ggx(0.25, 0.25))),
        (
            "roughconductor ggx anisotropic",
            rough_conductor(ggx(0.2, 0.6)),
        ),
        (
            "roughdielectric beckmann",
            rough_dielectric(beckmann(0.3, 0.3), 1.5),
        ),
        (
            "roughdielectric beckmann thinner inside",
            rough_dielectric(beckmann(0.4, 0.3), 0.7),
        ),
        ("roughdielectric ggx", rough_dielectric(ggx(0.3, 0.3), 1.5)),
        (
            "roughdielectric ggx anisotropic",
            rough_dielectric(ggx(0.6, 0.3), 1.8),
        ),
        ("plastic", plastic(false)),
        ("plastic nonlinear", plastic(true)),
        (
            "roughplastic beckmann",
            rough_plastic(Beckmann, 0.3, 1.5, false),
        ),
        (
            "roughplastic ggx nonlinear",
            rough_plastic(Ggx, 0.2, 1.7, true),
        ),
        (
            "roughplastic ggx thinner inside",
            rough_plastic(Ggx, 0.4, 0.8, false),
        ),
    ];
    for (name, microfacets) in [
        ("pplastic", beckmann(0.3, 0.3)),
        ("pplastic ggx anisotropic", ggx(0.2, 0.5)),
    ] {
        let lobe = PolarizedPlastic {
            microfacets,
            eta: 1.5,
            diffuse_reflectance: OTHER_TINT,
            specular_reflectance: TINT,
        };
        lobes.push((name, Lobe::PolarizedPlastic(lobe)));
    }
    let principled = principled().into_iter();
    lobes.extend(principled.map(|(name, lobe)| (name, Lobe::Principled(lobe))));
    let thin = principled_thin().into_iter();
    lobes.extend(thin.map(|(name, lobe)| (name, Lobe::PrincipledThin(lobe))));
    let sheet = DiffuseTransmitter {
        reflectance: TINT * 0.4,
        transmittance: OTHER_TINT * 0.6,
    };
    lobes.push(("difftrans", Lobe::DiffuseTransmitter(sheet)));
    lobes
}

/// Lobes that are so smooth that only local laws can be tested.
pub fn sharp() -> Vec<(&'static str, Lobe)> {
    vec![
        (
            "roughconductor beckmann 0.01",
            rough_conductor(beckmann(0.01, 0.01)),
        ),
        ("roughconductor ggx 0.01", rough_conductor(ggx(0.01, 0.02))),
        (
            "roughdielectric beckmann 0.01",
            rough_dielectric(beckmann(0.01, 0.02), 1.5),
        ),
        (
            "roughdielectric ggx 0.01",
            rough_dielectric(ggx(0.01, 0.01), 1.5),
        ),
    ]
}

/// Perfectly specular lobes (and parts), and their events.
pub fn specular() -> Vec<(&'static str, Lobe, Vec<Event>)> {
    let conductor = Conductor {
        eta: ETA,
        k: K,
        specular_reflectance: TINT,
    };
    let mirror = Conductor {
        eta: Rgb::zero(),
        k: Rgb::splat(1.0),
        ..conductor
    };
    let dielectric = |eta| {
        Lobe::Dielectric(Dielectric {
            eta,
            specular_reflectance: TINT,
            specular_transmittance: OTHER_TINT,
        })
    };
    let pane = ThinDielectric {
        eta: 1.5,
        specular_reflectance: TINT,
        specular_transmittance: OTHER_TINT,
    };
    let both = vec![Event::Reflect, Event::Transmit];
    vec![
        (
            "conductor",
            Lobe::Conductor(conductor),
            vec![Event::Reflect],
        ),
        ("mirror", Lobe::Conductor(mirror), vec![Event::Reflect]),
        ("dielectric", dielectric(1.5), both.clone()),
        ("dielectric thinner inside", dielectric(0.7), both),
        (
            "thindielectric",
            Lobe::ThinDielectric(pane),
            vec![Event::Reflect, Event::Pass],
        ),
        ("plastic", plastic(false), vec![Event::Reflect]),
        ("null", Lobe::Null(Null::default()), vec![Event::Pass]),
    ]
}

/// Directions to the viewer: from above, oblique, grazing, and for two-sided
/// lobes from below.
pub fn views(lobe: &Lobe) -> Vec<Vec3> {
    let mut views = vec![
        Vec3::new(0.0, 0.0, 1.0),
        Vec3::new(0.48, -0.36, 0.8),
        Vec3::new(-0.6, 0.7, 0.2).normalized(),
        Vec3::new(0.9, 0.5, 0.05).normalized(),
    ];
    if lobe.is_two_sided() {
        views.push(Vec3::new(0.48, 0.36, -0.8));
        views.push(Vec3::new(0.3, 0.9, -0.3).normalized());
    }
    views
}
