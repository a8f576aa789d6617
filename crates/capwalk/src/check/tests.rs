//! What follows from gradients and references made by hand; and of many real ones.

mod verdicts;

use super::*;
use capwalk_diff::{Dips, Estimate, Statistics, UsedDevice};
use capwalk_math::Rgb;
use capwalk_scene::Image;

const SIDE: usize = 24;

/// Numbers that look random, of mean 0 and variance 1: sums of twelve uniform ones.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        let uniform = |_| {
            self.0 = self.0.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(1);
            (self.0 >> 11) as f64 / (1_u64 << 53) as f64
        };
        (0..12).map(uniform).sum::<f64>() - 6.0
    }
}

/// An image of 1, whose derivative is waves times `factor`, and `spikes` in a few pixels, with
/// noise of this size.
fn waves(seed: u64, factor: f64, spikes: f64, noise: f64) -> GradientImage {
    let mut random = Noise(seed);
    let flat = |value: f64| {
        let mut image = Image::new(SIDE, SIDE);
        image.pixels.fill(Rgb::splat(value));
        image
    };
    let mut mean = Image::new(SIDE, SIDE);
    for (i, pixel) in mean.pixels.iter_mut().enumerate() {
        let spike = match i % 97 {
            13 => spikes,
            _ => 0.0,
        };
        let wave = factor * (0.7 * i as f64).sin();
        *pixel = Rgb::splat(wave + spike + noise * random.next());
    }
    GradientImage {
        value: Estimate {
            mean: flat(1.0),
            standard_error: flat(0.01),
        },
        gradient: Estimate {
            mean,
            standard_error: flat(noise),
        },
        chosen: None,
        statistics: Statistics {
            samples_per_pixel: vec![1000; SIDE * SIDE],
            complete: true,
            samples: 1000 * (SIDE * SIDE) as u64,
            non_finite: 0,
            cone_queries: 0,
            effort: 0,
            device: UsedDevice::default(),
            dips: Dips::default(),
        },
    }
}

const MADE: Reference = Reference {
    spp: 1000,
    fits_noise: true,
    adaptive: true,
    seed: 5,
    step: 0.01,
    fits_scene: true,
    sides: Stencil::Both,
};

/// A check of the waves against a reference.
fn checked(made: Reference, reference: &GradientImage) -> Check {
    let gradient = waves(1, 1.0, 0.0, 0.1);
    Check::new(gradient, (made, reference.clone()), Vec::new())
}

/// The same against a second reference after the first.
fn checked_twice(made: Reference, first: &GradientImage, second: &GradientImage) -> Check {
    let check = checked(made, first);
    let again = check.next_reference().expect("there is a contradiction");
    check.with_next_reference((again, second.clone()))
}

/// A check whose second reference agrees with the gradient.
fn twice_right() -> Check {
    checked_twice(MADE, &waves(3, 1.3, 0.0, 0.1), &waves(2, 1.0, 0.0, 0.1))
}

/// What contradicts a gradient, or leaves a doubt of it, gets another reference: over a
/// smaller step, unless one was asked for, with more samples and other random numbers.
#[test]
fn a_contradiction_gets_another_reference() {
    let (right, wrong) = (waves(2, 1.0, 0.0, 0.1), waves(3, 1.3, 0.0, 0.1));
    assert_eq!(checked(MADE, &right).comparison.verdict, Verdict::Right);
    assert_eq!(checked(MADE, &right).next_reference(), None);
    let second = |made| {
        let second = checked(made, &wrong).next_reference();
        second.expect("there is a contradiction")
    };
    assert_eq!((second(MADE).step, second(MADE).spp), (0.0025, 4000));
    assert!(second(MADE).seed != MADE.seed && !second(MADE).fits_noise);
    let own = Reference {
        fits_scene: false,
        ..MADE
    };
    assert_eq!((second(own).step, second(own).spp), (0.01, 4000));
    assert_ne!(second(own).seed, own.seed);
    // What was cut short is no reason to begin anew.
    let mut cut = wrong.clone();
    cut.statistics.complete = false;
    assert_eq!(checked(MADE, &cut).next_reference(), None);
}

