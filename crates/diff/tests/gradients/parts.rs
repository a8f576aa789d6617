//! Work that is cut, sent as bytes and merged in any order gives the bits of the whole.

use std::borrow::Cow;

use crate::common::stages::visible_cube;
use capwalk_diff::{
    BackwardWork, Cell, GradientOptions, GradientWork, Grid, Method, Part, PartError, Partial,
    PreparedScene, RenderOptions, RenderWork, Unwatched, Wanted, Watch, backward, gradient, render,
    with_threads,
};
use capwalk_math::Rgb;
use capwalk_scene::params::Registry;
use capwalk_scene::{Gradient, Image, SamplerKind, Scene};

const CUTS: [u32; 4] = [1, 2, 7, 40];

fn bits(images: [&Image; 2]) -> Vec<u64> {
    let pixels = images.into_iter().flat_map(|image| &image.pixels);
    pixels
        .flat_map(|pixel| pixel.to_array())
        .map(f64::to_bits)
        .collect()
}

fn bits_of_gradient(gradient: &Gradient) -> Vec<u64> {
    let bits = std::cell::RefCell::new(Vec::new());
    gradient.map(|x| {
        bits.borrow_mut().push(x.to_bits());
        x
    });
    bits.into_inner()
}

/// An order that is neither that of the parts nor its reverse.
fn shuffled<T>(mut parts: Vec<T>) -> Vec<T> {
    let mut result = Vec::new();
    while !parts.is_empty() {
        let i = (7 * parts.len() + 3) % parts.len().max(1);
        result.push(parts.swap_remove(i * 3 % parts.len()));
    }
    result
}

fn through_bytes<T>(partial: &Partial<T>) -> Partial<T>
where
    T: capwalk_render::Accumulate + serde::Serialize + serde::de::DeserializeOwned,
{
    let bytes = partial.to_bytes().expect("numbers");
    Partial::from_bytes(&bytes).expect("whole bytes")
}

fn scene() -> Scene {
    let mut scene = visible_cube();
    scene.film.size = [9, 7];
    scene.film.crop_size = [9, 7];
    scene
}

fn adjoint() -> Image {
    let mut adjoint = Image::new(9, 7);
    for (i, pixel) in adjoint.pixels.iter_mut().enumerate() {
        *pixel = Rgb::new(0.1 * i as f64, -1.0, (i as f64).cos());
    }
    adjoint
}

/// Options with the grid as it is, and with more batches than usual.
fn all_options() -> Vec<GradientOptions> {
    let more = Grid {
        batches: 50,
        bands: 7,
    };
    let mut all = Vec::new();
    let methods = [
        (Method::Walk, Grid::DEFAULT),
        (Method::EDGES, more),
        (Method::Auto, Grid::DEFAULT),
    ];
    for (method, grid) in methods {
        all.push(GradientOptions {
            method,
            grid,
            ..GradientOptions::new(RenderOptions::new(50, 4))
        });
    }
    all.push(GradientOptions {
        adaptive: true,
        ..all[1]
    });
    all
}

#[test]
fn images() {
    for sampler in [SamplerKind::Independent, SamplerKind::Sobol] {
        let mut scene = scene();
        scene.settings.sampler = sampler;
        let prepared = PreparedScene::new(scene);
        for (spp, adaptive) in [
            (1, false),
            (40, false),
            (100, false),
            (40, true),
            (100, true),
        ] {
            let options = RenderOptions {
                adaptive,
                ..RenderOptions::new(spp, 9)
            };
            let whole = render(&prepared, &options, &Unwatched);
            let expected = bits([&whole.value.mean, &whole.value.standard_error]);
            let work = RenderWork::new(&prepared, options);
            for count in CUTS {
                let parts: Vec<_> = (0..count)
                    .map(|i| {
                        let part = Part::nth(work.grid(), i, count).expect("a part");
                        through_bytes(&work.part(&part, &Unwatched).expect("its own grid"))
                    })
                    .collect();
                let merged = Partial::merge(shuffled(parts)).expect("parts of one work");
                let found = work.finish(merged).expect("all parts");
                assert_eq!(found.statistics, whole.statistics);
                let found = bits([&found.value.mean, &found.value.standard_error]);
                assert!(
                    found == expected,
                    "{sampler:?}, {spp} samples, {count} parts"
                );
            }
        }
    }
}

