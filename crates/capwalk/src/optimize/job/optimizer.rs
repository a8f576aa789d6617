//! How the loss is made smaller: `[optimizer]`, `[samples]`, `[schedule]`, `[loss]`, `[guards]` and
//! `[stop]`.

use capwalk_inverse::Limits;
use capwalk_inverse::adam::Adam;
use capwalk_inverse::guard::Guards;
use capwalk_inverse::loss::{Distance, Loss};
use capwalk_inverse::samples::{ByNoise, COSTS, LEAST};
use capwalk_inverse::schedule::{Decay, Schedule};
use capwalk_scene_io::LoadError;
use capwalk_scene_io::toml::Table;

use super::table::{MOST, fraction, integer, number, positive, truth};

/// The learning rate, the rest of Adam, and whether all parameters are uniform.
pub fn optimizer(root: &Table) -> Result<(f64, Adam, bool), LoadError> {
    let missing = "an [optimizer] with its learning rate `lr`";
    let table = root.require("optimizer", missing)?.table("[optimizer]")?;
    if let Some(kind) = table.get("type") {
        kind.choice(&[("adam", ())])?;
    }
    table.require("lr", "the learning rate, a number above 0")?;
    let lr = positive(&table, "lr")?.unwrap_or_default();
    let mut adam = Adam::default();
    if let Some(betas) = table.get("betas") {
        let expected = "two numbers from 0 to below 1, such as [0.9, 0.999]";
        adam.betas = betas.array::<2>(expected)?;
        if !adam.betas.iter().all(|beta| (0.0..1.0).contains(beta)) {
            return Err(betas.wrong(expected));
        }
    }
    // Adam divides by it where there is no gradient.
    if let Some(eps) = positive(&table, "eps")? {
        adam.eps = eps;
    }
    let uniform = truth(&table, "uniform")?.unwrap_or(false);
    table.finish()?;
    Ok((lr, adam, uniform))
}

/// That sample counts follow the noise.
#[derive(Clone, Copy, Debug)]
pub struct SamplesKeys {
    theta: f64,
    pub most: Option<u32>,
}

impl SamplesKeys {
    /// The rule, if the gradient of the first step has so many samples, and whether anything may move.
    pub fn rule(self, spp_grad: u32, moves: bool) -> ByNoise {
        ByNoise {
            theta: self.theta,
            most: (self.most).unwrap_or(spp_grad.saturating_mul(MOST_TIMES)),
            cost: if moves { COSTS[0] } else { COSTS[1] },
        }
    }
}

/// The most samples, if a job does not say how many, as a multiple of those of the first gradient.
const MOST_TIMES: u32 = 16;

/// The fewest samples per pixel of a gradient, where sample counts follow the noise or not.
pub fn least_of_gradients(by_noise: bool) -> u32 {
    if by_noise { LEAST[1] } else { 1 }
}

/// How sample counts follow the noise, if they do; the first gradient has so many.
pub fn samples(root: &Table, first: u32) -> Result<Option<SamplesKeys>, LoadError> {
    let Some(table) = root.table("samples")? else {
        return Ok(None);
    };
    let keys = SamplesKeys {
        theta: positive(&table, "theta")?.unwrap_or(0.9),
        most: integer(&table, "most", first.into()..=MOST)?.map(|n| n as u32),
    };
    table.finish()?;
    Ok(Some(keys))
}

/// The schedule of the learning rate; constant without.
pub fn schedule(root: &Table) -> Result<Schedule, LoadError> {
    let mut schedule = Schedule {
        warmup: 0,
        decay: Decay::Constant,
    };
    let Some(table) = root.table("schedule")? else {
        return Ok(schedule);
    };
    #[derive(Clone, Copy)]
    enum Kind {
        Constant,
        Exponential,
        Step,
        Linear,
        Cosine,
    }
    let kinds = [
        ("constant", Kind::Constant),
        ("exponential", Kind::Exponential),
        ("step", Kind::Step),
        ("linear", Kind::Linear),
        ("cosine", Kind::Cosine),
    ];
    let kind = match table.get("type") {
        Some(value) => value.choice(&kinds)?,
        None => Kind::Constant,
    };
    let gamma = |default: f64| Ok(fraction(&table, "gamma")?.unwrap_or(default));
    let end = || Ok(fraction(&table, "end")?.unwrap_or(0.0));
    schedule.decay = match kind {
        Kind::Constant => Decay::Constant,
        Kind::Exponential => Decay::Exponential {
            gamma: gamma(0.99)?,
        },
        Kind::Step => Decay::Step {
            gamma: gamma(0.1)?,
            step_size: table
                .require("step_size", "after how many iterations the rate falls")?
                .integer(1..=MOST)? as u32,
        },
        Kind::Linear => Decay::Linear { end: end()? },
        Kind::Cosine => Decay::Cosine { end: end()? },
    };
    schedule.warmup = integer(&table, "warmup", 0..=MOST)?.unwrap_or(0) as u32;
    table.finish()?;
    Ok(schedule)
}

/// The loss; the mean squared difference without.
pub fn loss(root: &Table) -> Result<Loss, LoadError> {
    let mut loss = Loss {
        distance: Distance::L2,
        levels: 1,
    };
    let Some(table) = root.table("loss")? else {
        return Ok(loss);
    };
    let epsilon = 0.01;
    let kinds = [
        ("l1", Distance::L1),
        ("l2", Distance::L2),
        ("relative", Distance::Relative { epsilon }),
        ("log", Distance::Log { epsilon }),
    ];
    if let Some(kind) = table.get("type") {
        loss.distance = kind.choice(&kinds)?;
    }
    match &mut loss.distance {
        Distance::Relative { epsilon } | Distance::Log { epsilon } => {
            *epsilon = positive(&table, "epsilon")?.unwrap_or(*epsilon);
        }
        Distance::L1 | Distance::L2 => {}
    }
    loss.levels = integer(&table, "pyramid", 1..=32)?.unwrap_or(1) as u32;
    table.finish()?;
    Ok(loss)
}

/// What a step must not do; both guards are on without.
pub fn guards(root: &Table) -> Result<Guards, LoadError> {
    let mut guards = Guards::default();
    if let Some(table) = root.table("guards")? {
        guards.inversion = truth(&table, "inversion")?.unwrap_or(true);
        guards.self_intersection = truth(&table, "self_intersection")?.unwrap_or(true);
        table.finish()?;
    }
    Ok(guards)
}

/// When to stop.
pub fn limits(root: &Table, iterations: u32) -> Result<Limits, LoadError> {
    let mut limits = Limits {
        iterations,
        ..Limits::default()
    };
    if let Some(table) = root.table("stop")? {
        limits.loss_below = number(&table, "loss_below", "a finite number", |_| true)?;
        limits.patience = integer(&table, "patience", 1..=MOST)?.map(|n| n as u32);
        table.finish()?;
    }
    Ok(limits)
}