/// The second reference decides if it can.
#[test]
fn the_second_reference_decides() {
    let (right, wrong) = (waves(2, 1.0, 0.0, 0.1), waves(3, 1.3, 0.0, 0.1));
    let noisy = waves(4, 1.0, 0.0, 3.0);
    let verdict = |first: &_, second: &_| checked_twice(MADE, first, second).comparison.verdict;
    assert_eq!(verdict(&wrong, &right), Verdict::Right);
    let both = verdict(&wrong, &waves(5, 1.3, 0.0, 0.1));
    assert!(matches!(both, Verdict::Wrong { .. }));
    // What is inconclusive leaves a doubt.
    for (fits_scene, words) in [(true, "smaller step does"), (false, "more samples do")] {
        let made = Reference { fits_scene, ..MADE };
        match checked_twice(made, &wrong, &noisy).comparison.verdict {
            Verdict::Inconclusive { doubt, .. } => {
                let doubt = doubt.expect("what was said first");
                assert!(doubt.contains(words) && doubt.contains("0.0100"), "{doubt}");
            }
            verdict => panic!("{verdict:?}"),
        }
    }
    // Where time ran out, the first stays, but nobody is called wrong by it alone.
    let mut cut = right.clone();
    cut.statistics.complete = false;
    for check in [
        checked_twice(MADE, &wrong, &cut),
        checked(MADE, &wrong).decided(),
    ] {
        assert!(check.verdict(|_, _| String::new()).contains("no time"));
        assert_eq!(check.made.step, MADE.step);
    }
    // A second gradient with which both references agree shows that the first had too small errors.
    let both = || checked_twice(MADE, &wrong, &waves(5, 1.3, 0.0, 0.1));
    let options = GradientOptions::default();
    let again = both().second_gradient(&options).expect("it is wrong");
    assert_eq!(again.spp, 4 * options.spp);
    assert_ne!(again.seed, options.seed);
    assert!(twice_right().second_gradient(&options).is_none());
    let of = |gradient| both().with_second_gradient(&gradient).comparison.verdict;
    assert!(matches!(of(waves(8, 1.0, 0.0, 0.1)), Verdict::Wrong { .. }));
    match of(waves(8, 1.3, 0.0, 0.1)) {
        Verdict::Inconclusive { doubt, .. } => {
            let doubt = doubt.expect("what was said first");
            assert!(doubt.contains("second gradient"), "{doubt}");
        }
        verdict => panic!("{verdict:?}"),
    }
    // A second gradient and a reference of its own must call it wrong by themselves.
    let [smaller, larger] = both().confirmations()[..] else {
        panic!("it is wrong")
    };
    assert_eq!((smaller.step, smaller.spp), (0.000625, 16000));
    assert_eq!((larger.step, larger.spp), (0.01, 16000));
    assert_ne!(smaller.seed, larger.seed);
    let own = Reference {
        fits_scene: false,
        ..MADE
    };
    let own = checked_twice(own, &wrong, &waves(5, 1.3, 0.0, 0.1)).confirmations();
    assert_eq!((own.len(), own[0].step), (1, MADE.step));
    let gradient = waves(8, 1.0, 0.0, 0.1);
    let confirmed = |image: &GradientImage| {
        let check = both().with_confirmation(&gradient, (smaller, image.clone()));
        check.with_confirmation(&gradient, (larger, waves(10, 1.3, 0.0, 0.1)))
    };
    let check = confirmed(&waves(9, 1.3, 0.0, 0.1));
    assert!(matches!(&check.comparison.verdict, Verdict::Wrong { .. }));
    assert_eq!((check.references, check.made.step), (4, 0.0025));
    assert_eq!(check.reference_samples, 4 * right.statistics.samples);
    let check = both().with_confirmation(&gradient, (larger, right.clone()));
    let text = check.verdict(|_, _| String::new());
    assert!(text.contains("over a larger step do not confirm"), "{text}");
    for (image, words) in [
        (
            &right,
            "another reference over a smaller step do not confirm",
        ),
        (
            &noisy,
            "another reference over a smaller step do not confirm",
        ),
        (&cut, "no time"),
    ] {
        let check = confirmed(image);
        let text = check.verdict(|_, _| String::new());
        assert!(
            text.starts_with("inconclusive") && text.contains(words),
            "{text}"
        );
        assert!(check.confirmations().is_empty());
    }
    // Both are counted.
    let twice = checked_twice(MADE, &wrong, &right);
    assert_eq!((twice.references, twice.made.step), (2, 0.0025));
    assert_eq!(twice.reference_samples, 2 * right.statistics.samples);
    // Two doubts take more samples than the second reference had.
    let doubtful = [6, 7].map(|seed| waves(seed, 1.0, 0.8, 0.1));
    let factor = |check: Check| match check.comparison.verdict {
        Verdict::Inconclusive {
            samples_factor,
            doubt: Some(_),
        } => samples_factor,
        verdict => panic!("{verdict:?}"),
    };
    let once = factor(checked(MADE, &doubtful[0]));
    let both = checked_twice(MADE, &doubtful[0], &doubtful[1]);
    assert_eq!(factor(both), 4.0 * once);
    // A doubt that the second reference does not share is none.
    let doubtful = waves(6, 1.0, 0.8, 0.1);
    let first = checked(MADE, &doubtful).comparison.verdict;
    assert!(
        matches!(first, Verdict::Inconclusive { doubt: Some(_), .. }),
        "{first:?}"
    );
    assert_eq!(verdict(&doubtful, &right), Verdict::Right);
}

