//! What a pilot chose, and where it is kept.

use std::sync::{Arc, OnceLock};

use capwalk_boundary::refuse::is_specular_somewhere;
use capwalk_boundary::{Method, Refusal};
use capwalk_render::Watch;

use crate::auto::trial::Trial;
use crate::coverage::Coverage;
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
    /// leave nothing to be chosen, or what is kept, or what `choose` gives, the one like the other
    /// as far as it covers what moves now. That becomes known and is kept unless the watch stopped
    /// it: what was stopped says nothing.
    pub(crate) fn of(
        options: &GradientOptions,
        known: &OnceLock<Self>,
        kept: &KeptChoice,
        watch: &dyn Watch,
        coverage: &Coverage,
        refuse: impl FnOnce() -> Result<(), Refusal>,
        choose: impl FnOnce() -> Self,
    ) -> Result<Self, Refusal> {
        if let Some(known) = known.get() {
            return Ok(known.clone());
        }
        refuse()?;
        let chosen = match (options.method.is_open(), kept.0.get()) {
            (true, Some(kept)) => kept.clone().covering_most(options.method, coverage),
            (true, None) => {
                let chosen = choose();
                if watch.should_stop() {
                    return Ok(chosen);
                }
                let kept = kept.0.get_or_init(|| chosen).clone();
                kept.covering_most(options.method, coverage)
            }
            (false, _) => (*options).into(),
        };
        Ok(known.get_or_init(|| chosen.of_work(options)).clone())
    }

    /// What was chosen because a method was asked for. If that leaves all open, edges are gathered wherever
    /// they can be if that leaves fewer specular events uncovered: directions that stay do not move
    /// what is seen in curved mirrors and through glass.
    fn covering_most(self, asked: Method, coverage: &Coverage) -> Self {
        if asked != Method::Auto || !is_specular_somewhere(coverage.prepared.scene()) {
            return self;
        }
        let edges = GradientOptions {
            method: Method::EDGES,
            ..self.options
        };
        let missed = coverage.uncovered(&self.options);
        match missed > 0 && coverage.uncovered(&edges) < missed {
            true => Self {
                options: edges,
                ..self
            },
            false => self,
        }
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
