//! What parts of the work have given: sent elsewhere, merged, and made a whole.

use std::fmt::{self, Write};
use std::hash::{DefaultHasher, Hasher};

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::grid::Grid;
use crate::ordered_sum::{Accumulate, OrderedSum};
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
    /// Sums for a work with this [`fingerprint`], as many as `along` says.
    pub fn new(work: u64, grid: Grid, along: Along, sums: Vec<OrderedSum<T>>) -> Self {
        Self {
            work,
            grid,
            along,
            sums,
        }
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
            let pairs = merged.sums.iter_mut().zip(part.sums);
            for (i, (sum, other)) in (0..).zip(pairs) {
                sum.merge(other).map_err(|number| {
                    let (batch, band) = match merged.along {
                        Along::Batches => (number, i),
                        Along::Bands => (i, number),
                    };
                    PartError::Twice { batch, band }
                })?;
            }
        }
        Ok(merged)
    }

    /// The sums of all cells; an error if some are missing or belong to another work.
    pub fn complete(self, work: u64, grid: Grid) -> Result<Vec<T>, PartError> {
        if (self.work, self.grid) != (work, grid) {
            return Err(PartError::DifferentWork);
        }
        let there: u32 = self.sums.iter().map(OrderedSum::count).sum();
        let of = grid.batches * grid.bands;
        match there == of {
            true => Ok(self.into_sums()),
            false => Err(PartError::Missing {
                cells: of - there,
                of,
            }),
        }
    }

    /// The sums of a work that was not cut.
    pub fn into_sums(self) -> Vec<T> {
        let sums = self.sums.into_iter();
        sums.filter_map(OrderedSum::into_sum).collect()
    }
}

impl<T: Serialize + DeserializeOwned> Partial<T> {
    /// The bytes to send it elsewhere, with a checksum. Read them with the same version.
    pub fn to_bytes(&self) -> Result<Vec<u8>, PartError> {
        let mut bytes = postcard::to_allocvec(self).map_err(|error| PartError::Bytes {
            reason: error.to_string(),
        })?;
        bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
        Ok(bytes)
    }

    /// What [`Partial::to_bytes`] made.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, PartError> {
        let damaged = |reason: &str| PartError::Bytes {
            reason: reason.into(),
        };
        let (content, checksum) = bytes
            .split_last_chunk::<4>()
            .ok_or_else(|| damaged("they are too few"))?;
        if crc32fast::hash(content).to_le_bytes() != *checksum {
            return Err(damaged("their checksum is wrong"));
        }
        postcard::from_bytes(content).map_err(|error| damaged(&error.to_string()))
    }
}

/// A number that tells works apart: of everything that its result depends on. The same on
/// all machines.
pub fn fingerprint(inputs: &[&dyn fmt::Debug]) -> u64 {
    let mut hash = Hash(DefaultHasher::new());
    let mut write = |input: &dyn fmt::Debug| {
        write!(hash, "{input:?};").expect("a hash takes everything");
    };
    write(&env!("CARGO_PKG_VERSION"));
    inputs.iter().for_each(|input| write(input));
    hash.0.finish()
}

/// Hashes what is written.
struct Hash(DefaultHasher);

impl Write for Hash {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.write(text.as_bytes());
        Ok(())
    }
}
