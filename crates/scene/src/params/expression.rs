//! `ball.translate.x + 0.5*lamp.translate.y`: names with signs and factors.

use super::element::{self, Element};
use super::error::ParameterError;
use super::registry::Registry;
use super::target::Target;

/// A parameter times a number.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Term {
    pub factor: f64,
    pub named: Named,
}

/// What a term names.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Named {
    Target(Target),
    Element(Element),
}

/// The terms of a sum. A name is the longest registered one at its place that
/// ends where the text or the term ends, so ids may contain signs and dots.
pub(super) fn parse(registry: &Registry, text: &str) -> Result<Vec<Term>, ParameterError> {
    let mut terms = Vec::new();
    let mut rest = text.trim_start();
    loop {
        let mut factor = 1.0;
        // A sign before a term joins it to the ones before it; without one
        // only the first term may stand. Names are tried first.
        let (named, after) = loop {
            if let Some((target, after)) = registry.leading_scalar(rest)? {
                break (Named::Target(target), after);
            }
            if let Some((element, after)) = element::leading(registry, rest)? {
                break (Named::Element(element), after);
            }
            if let Some(after) = rest.strip_prefix('-') {
                factor = -factor;
                rest = after.trim_start();
            } else if let Some(after) = rest.strip_prefix('+') {
                rest = after.trim_start();
            } else if let Some((number, after)) = split_factor(rest)? {
                factor *= number;
                rest = after.trim_start();
            } else {
                return Err(unknown(rest));
            }
        };
        terms.push(Term { factor, named });
        rest = after.trim_start();
        if rest.is_empty() {
            return Ok(terms);
        }
    }
}

/// The number before `*` and the text behind it, or `None` if this term has no
/// `*`.
fn split_factor(text: &str) -> Result<Option<(f64, &str)>, ParameterError> {
    let Some((before, after)) = text.split_once('*') else {
        return Ok(None);
    };
    let before = before.trim();
    match before.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(Some((number, after))),
        // The `*` belongs to a later term: this one is an unknown name.
        Err(_) if before.contains('+') => Ok(None),
        _ => Err(ParameterError::BadFactor {
            text: before.into(),
        }),
    }
}

/// An error that says what was asked for; names like it are for the caller to
/// find, who knows all of them.
fn unknown(rest: &str) -> ParameterError {
    // Up to the next `+`: ids seldom contain it, but often a `-`.
    match rest.split('+').next().unwrap_or(rest).trim() {
        "" => ParameterError::Missing,
        name => ParameterError::Unknown {
            name: name.into(),
            near: Vec::new(),
        },
    }
}
