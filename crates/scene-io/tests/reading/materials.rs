//! Materials: what they are without any properties, what properties change, and
//! what is wrong with them.

use capwalk_math::Rgb;
use capwalk_scene::lobe::{Distribution, Lobe, Side};
use capwalk_scene::number::PrincipledIndex;
use capwalk_scene::params::{self, ParameterKind};
use capwalk_scene::resolve::Constants;
use capwalk_scene::{Bsdf, Resolver, Scene, TextureId};

use crate::common::*;

fn with(material: &str) -> String {
    scene(&format!(
        "<shape type=\"cube\" id=\"box\">{material}</shape>"
    ))
}

fn lobe<'s>(scene: &'s Scene, id: &str) -> &'s Lobe<TextureId> {
    let found = scene.materials.iter().find(|m| m.id == id);
    match &found.unwrap_or_else(|| panic!("no {id}")).bsdf {
        Bsdf::Plain(lobe) => lobe,
        other => panic!("{other:?}"),
    }
}

fn number(scene: &Scene, id: TextureId) -> f64 {
    let texture = scene.texture(id);
    assert_eq!(texture.channels, 1, "{}", texture.id);
    texture.texel(0).r
}

fn colour(scene: &Scene, id: TextureId) -> Rgb {
    let texture = scene.texture(id);
    assert_eq!(texture.channels, 3, "{}", texture.id);
    texture.texel(0)
}

/// The defaults of Mitsuba 3.9.1.
#[test]
fn defaults() {
    for plugin in ["dielectric", "roughdielectric", "thindielectric"] {
        let scene = load(&with(&format!("<bsdf type=\"{plugin}\"/>")));
        let (eta, specular_transmittance) = match lobe(&scene, "box.bsdf") {
            Lobe::Dielectric(glass) => (glass.eta, glass.specular_transmittance),
            Lobe::RoughDielectric(glass) => (glass.eta, glass.specular_transmittance),
            Lobe::ThinDielectric(glass) => (glass.eta, glass.specular_transmittance),
            other => panic!("{other:?}"),
        };
        // Mitsuba shows their quotient, 1.504183.
        assert_eq!(number(&scene, eta.int_ior), 1.5046);
        assert_eq!(number(&scene, eta.ext_ior), 1.000277);
        assert_eq!(colour(&scene, specular_transmittance), Rgb::splat(1.0));
    }
    let scene = load(&with("<bsdf type=\"roughplastic\"/>"));
    let Lobe::RoughPlastic(plastic) = lobe(&scene, "box.bsdf") else {
        panic!("roughplastic");
    };
    assert_eq!(number(&scene, plastic.eta.int_ior), 1.49);
    assert_eq!(colour(&scene, plastic.diffuse_reflectance), Rgb::splat(0.5));
    assert_eq!(number(&scene, plastic.alpha), 0.1);
    assert_eq!(plastic.distribution, Distribution::Beckmann);
    assert!(!plastic.nonlinear);
    let scene = load(&with("<bsdf type=\"roughconductor\"/>"));
    let Lobe::RoughConductor(metal) = lobe(&scene, "box.bsdf") else {
        panic!("roughconductor");
    };
    // Without a material it is a perfect mirror.
    assert_eq!(colour(&scene, metal.eta), Rgb::splat(0.0));
    assert_eq!(colour(&scene, metal.k), Rgb::splat(1.0));
    let facets = metal.microfacets;
    assert_eq!(facets.alpha_u, facets.alpha_v);
    assert_eq!(number(&scene, facets.alpha_u), 0.1);
    let scene = load(&with("<bsdf type=\"principled\"/>"));
    let Lobe::Principled(principled) = lobe(&scene, "box.bsdf") else {
        panic!("principled");
    };
    assert_eq!(colour(&scene, principled.base_color), Rgb::splat(0.5));
    assert_eq!(number(&scene, principled.roughness), 0.5);
    assert_eq!(number(&scene, principled.clearcoat), 0.0);
    let PrincipledIndex::Specular(specular) = principled.eta else {
        panic!("specular");
    };
    assert_eq!(number(&scene, specular), 0.5);
}

