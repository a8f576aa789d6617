//! A method as it is typed.

use capwalk::{Choice, MethodName};

/// A method of the library, or the one that the command line adds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TypedMethod {
    /// One that differentiates samples.
    Of(MethodName),
    /// Central finite differences, for `gradient`.
    Fd,
}

impl TypedMethod {
    /// The name as it is typed.
    pub fn name(self) -> &'static str {
        match self {
            Self::Of(method) => method.name(),
            Self::Fd => "fd",
        }
    }
}