#[test]
fn forward_derivatives() {
    let prepared = PreparedScene::new(scene());
    let registry = Registry::new(prepared.scene());
    let tangent = registry.tangent(prepared.scene(), "thing.translate.x");
    let tangent = tangent.expect("a cube");
    for options in all_options() {
        let whole = gradient(&prepared, &tangent, &options, &Unwatched).expect("covered");
        let expected = bits([&whole.gradient.mean, &whole.gradient.standard_error]);
        let work = GradientWork::new(&prepared, Cow::Borrowed(&tangent), options);
        for count in CUTS {
            let parts: Vec<_> = (0..count)
                .map(|i| {
                    let part = Part::nth(work.grid(), i, count).expect("a part");
                    let partial = with_threads(1 + i as usize % 3, || work.part(&part, &Unwatched));
                    through_bytes(&partial.expect("covered"))
                })
                .collect();
            let merged = Partial::merge(shuffled(parts)).expect("parts of one work");
            let found = work.finish(merged).expect("all parts");
            assert_eq!(found.statistics, whole.statistics);
            let found = bits([&found.gradient.mean, &found.gradient.standard_error]);
            assert!(found == expected, "{:?}, {count} parts", options.method);
        }
    }
}

#[test]
fn reverse_gradients() {
    let prepared = PreparedScene::new(scene());
    let (adjoint, wanted) = (adjoint(), Wanted::all(prepared.scene()));
    for options in all_options() {
        let whole = backward(&prepared, &adjoint, &wanted, &options, &Unwatched);
        let whole = whole.expect("covered");
        let work = BackwardWork::new(&prepared, &adjoint, wanted.clone(), options);
        let grid = work.grid();
        let mut cuts: Vec<Vec<Part>> = Vec::new();
        for count in CUTS {
            let parts = (0..count).map(|i| Part::nth(grid, i, count).expect("a part"));
            cuts.push(parts.collect());
        }
        // By batches, and by bands of pixels.
        let batches = [0..3, 3..7, 7..grid.batches];
        let batches = batches.map(|range| Part::batches(grid, range).expect("batches"));
        cuts.push(batches.to_vec());
        let bands = [0..1, 1..grid.bands].map(|range| Part::bands(grid, range).expect("bands"));
        cuts.push(bands.to_vec());
        for parts in cuts {
            let partials = parts.iter().map(|part| {
                let partial = work.part(part, &Unwatched).expect("covered");
                through_bytes(&partial)
            });
            let merged = Partial::merge(shuffled(partials.collect())).expect("one work");
            let found = work.finish(merged).expect("all parts");
            assert_eq!(found.statistics, whole.statistics);
            for (found, expected) in [
                (found.gradient(), whole.gradient()),
                (&found.standard_error(), &whole.standard_error()),
            ] {
                let (found, expected) = (bits_of_gradient(found), bits_of_gradient(expected));
                assert!(
                    found == expected,
                    "{:?}, {} parts",
                    options.method,
                    parts.len()
                );
            }
        }
    }
}

/// Stops after some progress.
struct StopsAt(u64, std::sync::atomic::AtomicU64);

impl Watch for StopsAt {
    fn progress(&self, done: u64, _: u64) {
        self.1.fetch_max(done, std::sync::atomic::Ordering::Relaxed);
    }
    fn should_stop(&self) -> bool {
        self.1.load(std::sync::atomic::Ordering::Relaxed) >= self.0
    }
}

/// The part that is left of a work that stopped halfway.
fn missing(grid: Grid, done: &[Cell]) -> Part {
    let missing: Vec<_> = grid.cells().filter(|cell| !done.contains(cell)).collect();
    assert!(
        !done.is_empty() && !missing.is_empty(),
        "{} cells done",
        done.len()
    );
    Part::cells(grid, &missing).expect("its cells")
}

