//! Where images and derivatives are computed, and what results say of it.

use capwalk::{
    CheckOptions, Device, DifferenceOptions, Distance, Error, GradientOptions, Image, Loss, Method,
    Part, Prepared, RenderOptions, Statistics, Unwatched, UsedDevice,
};

const NAME: &str = "leaf.translate.x";

fn leaf() -> Prepared {
    let loaded = capwalk::Loader::new("leaf").size([8, 6]).load();
    Prepared::new(loaded.expect("built in").scene).expect("it can be rendered")
}

/// Where everything is computed with these options: what a GPU can compute, and what it cannot yet.
fn all_on(device: Device) -> [Vec<Result<UsedDevice, Error>>; 2] {
    let prepared = leaf();
    let (names, image) = ([NAME], Image::new(8, 6));
    let options = GradientOptions {
        device,
        method: Method::EDGES,
        ..RenderOptions::new(2, 0).into()
    };
    let (options, sampling) = (&options, &options.sampling());
    let loss = Loss {
        distance: Distance::L2,
        levels: 1,
    };
    let loss = || prepared.loss(&loss, &image, None, sampling, &Unwatched);
    let check = CheckOptions {
        gradient: *options,
        ..CheckOptions::default()
    };
    let gradient_in_parts = || -> Result<Statistics, Error> {
        let work = prepared.gradient_work(NAME, options)?;
        Ok(work.whole(&Unwatched)?.statistics)
    };
    let backward_in_parts = || -> Result<Statistics, Error> {
        let work = prepared.backward_work(&image, &names, options)?;
        Ok(work.whole(&Unwatched)?.statistics)
    };
    let render_in_parts = || -> Result<Statistics, Error> {
        let work = prepared.render_work(sampling)?;
        let part = work.part(&Part::whole(work.grid()), &Unwatched)?;
        Ok(work.finish(part)?.statistics)
    };
    let checked = prepared.check(NAME, &check, &Unwatched);
    let chosen = prepared.choose(NAME, options, &Unwatched);
    let chosen_backward = prepared.choose_backward(&image, &names, options, &Unwatched);
    let with_gpu = vec![
        prepared.render(sampling, &Unwatched).map(|x| x.statistics),
        prepared
            .gradient(NAME, options, &Unwatched)
            .map(|x| x.statistics),
        prepared
            .backward(&image, &names, options, &Unwatched)
            .map(|x| x.statistics),
        loss().map(|x| x.statistics),
    ];
    let without = vec![
        render_in_parts(),
        gradient_in_parts(),
        backward_in_parts(),
        checked.map(|check| check.gradient.statistics),
        chosen.map(|_| Statistics::default()),
        chosen_backward.map(|_| Statistics::default()),
    ];
    [with_gpu, without].map(|all| {
        let all = all.into_iter();
        all.map(|found| Ok(found?.device)).collect()
    })
}

/// A GPU that is asked for is taken, or there is none; nothing takes the CPU in silence.
#[test]
fn a_gpu_is_taken_or_refused() {
    let [with_gpu, without] = all_on(Device::Gpu);
    for (number, found) in with_gpu.iter().enumerate() {
        let is_right = match found {
            Ok(device) => device.gpu.is_some(),
            Err(error) => matches!(error, Error::Device(_)),
        };
        assert!(is_right, "{number}: {found:?}");
    }
    for (number, found) in without.into_iter().enumerate() {
        let text = found.expect_err("there is none yet").to_string();
        let says = text.contains("has no GPU yet: use the device cpu, or auto");
        assert!(says, "{number}: {text}");
    }
}

#[test]
fn where_any_device_will_do_everything_is_computed() {
    let [with_gpu, without] = all_on(Device::Auto);
    for found in with_gpu {
        found.expect("any device will do");
    }
    for found in without {
        assert_eq!(found.expect("the CPU will do"), UsedDevice::default());
    }
}

/// Results say by which method they are, and the options that come with it give their bits.
#[test]
fn results_know_their_method() {
    let (prepared, names, image) = (leaf(), [NAME], Image::new(8, 6));
    let options = GradientOptions::new(RenderOptions::new(512, 1));
    let anywhere = GradientOptions {
        device: Device::Auto,
        ..options
    };
    let chosen = prepared.choose(NAME, &anywhere, &Unwatched).expect("one");
    assert!(!chosen.options.method.is_open() && !chosen.trials.is_empty());
    // That of the CPU.
    assert_eq!(chosen.options.device, Device::Cpu);
    let found = prepared.gradient(NAME, &options, &Unwatched);
    let found = found.expect("covered");
    assert_eq!(found.chosen.as_ref(), Some(&chosen));
    let same = prepared.gradient(NAME, &chosen.options, &Unwatched);
    assert!(same.expect("covered").gradient == found.gradient);
    let chosen = prepared.choose_backward(&image, &names, &options, &Unwatched);
    let found = prepared.backward(&image, &names, &options, &Unwatched);
    assert_eq!(found.expect("covered").chosen, chosen.expect("one"));
    let differences = DifferenceOptions::default();
    let found = prepared.finite_difference(NAME, &differences, &Unwatched);
    assert_eq!(found.expect("a step").chosen, None);
    // Parts that are merged by who has chosen nothing are by the method that was asked for.
    let work = || prepared.gradient_work(NAME, &options).expect("a name");
    let (worker, merger) = (work(), work());
    let part = worker.part(&Part::whole(worker.grid()), &Unwatched);
    let merged = merger.finish(part.expect("covered")).expect("all of it");
    assert_eq!(merged.chosen, Some(options.into()));
}