#[test]
fn sheets_and_materials_for_polarized_light() {
    let scene = load(&with(
        "<bsdf type=\"principledthin\"><float name=\"diff_trans\" value=\"1.4\"/></bsdf>",
    ));
    let Lobe::PrincipledThin(thin) = lobe(&scene, "box.bsdf") else {
        panic!("principledthin");
    };
    let numbers = [thin.diff_trans, thin.eta, thin.roughness, thin.spec_trans];
    let numbers = numbers.map(|id| number(&scene, id));
    assert_eq!(numbers, [1.4, 1.5, 0.5, 0.0]);
    let polarized = |inside: &str, warning: &str| {
        let (scene, warnings) = load_with_warnings(&with(inside));
        let text = warnings.join("\n");
        assert!(text.contains(warning), "{text}");
        scene
    };
    let scene = polarized(
        "<bsdf type=\"pplastic\"><float name=\"alpha\" value=\"0.3\"/></bsdf>",
        "polarization is not computed",
    );
    let Lobe::PolarizedPlastic(plastic) = lobe(&scene, "box.bsdf") else {
        panic!("pplastic");
    };
    assert_eq!(number(&scene, plastic.eta.int_ior), 1.49);
    assert_eq!(number(&scene, plastic.microfacets.alpha_u), 0.3);
    for (plugin, passes) in [("polarizer", 0.4), ("circular", 0.4), ("retarder", 0.8)] {
        let inside =
            format!("<bsdf type=\"{plugin}\"><float name=\"transmittance\" value=\"0.8\"/></bsdf>");
        let scene = polarized(&inside, "of the light passes");
        let Lobe::ThinDielectric(pane) = lobe(&scene, "box.bsdf") else {
            panic!("{plugin}");
        };
        let found = colour(&scene, pane.specular_transmittance);
        assert_eq!(found, Rgb::splat(passes));
        assert_eq!(
            number(&scene, pane.eta.int_ior),
            number(&scene, pane.eta.ext_ior)
        );
    }
}

/// That of Mitsuba 0.6, with a reflectance besides.
#[test]
fn diffuse_transmitters() {
    let with_numbers = |numbers: [&str; 2]| {
        let [reflectance, transmittance] = numbers;
        load_with_warnings(&with(&format!(
            "<bsdf type=\"difftrans\"><float name=\"reflectance\" value=\"{reflectance}\"/>\
             <float name=\"transmittance\" value=\"{transmittance}\"/></bsdf>"
        )))
    };
    let scene = load(&with("<bsdf type=\"difftrans\"/>"));
    let Lobe::DiffuseTransmitter(sheet) = lobe(&scene, "box.bsdf") else {
        panic!("difftrans");
    };
    assert_eq!(colour(&scene, sheet.reflectance), Rgb::zero());
    assert_eq!(colour(&scene, sheet.transmittance), Rgb::splat(0.5));
    assert_eq!(with_numbers(["0.25", "0.75"]).1, [""; 0]);
    let warnings = with_numbers(["0.5", "0.6"]).1.join("");
    assert!(
        warnings.contains("\"reflectance\" and \"transmittance\" are above 1 together"),
        "{warnings}"
    );
    check(
        &with("<bsdf type=\"difftrans\"><float name=\"transmitance\" value=\"0.4\"/></bsdf>"),
        &[
            "scene.xml:5:67: unknown property \"transmitance\" of the bsdf \"difftrans\"",
            "  its properties are reflectance, transmittance",
            "  did you mean \"transmittance\"?",
        ],
    );
}