/// A part that is stopped has what was finished; the rest is another part.
#[test]
fn stopped_work_goes_on() {
    let prepared = PreparedScene::new(scene());
    let (adjoint, wanted) = (adjoint(), Wanted::all(prepared.scene()));
    let options = all_options()[0];
    let whole = backward(&prepared, &adjoint, &wanted, &options, &Unwatched).expect("covered");
    let work = BackwardWork::new(&prepared, &adjoint, wanted, options);
    let grid = work.grid();
    let stop = StopsAt(9 * 7 * 20, 0.into());
    let first = work.part(&Part::whole(grid), &stop).expect("covered");
    let rest = missing(grid, &first.cells());
    let rest = work.part(&rest, &Unwatched).expect("covered");
    let found = work.finish(Partial::merge([rest, first]).expect("one work"));
    let found = found.expect("all cells");
    assert!(bits_of_gradient(found.gradient()) == bits_of_gradient(whole.gradient()));

    let image = render(&prepared, &options.sampling(), &Unwatched);
    let work = RenderWork::new(&prepared, options.sampling());
    let stop = StopsAt(9 * 7 * 20, 0.into());
    let first = work.part(&Part::whole(grid), &stop).expect("its grid");
    let rest = missing(grid, &first.cells());
    let rest = work.part(&rest, &Unwatched).expect("its grid");
    let found = work.finish(Partial::merge([first, rest]).expect("one work"));
    assert_eq!(found.expect("all cells").value, image.value);
}

/// Numbers of another work with the fingerprint of this one.
#[test]
fn forged_parts() {
    let prepared = PreparedScene::new(scene());
    let options = RenderOptions::new(4, 1);
    let work = RenderWork::new(&prepared, options);
    let part = work.part(&Part::whole(work.grid()), &Unwatched);
    let bytes = part.expect("its grid").to_bytes().expect("numbers");
    // Each byte that tells how many there are of something, one after the other.
    for i in 0..bytes.len().min(60) {
        for change in [1, 3, 0x80] {
            let mut forged = bytes[..bytes.len() - 4].to_vec();
            forged[i] = forged[i].wrapping_add(change);
            forged.extend(crc32fast::hash(&forged).to_le_bytes());
            if let Ok(partial) = Partial::from_bytes(&forged) {
                // An error or other numbers, but no panic.
                let _ = work.finish(partial);
            }
        }
    }
}

/// What does not belong together is not put together.
#[test]
fn wrong_parts() {
    let prepared = PreparedScene::new(scene());
    let work = RenderWork::new(&prepared, RenderOptions::new(4, 1));
    let grid = work.grid();
    let part = |i| Part::nth(grid, i, 3).expect("a part");
    let of = |work: &RenderWork, i| work.part(&part(i), &Unwatched).expect("its own grid");
    let [a, b, c] = [0, 1, 2].map(|i| of(&work, i));

    let merged = Partial::merge([a.clone(), b.clone()]).expect("parts of one work");
    let missing = work.finish(merged).expect_err("one is missing");
    assert!(
        matches!(missing, PartError::Missing { cells: 6, of: 16 }),
        "{missing}"
    );

    let twice = Partial::merge([a.clone(), b.clone(), a.clone(), c]).expect_err("a counts twice");
    assert!(matches!(twice, PartError::Twice { .. }), "{twice}");

    // Another seed, another scene.
    let other = RenderWork::new(&prepared, RenderOptions::new(4, 2));
    let different = Partial::merge([a.clone(), of(&other, 1)]).expect_err("another seed");
    assert_eq!(different, PartError::DifferentWork);
    let mut moved = scene();
    moved.shapes_mut().next().expect("a shape").mesh.positions[0].x += 1e-15;
    let moved = PreparedScene::new(moved);
    let other = RenderWork::new(&moved, RenderOptions::new(4, 1));
    let different = Partial::merge([a.clone(), of(&other, 1)]).expect_err("another scene");
    assert_eq!(different, PartError::DifferentWork);
    let whole = Part::whole(grid);
    let of_other = other.part(&whole, &Unwatched).expect("its own grid");
    assert_eq!(work.finish(of_other).err(), Some(PartError::DifferentWork));

    let not_its_own = Part::whole(Grid::DEFAULT);
    let error = work
        .part(&not_its_own, &Unwatched)
        .expect_err("another grid");
    assert!(matches!(error, PartError::NotInGrid { .. }), "{error}");

    let mut bytes = b.to_bytes().expect("numbers");
    bytes[40] ^= 1;
    for bytes in [&bytes[..], &[], &[1, 2]] {
        let error = Partial::<capwalk_diff::PixelSums>::from_bytes(bytes).expect_err("damaged");
        assert!(matches!(error, PartError::Bytes { .. }), "{error}");
    }
}