/// Where references contradict each other, none of them calls a gradient wrong: others are made,
/// as long as each contradicts the gradient and the one before.
#[test]
fn references_that_contradict_each_other_call_nothing_wrong() {
    let [right, first, second] =
        [(2, 1.0), (3, 1.3), (5, 1.6)].map(|(seed, factor)| waves(seed, factor, 0.0, 0.1));
    let apart = || checked_twice(MADE, &first, &second);
    assert!(matches!(&apart().comparison.verdict, Verdict::Wrong { .. }));
    let third = apart().next_reference().expect("they do not agree");
    assert_eq!((third.step, third.spp), (MADE.step / 16.0, 4000));
    let with = |check: Check, next: &GradientImage| {
        let made = check.next_reference().expect("it is open");
        check.with_next_reference((made, next.clone()))
    };
    let doubt_of = |check: &Check| match &check.comparison.verdict {
        Verdict::Inconclusive {
            doubt: Some(doubt), ..
        } => doubt.clone(),
        verdict => panic!("{verdict:?}"),
    };
    // The third one decides, if it contradicts the second.
    let decided = with(apart(), &right);
    assert_eq!(decided.comparison.verdict, Verdict::Right);
    assert_eq!((decided.references, decided.made.step), (3, third.step));
    let of_all = 3 * right.statistics.samples;
    assert_eq!(decided.reference_samples, of_all);
    let confirmed = with(apart(), &waves(6, 1.6, 0.0, 0.1));
    assert!(confirmed.next_reference().is_none());
    assert!(matches!(
        confirmed.decided().comparison.verdict,
        Verdict::Wrong { .. }
    ));
    // Noise alone does not acquit: the same few pixels are off in the second and the third.
    let spikes = |seed, spikes, noise| waves(seed, 1.0, spikes, noise);
    let few = checked_twice(MADE, &spikes(3, 3.0, 0.1), &spikes(5, 1.3, 0.1));
    assert!(matches!(&few.comparison.verdict, Verdict::Wrong { .. }));
    let hidden = with(few, &spikes(6, 0.9, 0.2));
    let alone = checked(MADE, &spikes(6, 0.9, 0.2));
    assert_eq!(alone.comparison.verdict, Verdict::Right);
    assert!(doubt_of(&hidden).contains("0.00250"));
    assert!(hidden.next_reference().is_none());
    // Nor does it accuse: what a noisy one leaves is the doubt of the one before.
    let noisy = waves(7, 1.0, 0.0, 3.0);
    let doubtful = with(apart(), &noisy);
    assert!(doubt_of(&doubtful).contains("0.00250") && doubtful.next_reference().is_none());
    // So it does where one says that, and the other leaves a doubt that does not agree.
    let unlike = [waves(3, 1.3, 0.0, 0.1), waves(6, 1.0, 0.8, 0.1)];
    let check = checked_twice(MADE, &unlike[0], &unlike[1]);
    assert!(doubt_of(&check).contains("mean z²") && check.is_open);
    let words = check.decided().verdict(|_, _| String::new());
    assert!(words.contains("contradicts one with") && !words.contains("times the samples"));
    // A third one with the doubt of the second leaves the second's verdict; the samples that
    // were taken are not taken again.
    let few = || checked_twice(MADE, &spikes(3, 3.0, 0.1), &spikes(5, 1.3, 0.1));
    let shared = with(few(), &spikes(6, 0.8, 0.1));
    assert!(matches!(&shared.comparison.verdict, Verdict::Wrong { .. }) && !shared.is_open);
    assert_eq!((shared.references, shared.made.step), (3, MADE.step / 4.0));
    let doubtful = checked_twice(MADE, &waves(3, 4.0, 0.0, 0.1), &waves(4, 1.0, 0.0, 1.0));
    assert!(doubt_of(&doubtful).contains("0.0100") && doubtful.next_reference().is_none());
    // They end, with random numbers of their own, and nothing is wrong then.
    let mut check = checked(MADE, &first);
    let mut seeds = vec![check.made.seed];
    for next in [&second, &first, &second] {
        check = with(check, next);
        seeds.push(check.made.seed);
    }
    seeds.sort_unstable();
    seeds.dedup();
    assert_eq!((seeds.len(), check.references), (4, 4));
    assert!(check.next_reference().is_none());
    let words = check.decided().verdict(|_, _| String::new());
    let says = |text: &str| words.contains(text);
    assert!(
        words.starts_with("inconclusive") && says("discontinuous") && !says("times the samples")
    );
    // So it is where time runs out between them, and with a step that was asked for.
    let mut cut = right.clone();
    cut.statistics.complete = false;
    let check = with(apart(), &cut);
    assert!(doubt_of(&check).contains("contradicts one with") && !check.is_open);
    let own = Reference {
        fits_scene: false,
        ..MADE
    };
    let apart = checked_twice(own, &first, &second);
    assert_eq!(apart.next_reference().map(|next| next.step), Some(own.step));
    let words = apart.decided().verdict(|_, _| String::new());
    assert!(
        words.contains("rare events") && words.contains("times the samples"),
        "{words}"
    );
}