/// A polarizer has half of its texels. So they are its own: what others use has no derivative
/// through a copy. A retarder lets all pass, and shares them.
#[test]
fn textures_of_polarizers_are_their_own() {
    let bitmap = "<string name=\"filename\" value=\"texels.png\"/>\
                  <boolean name=\"raw\" value=\"true\"/></texture>";
    let inside = |plugin: &str, given: &str| {
        with(&format!("<bsdf type=\"{plugin}\">{given}</bsdf>")).replace(
            "<integrator",
            &format!("<texture type=\"bitmap\" id=\"tex\">{bitmap}<integrator"),
        )
    };
    let pane = |scene: &Scene| match lobe(scene, "box.bsdf") {
        Lobe::ThinDielectric(pane) => pane.specular_transmittance,
        other => panic!("{other:?}"),
    };
    let own = format!("<texture type=\"bitmap\" name=\"transmittance\">{bitmap}");
    let scene = load(&inside("polarizer", &own));
    let mut ids: Vec<&str> = scene.textures.iter().map(|t| &*t.id).collect();
    ids.retain(|id| id.contains("transmittance"));
    assert_eq!(ids, ["box.bsdf.specular_transmittance"]);
    let whole = &scene
        .textures
        .iter()
        .find(|t| t.id == "tex")
        .expect("tex")
        .data;
    let half = &scene.texture(pane(&scene)).data;
    assert!(
        half.iter()
            .zip(whole)
            .all(|(half, whole)| 2.0 * half == *whole)
    );

    let shared = "<ref name=\"transmittance\" id=\"tex\"/>";
    let scene = load(&inside("retarder", shared));
    assert_eq!(scene.texture(pane(&scene)).id, "tex");
    let refused = "is the texture \"tex\", which others may use\n  give it a texture of its own \
                   without an id: 0.5 of the texels is what passes";
    let with_id = own.replace("<texture", "<texture id=\"own\"");
    let nested = "<spectrum type=\"d65\" name=\"transmittance\"><ref id=\"tex\"/></spectrum>";
    for (given, name) in [(shared, "tex"), (&with_id, "own"), (nested, "tex")] {
        for plugin in ["polarizer", "circular"] {
            let found = message(&inside(plugin, given), &[]);
            assert!(
                found.contains(&refused.replace("tex\"", &format!("{name}\""))),
                "{found}"
            );
        }
    }
}

/// Metals do not change with the sign of their index.
#[test]
fn negative_indices_of_metals() {
    let (scene, warnings) = load_with_warnings(&with(
        "<bsdf type=\"conductor\"><rgb name=\"eta\" value=\"0.2 0.4 1\"/>\
         <rgb name=\"k\" value=\"-3 -2 1.5\"/></bsdf>",
    ));
    let Lobe::Conductor(metal) = lobe(&scene, "box.bsdf") else {
        panic!("conductor");
    };
    assert_eq!(colour(&scene, metal.k), Rgb::new(3.0, 2.0, 1.5));
    assert!(
        warnings
            .join("")
            .contains("\"k\" is (-3, -2, 1.5): the sign has no effect")
    );
}

#[test]
fn materials_that_are_refused() {
    for (plugin, instead) in [
        ("hair", "write <bsdf type=\"principled\">"),
        ("measured", "fit a <bsdf type=\"principled\">"),
        ("measured_polarized", "write <bsdf type=\"roughconductor\">"),
        ("phong", "write <bsdf type=\"roughplastic\">"),
        ("ward", "write <bsdf type=\"roughplastic\">"),
        ("roughdiffuse", "write <bsdf type=\"diffuse\">"),
        ("coating", "write <bsdf type=\"plastic\">"),
        ("roughcoating", "write <bsdf type=\"roughplastic\">"),
        ("mixturebsdf", "write a <bsdf type=\"blendbsdf\">"),
    ] {
        let found = message(&with(&format!("<bsdf type=\"{plugin}\"/>")), &[]);
        let first = format!("the bsdf \"{plugin}\" is not supported");
        assert!(found.contains(&first) && found.contains(instead), "{found}");
    }
    check(
        &with("<bsdf type=\"principledthin\"><float name=\"diff_trans\" value=\"3\"/></bsdf>"),
        &["scene.xml:5:91: box.bsdf.diff_trans.value is (3, 3, 3); expected numbers from 0 to 2"],
    );
    check(
        &with("<bsdf type=\"principledthin\"><float name=\"metallic\" value=\"1\"/></bsdf>"),
        &[
            "scene.xml:5:72: unknown property \"metallic\" of the bsdf \"principledthin\"",
            "  its properties are anisotropic, base_color, diff_trans, diffuse_reflectance_sampling_rate, diffuse_transmittance_sampling_rate, eta, flatness, roughness, sheen, sheen_tint, spec_tint, spec_trans, specular_reflectance_sampling_rate, specular_transmittance_sampling_rate",
        ],
    );
    check(
        &with("<bsdf type=\"pplastic\"><float name=\"nonlinear\" value=\"1\"/></bsdf>"),
        &[
            "scene.xml:5:66: unknown property \"nonlinear\" of the bsdf \"pplastic\"",
            "  its properties are alpha, alpha_u, alpha_v, diffuse_reflectance, distribution, \
             ext_ior, int_ior, sample_visible, specular_reflectance",
        ],
    );
    let texture = "<bsdf type=\"diffuse\"><texture type=\"volume\" name=\"reflectance\"/></bsdf>";
    let found = message(&with(texture), &[]);
    assert!(
        found.contains("the texture \"volume\" is not supported"),
        "{found}"
    );
}

