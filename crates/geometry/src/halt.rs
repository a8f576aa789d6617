//! Work that is worth nothing unless it is finished, such as building a tree: it ends early when
//! somebody no longer waits for it.

use std::sync::atomic::{AtomicBool, Ordering};

/// Says when to give up. Work that asks [`Halt::now`] and is told so returns whatever it has; who
/// began it throws that away ([`Halt::unless_halted`]).
pub struct Halt<'a> {
    should_halt: Option<&'a (dyn Fn() -> bool + Sync)>,
    /// True once the answer was yes. It stays so: what was returned early must not pass for
    /// finished because a later answer is no.
    is_halted: AtomicBool,
}

/// Work was given up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Halted;

impl<'a> Halt<'a> {
    /// Never.
    pub const fn never() -> Self {
        Self {
            should_halt: None,
            is_halted: AtomicBool::new(false),
        }
    }

    /// As soon as this holds.
    pub const fn when(should_halt: &'a (dyn Fn() -> bool + Sync)) -> Self {
        Self {
            should_halt: Some(should_halt),
            is_halted: AtomicBool::new(false),
        }
    }

    /// True if the work is to return at once. Takes less than a microsecond: to be asked every few
    /// milliseconds or more often.
    pub fn now(&self) -> bool {
        let Some(should_halt) = self.should_halt else {
            return false;
        };
        if !self.is_halted.load(Ordering::Relaxed) && should_halt() {
            self.is_halted.store(true, Ordering::Relaxed);
        }
        self.is_halted.load(Ordering::Relaxed)
    }

    /// What was made, if the work was not told to give it up.
    pub fn unless_halted<T>(&self, made: T) -> Result<T, Halted> {
        match self.is_halted.load(Ordering::Relaxed) {
            true => Err(Halted),
            false => Ok(made),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A yes is kept, and what was never asked about is whole.
    #[test]
    fn halts_once_and_for_all() {
        let answer = AtomicBool::new(true);
        let asked = || answer.load(Ordering::Relaxed);
        let halt = Halt::when(&asked);
        assert_eq!(halt.unless_halted(7), Ok(7));
        assert!(halt.now());
        answer.store(false, Ordering::Relaxed);
        assert!(halt.now());
        assert_eq!(halt.unless_halted(7), Err(Halted));
        assert!(!Halt::never().now());
    }
}