/// A reference that saw too few events is no evidence, neither as the first nor as the second.
#[test]
fn too_few_events_are_no_evidence() {
    let (wrong, mut blind) = (waves(3, 1.3, 0.0, 0.1), waves(4, 0.0, 0.0, 0.0));
    let statistics = &mut blind.statistics;
    statistics.samples_per_pixel.fill(2);
    statistics.samples = 2 * (SIDE * SIDE) as u64;
    let short = Reference { step: 1e-5, ..MADE };
    let check = checked(short, &blind);
    assert!(check.comparison.few_events && check.next_reference().is_none());
    let first = checked(MADE, &wrong);
    match first.with_next_reference((short, blind)).comparison.verdict {
        Verdict::Inconclusive { doubt, .. } => {
            let doubt = doubt.expect("what was said first");
            assert!(doubt.contains("does not confirm"), "{doubt}");
        }
        verdict => panic!("{verdict:?}"),
    }
}

/// The sides of a step are named.
#[test]
fn one_sided_differences_are_described() {
    let sides = |sides| Reference { sides, ..MADE }.describe();
    assert!(sides(Stencil::Below).contains("over - 0.0100: on the other side"));
    assert!(sides(Stencil::Above).contains("over + 0.0100"));
    assert_eq!(sides(Stencil::Both), "central differences over ± 0.0100");
}

/// A few faces are named, the others counted.
#[test]
fn faces_that_are_seen_edge_on_are_named() {
    let faces: Vec<EdgeOnFace> = (0..7)
        .map(|face| EdgeOnFace {
            shape: "card".into(),
            face,
        })
        .collect();
    assert_eq!(edge_on_text(&[]), "");
    let text = edge_on_text(&faces[..1]);
    let starts = "note: the camera sees face 0 of \"card\" exactly";
    assert!(text.starts_with(starts) && text.ends_with('\n'), "{text}");
    let text = edge_on_text(&faces);
    assert!(
        text.contains("face 4 of \"card\" and 2 more faces"),
        "{text}"
    );
}

/// A few pairs are named, the others counted.
#[test]
fn shapes_that_lie_on_each_other_are_named() {
    let pairs: Vec<[String; 2]> = (0..7)
        .map(|i| ["floor".into(), format!("box{i}")])
        .collect();
    assert_eq!(coplanar_text(&[]), "");
    let text = coplanar_text(&pairs[..1]);
    assert!(
        text.starts_with("note: \"floor\" and \"box0\" have faces"),
        "{text}"
    );
    let text = coplanar_text(&pairs);
    assert!(text.contains("box4\" and 2 more pairs"), "{text}");
    assert!(!text.contains("box5") && text.ends_with('\n'), "{text}");
    assert_eq!(touching_text(&[]), "");
    let text = touching_text(&pairs);
    assert!(
        text.contains("\"floor\" on \"box4\" and 2 more pairs)"),
        "{text}"
    );
}