#[test]
fn metals_and_indices_have_names() {
    let scene = load(&with(
        "<bsdf type=\"conductor\"><string name=\"material\" value=\"Au\"/></bsdf>",
    ));
    let Lobe::Conductor(metal) = lobe(&scene, "box.bsdf") else {
        panic!("conductor");
    };
    // What Mitsuba 3.9.1 shows for gold in scalar_rgb.
    let gold = [
        [0.14303598, 0.37530708, 1.4420453],
        [3.982997, 2.3855565, 1.6033592],
    ];
    assert_eq!(colour(&scene, metal.eta), gold[0].into());
    assert_eq!(colour(&scene, metal.k), gold[1].into());
    let scene = load(&with(
        "<bsdf type=\"dielectric\"><string name=\"int_ior\" value=\"Water\"/>\
         <float name=\"ext_ior\" value=\"1.1\"/></bsdf>",
    ));
    let Lobe::Dielectric(glass) = lobe(&scene, "box.bsdf") else {
        panic!("dielectric");
    };
    assert_eq!(number(&scene, glass.eta.int_ior), 1.333);
    assert_eq!(number(&scene, glass.eta.ext_ior), 1.1);
}

#[test]
fn parameters_have_the_names_that_users_type() {
    let scene = load(&scene(
        "<bsdf type=\"roughconductor\" id=\"metal\"/><bsdf type=\"dielectric\" id=\"glass\"/>\
         <bsdf type=\"mask\" id=\"veil\"><bsdf type=\"principled\"/></bsdf>\
         <shape type=\"cube\" id=\"box\"><ref id=\"veil\"/></shape>",
    ));
    let parameters = params::Registry::new(&scene).scalars(&scene);
    for (name, kind, moves) in [
        ("metal.alpha.value", ParameterKind::Roughness, false),
        ("metal.alpha", ParameterKind::Roughness, false),
        ("metal.eta.value.r", ParameterKind::RefractiveIndex, false),
        ("metal.k.value", ParameterKind::Extinction, false),
        ("glass.int_ior", ParameterKind::RefractiveIndex, true),
        (
            "glass.specular_transmittance.value",
            ParameterKind::Transmittance,
            false,
        ),
        ("veil.opacity.value", ParameterKind::Fraction, false),
        (
            "veil.nested_bsdf.roughness.value",
            ParameterKind::Fraction,
            false,
        ),
        ("veil.base_color.value.g", ParameterKind::Reflectance, false),
        ("box.bsdf.opacity", ParameterKind::Fraction, false),
        ("box.bsdf.metallic", ParameterKind::Fraction, false),
    ] {
        let found = parameters.iter().find(|p| p.name == name);
        let found = found.unwrap_or_else(|| panic!("no {name}"));
        assert_eq!(
            (found.kind, found.moves_discontinuities),
            (kind, moves),
            "{name}"
        );
        let tangent = params::Registry::new(&scene)
            .tangent(&scene, name)
            .expect(name);
        assert_eq!(tangent.textures.iter().flatten().count(), 1, "{name}");
    }
}

