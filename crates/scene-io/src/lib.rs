//! See ARCHITECTURE.md.

mod atomic;
pub mod export;
