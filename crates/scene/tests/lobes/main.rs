//! Every lobe against the laws that all lobes obey. The table of lobes is in
//! `table.rs`; a new lobe is tested by being added there.

mod chi_squared;
mod derivatives;
mod energy;
mod finite;
mod jacobian;
mod known;
mod means;
mod sides;
mod table;
mod tilted;
mod tools;