/// Materials made of others, down to the lobes.
#[test]
fn mixtures() {
    let scene = load(&with(
        "<bsdf type=\"blendbsdf\"><float name=\"weight\" value=\"0.25\"/>\
         <bsdf type=\"diffuse\"/><bsdf type=\"mask\"><float name=\"opacity\" value=\"0.5\"/>\
         <bsdf type=\"plastic\"/></bsdf></bsdf>",
    ));
    let id = scene.shapes[0].bsdf;
    let textures = &mut Constants(&scene);
    let resolved = Resolver::new(&scene).resolve(&scene, id, Side::Front, textures);
    let lobes: Vec<_> = resolved.bsdf.lobes().collect();
    let weights: Vec<f64> = lobes.iter().map(|(weight, _)| *weight).collect();
    assert_eq!(weights, [0.75, 0.125, 0.125]);
    assert!(matches!(lobes[0].1, Lobe::Diffuse(_)));
    assert!(matches!(lobes[1].1, Lobe::Plastic(_)));
    assert!(matches!(lobes[2].1, Lobe::Null(_)));
    let ids: Vec<&str> = scene.materials.iter().map(|m| m.id.as_str()).collect();
    let expected = ["bsdf_0", "bsdf_1.nested_bsdf", "bsdf_1"];
    let mut expected: Vec<String> = expected.map(|part| format!("box.bsdf.{part}")).to_vec();
    expected.push("box.bsdf".into());
    assert_eq!(ids, expected);
}

#[test]
fn wrong_numbers_and_names() {
    check(
        &with("<bsdf type=\"conductor\"><string name=\"material\" value=\"Gold\"/></bsdf>"),
        &[
            "scene.xml:5:85: there is no material \"Gold\"",
            "  expected a symbol such as Au, Ag, Al, Cu or Cr, or none",
        ],
    );
    check(
        &with(
            "<bsdf type=\"conductor\"><string name=\"material\" value=\"Au\"/>\
             <rgb name=\"k\" value=\"3\"/></bsdf>",
        ),
        &[
            "scene.xml:5:85: both a material and its eta or k are given",
            "  keep one of them",
        ],
    );
    check(
        &with("<bsdf type=\"dielectric\"><string name=\"int_ior\" value=\"diamant\"/></bsdf>"),
        &[
            "scene.xml:5:85: there is no refractive index of \"diamant\"",
            "  expected a number, or a name such as bk7, water or diamond",
            "  did you mean \"diamond\"?",
        ],
    );
    check(
        &with("<bsdf type=\"dielectric\"><float name=\"int_ior\" value=\"0\"/></bsdf>"),
        &["scene.xml:5:84: box.bsdf.int_ior.value is (0, 0, 0); expected finite numbers above 0"],
    );
    check(
        &with(
            "<bsdf type=\"mask\"><float name=\"opacity\" value=\"1.5\"/><bsdf type=\"diffuse\"/></bsdf>",
        ),
        &[
            "scene.xml:5:78: box.bsdf.opacity.value is (1.5, 1.5, 1.5); expected numbers from 0 \
             to 1",
        ],
    );
    check(
        &with("<bsdf type=\"roughconductor\"><float name=\"alpha_u\" value=\"0.1\"/></bsdf>"),
        &[
            "scene.xml:5:88: the roughness is given in part, or twice",
            "  give alpha, or both alpha_u and alpha_v",
        ],
    );
    check(
        &with(
            "<bsdf type=\"principled\"><float name=\"eta\" value=\"1.5\"/>\
             <float name=\"specular\" value=\"0.5\"/></bsdf>",
        ),
        &[
            "scene.xml:5:99: both \"eta\" and \"specular\" are given",
            "  keep one of them",
        ],
    );
    check(
        &with("<bsdf type=\"roughplastic\"><string name=\"distribution\" value=\"phong\"/></bsdf>"),
        &[
            "scene.xml:5:92: \"distribution\" is \"phong\"",
            "  expected beckmann, ggx",
        ],
    );
    check(
        &with("<bsdf type=\"plastic\"><float name=\"alpha\" value=\"0.1\"/></bsdf>"),
        &[
            "scene.xml:5:65: unknown property \"alpha\" of the bsdf \"plastic\"",
            "  its properties are diffuse_reflectance, ext_ior, int_ior, nonlinear, \
             sample_visible, specular_reflectance",
        ],
    );
}

