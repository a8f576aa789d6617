//! What parts of the work have given: sent elsewhere, merged, and made a whole.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use capwalk_scene::{pack, unpack};

use crate::grid::{Cell, Grid};
use crate::ordered_sum::{Accumulate, CannotMerge, OrderedSum};
use crate::part_error::PartError;

/// What some cells of the work for an estimate have given. However the work is cut and in
/// which order ever its parts are merged, the bits of the result are the same.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Partial<T> {
    /// Tells this work from every other one.
    work: u64,
    grid: Grid,
    /// Which way its cells are summed.
    along: Along,
    /// The sums: of the batches for each band, or of the bands for each batch.
    sums: Vec<OrderedSum<T>>,
}

/// Which way cells are summed: first over these.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Along {
    /// Batches: one sum for each band of pixels.
    Batches,
    /// Bands: one sum for each batch of samples.
    Bands,
}

impl<T: Accumulate> Partial<T> {
    /// Sums for a work with this [`fingerprint`](capwalk_scene::fingerprint), as many as
    /// `along` says.
    pub fn new(work: u64, grid: Grid, along: Along, sums: Vec<OrderedSum<T>>) -> Self {
        Self {
            work,
            grid,
            along,
            sums,
        }
    }

    /// Which cells are there: those of a part that were finished before the work was stopped.
    pub fn cells(&self) -> Vec<Cell> {
        let sums = (0..).zip(&self.sums);
        sums.flat_map(|(i, sum)| sum.numbers().map(move |number| self.cell(i, number)))
            .collect()
    }

    /// All cells of all of these. They must come from the same work, and no cell may be in
    /// two of them.
    pub fn merge(parts: impl IntoIterator<Item = Self>) -> Result<Self, PartError> {
        let mut parts = parts.into_iter();
        let mut merged = parts.next().ok_or(PartError::Missing { cells: 0, of: 0 })?;
        for part in parts {
            if (part.work, part.grid, part.along) != (merged.work, merged.grid, merged.along) {
                return Err(PartError::DifferentWork);
            }
            for (i, other) in part.sums.into_iter().enumerate() {
                merged.sums[i].merge(other).map_err(|error| match error {
                    CannotMerge::Misfit => misfit(),
                    CannotMerge::Twice(number) => {
                        let Cell { batch, band } = merged.cell(i as u32, number);
                        PartError::Twice { batch, band }
                    }
                })?;
            }
        }
        Ok(merged)
    }

    /// The sums of all cells, which must be `right` for their numbers; an error if some are
    /// missing or belong to another work.
    pub fn complete(
        self,
        work: u64,
        grid: Grid,
        right: impl Fn(u32, &T) -> bool,
    ) -> Result<Vec<T>, PartError> {
        if (self.work, self.grid) != (work, grid) {
            return Err(PartError::DifferentWork);
        }
        let present = self.cells().len() as u64;
        let of = u64::from(grid.batches) * u64::from(grid.bands);
        if present < of {
            return Err(PartError::Missing {
                cells: of - present,
                of,
            });
        }
        let sums = self.into_sums();
        let are_right = (0..).zip(&sums).all(|(i, sum)| right(i, sum));
        are_right.then_some(sums).ok_or_else(misfit)
    }

    /// The sums of a work that was not cut.
    pub fn into_sums(self) -> Vec<T> {
        let sums = self.sums.into_iter();
        sums.filter_map(OrderedSum::into_sum).collect()
    }

    /// The cell with a number in one of the sums.
    fn cell(&self, sum: u32, number: u32) -> Cell {
        match self.along {
            Along::Batches => Cell {
                batch: number,
                band: sum,
            },
            Along::Bands => Cell {
                batch: sum,
                band: number,
            },
        }
    }

    fn is_valid(&self) -> bool {
        let Grid { batches, bands } = self.grid;
        let (sums, terms) = match self.along {
            Along::Batches => (bands, batches),
            Along::Bands => (batches, bands),
        };
        self.sums.len() == sums as usize && self.sums.iter().all(|sum| sum.is_valid(terms))
    }
}

fn misfit() -> PartError {
    PartError::Bytes {
        reason: "their numbers do not fit the work".into(),
    }
}

impl<T: Accumulate + Serialize + DeserializeOwned> Partial<T> {
    /// The bytes to send it elsewhere, with a checksum. Read them with the same version.
    pub fn to_bytes(&self) -> Result<Vec<u8>, PartError> {
        Ok(pack(self)?)
    }

    /// What [`Partial::to_bytes`] made.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, PartError> {
        let partial: Self = unpack(bytes)?;
        partial.is_valid().then_some(partial).ok_or_else(misfit)
    }
}
