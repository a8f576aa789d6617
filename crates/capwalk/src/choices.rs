//! The methods that pilots chose for a scene, kept from call to call.

use std::sync::{Mutex, PoisonError};

use capwalk_diff::{GradientOptions, KeptChoice, Method, PilotSize, WalkSettings, Wanted};
use capwalk_scene::Scene;

/// Most choices that are kept: more, the oldest is forgotten.
const MOST_KEPT: usize = 256;

/// What pilots chose, by what they were asked.
#[derive(Debug, Default)]
pub struct Choices {
    kept: Mutex<Vec<(Question, KeptChoice)>>,
}

/// What is differentiated.
#[derive(Clone, Debug, PartialEq)]
pub enum Differentiated {
    /// The image, along a direction of this name.
    Along(String),
    /// A loss, with respect to this.
    Loss(Wanted),
}

/// What a choice depends on besides the scene.
#[derive(Clone, Debug, PartialEq)]
struct Question {
    what: Differentiated,
    method: Method,
    walk: WalkSettings,
    is_blind: bool,
    size: PilotSize,
}

impl Choices {
    /// The place of a choice.
    pub fn of(&self, scene: &Scene, what: Differentiated, options: &GradientOptions) -> KeptChoice {
        let question = Question {
            what,
            method: options.method,
            walk: options.walk,
            is_blind: options.blind,
            size: PilotSize::of(scene, options, 1),
        };
        // Nothing is left half done in it.
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, choice)) = kept.iter().find(|(known, _)| *known == question) {
            return choice.clone();
        }
        let choice = KeptChoice::default();
        if kept.len() == MOST_KEPT {
            kept.remove(0);
        }
        kept.push((question, choice.clone()));
        choice
    }
}