#[test]
fn materials_that_need_others() {
    check(
        &with("<bsdf type=\"mask\"/>"),
        &[
            "scene.xml:5:31: the bsdf \"mask\" has no material",
            "  put a material into it, such as <bsdf type=\"diffuse\"/>",
        ],
    );
    check(
        &with("<bsdf type=\"blendbsdf\"><bsdf type=\"diffuse\"/><bsdf type=\"diffuse\"/></bsdf>"),
        &[
            "scene.xml:5:31: the bsdf \"blendbsdf\" has no weight",
            "  add <float name=\"weight\" value=\"0.5\"/>: the part of the second",
        ],
    );
    check(
        &with(
            "<bsdf type=\"blendbsdf\"><float name=\"weight\" value=\"1\"/>\
             <bsdf type=\"diffuse\"/></bsdf>",
        ),
        &[
            "scene.xml:5:31: the bsdf \"blendbsdf\" has 1 materials",
            "  put two into it",
        ],
    );
    check(
        &with("<bsdf type=\"bumpmap\"><bsdf type=\"diffuse\"/></bsdf>"),
        &[
            "scene.xml:5:31: the bsdf \"bumpmap\" has no texture",
            "  put a <texture> with heights into it",
        ],
    );
    let map = |plugin: &str, texture: &str| {
        with(&format!(
            "<bsdf type=\"{plugin}\"><bsdf type=\"diffuse\"/>{texture}</bsdf>"
        ))
    };
    check(
        &map(
            "bumpmap",
            "<texture name=\"heights\" type=\"checkerboard\"/>",
        ),
        &[
            "scene.xml:5:31: the material \"box.bsdf\" cannot be rendered: the heights of a bump \
             map must be a bitmap with the filter bilinear",
        ],
    );
    check(
        &map("normalmap", "<float name=\"normalmap\" value=\"0.5\"/>"),
        &[
            "scene.xml:5:31: the material \"box.bsdf\" cannot be rendered: a map of normals must \
             have three channels",
        ],
    );
    check(
        &map(
            "normalmap",
            "<rgb name=\"normalmap\" value=\"0.5 0.5 0.5\"/>",
        ),
        &[
            "scene.xml:5:31: the material \"box.bsdf\" cannot be rendered: a normal in its map is \
             0 (the colour 0.5, 0.5, 0.5)",
        ],
    );
    check(
        &with("<bsdf type=\"twosided\"><bsdf type=\"dielectric\"/></bsdf>"),
        &[
            "scene.xml:5:31: the material \"box.bsdf\" cannot be rendered: a two-sided material \
             must not be made of clear ones",
        ],
    );
    let deep = format!(
        "{}<bsdf type=\"diffuse\"/>{}",
        "<bsdf type=\"mask\">".repeat(20),
        "</bsdf>".repeat(20)
    );
    assert!(message(&with(&deep), &[]).contains("stand inside each other too deep"));
}

/// Mitsuba exchanges the colours of a checkerboard that is used for a number, not of one that is
/// used for a colour.
#[test]
fn checkerboards_of_numbers_warn() {
    let warnings = |slot: &str| {
        let board = format!("<texture type=\"checkerboard\" name=\"{slot}\"/>");
        let material = format!("<bsdf type=\"principled\">{board}</bsdf>");
        let shape = format!("<shape type=\"sphere\">{material}</shape>");
        load_with_warnings(&scene(&shape)).1
    };
    assert_eq!(warnings("base_color"), [""; 0]);
    let metallic = warnings("metallic");
    assert_eq!(metallic.len(), 1, "{metallic:?}");
    assert!(metallic[0].contains("\"metallic\" is a checkerboard of numbers"));
}
