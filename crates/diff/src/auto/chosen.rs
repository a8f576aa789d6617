//! What a pilot chose, and where it is kept.

use std::sync::{Arc, OnceLock};

use capwalk_boundary::Refusal;
use capwalk_render::Watch;

use crate::auto::trial::Trial;
use crate::options::GradientOptions;

/// A gradient's options with the method that a pilot chose, and what it tried.
#[derive(Clone, Debug, PartialEq)]
pub struct Chosen {
    /// The options that were asked for, with the chosen method and its walk.
    pub options: GradientOptions,
    /// What was tried, in this order; nothing if nothing had to be chosen.
    pub trials: Vec<Trial>,
}

/// A place for one choice, that of the first work which it is given to: later work that it is
/// given to takes the same method, and needs no pilot. Clones are the same place.
#[derive(Clone, Debug, Default)]
pub struct KeptChoice(Arc<OnceLock<Chosen>>);

/// Options that leave nothing to be chosen.
impl From<GradientOptions> for Chosen {
    fn from(options: GradientOptions) -> Self {
        Self {
            options,
            trials: Vec::new(),
        }
    }
}

impl Chosen {
    /// What is known, or else what was asked for.
    pub(crate) fn known_or_asked(known: &OnceLock<Self>, options: &GradientOptions) -> Self {
        known.get().cloned().unwrap_or((*options).into())
    }

    /// What is known; else, unless `refuse` has an objection, the options themselves if they
    /// leave nothing to be chosen, or what is kept, or what `choose` gives. That becomes known and is kept unless the watch stopped
    /// it: what was stopped says nothing.
    pub(crate) fn of(
        options: &GradientOptions,
        known: &OnceLock<Self>,
        kept: &KeptChoice,
        watch: &dyn Watch,
        refuse: impl FnOnce() -> Result<(), Refusal>,
        choose: impl FnOnce() -> Self,
    ) -> Result<Self, Refusal> {
        if let Some(known) = known.get() {
            return Ok(known.clone());
        }
        refuse()?;
        let chosen = match (options.method.is_open(), kept.0.get()) {
            (true, Some(kept)) => kept.clone(),
            (true, None) => {
                let chosen = choose();
                if watch.should_stop() {
                    return Ok(chosen);
                }
                kept.0.get_or_init(|| chosen).clone()
            }
            (false, _) => (*options).into(),
        };
        Ok(known.get_or_init(|| chosen.of_work(options)).clone())
    }

    /// This choice for other work: its options with this method.
    fn of_work(self, options: &GradientOptions) -> Self {
        let GradientOptions { method, walk, .. } = self.options;
        Self {
            options: GradientOptions {
                method,
                walk,
                ..*options
            },
            ..self
        }
    }
}
