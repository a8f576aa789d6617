//! How the samples of an image are cut into cells, and which of them make a part.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use crate::part_error::PartError;

/// The samples of all pixels, cut into batches of samples and bands of pixel rows. Each
/// cell is summed by itself, and the sums are added in a fixed order, so that the result
/// has the same bits whoever has computed which cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Grid {
    /// Batches that the samples of each pixel are cut into, at least 1. As many as there
    /// are samples make each one a batch. In reverse mode the spread of the batches gives
    /// the standard errors.
    pub batches: u32,
    /// Bands of rows that the image is cut into, at least 1. As many as there are rows
    /// make each one a band.
    pub bands: u32,
}

impl Default for Grid {
    /// [`Grid::DEFAULT`].
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl Grid {
    /// 16 batches, 4 bands.
    pub const DEFAULT: Self = Self {
        batches: 16,
        bands: 4,
    };

    /// The grid without cells that would be empty: at most one batch for each of `groups`
    /// samples that belong together, at most one band per row.
    pub fn filled(&self, groups: u32, rows: u32) -> Self {
        Self {
            batches: self.batches.min(groups).max(1),
            bands: self.bands.min(rows).max(1),
        }
    }

    /// The rows of a band.
    pub fn rows(&self, band: u32, rows: u32) -> Range<u32> {
        split(rows, self.bands, band)
    }

    /// The samples of a batch, of `spp` in groups that belong together.
    pub fn samples(&self, batch: u32, spp: u32, group: u32) -> Range<u32> {
        Self::part(spp, group, self.batches, batch)
    }

    /// The `i`-th of `parts` nearly equal ranges of samples, which does not cut groups.
    pub(crate) fn part(samples: u32, group: u32, parts: u32, i: u32) -> Range<u32> {
        let Range { start, end } = split(samples.div_ceil(group), parts, i);
        start * group..end.saturating_mul(group).min(samples)
    }

    /// All cells, batch by batch.
    pub fn cells(&self) -> impl Iterator<Item = Cell> + use<> {
        let Self { batches, bands } = *self;
        (0..batches).flat_map(move |batch| (0..bands).map(move |band| Cell { batch, band }))
    }

    fn has_no(&self, what: String) -> PartError {
        PartError::NotInGrid {
            what,
            batches: self.batches,
            bands: self.bands,
        }
    }

    fn index(&self, cell: Cell) -> usize {
        cell.batch as usize * self.bands as usize + cell.band as usize
    }
}

/// The `i`-th of `parts` nearly equal ranges.
fn split(total: u32, parts: u32, i: u32) -> Range<u32> {
    let bound = |i: u32| (u64::from(i) * u64::from(total) / u64::from(parts)) as u32;
    bound(i)..bound(i + 1)
}

/// The samples of one batch of the pixels of one band.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Which batch, from 0.
    pub batch: u32,
    /// Which band, from 0.
    pub band: u32,
}

/// Some cells of a [`Grid`], to be computed together. Parts that are to be merged must not
/// share a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    grid: Grid,
    /// For each cell, whether it is in the part.
    chosen: Vec<bool>,
}

impl Part {
    /// All cells.
    pub fn whole(grid: Grid) -> Self {
        Self::of(grid, |_| true)
    }

    /// The part number `index` of `count` nearly equal ones; some are empty if there are
    /// fewer cells than parts.
    pub fn nth(grid: Grid, index: u32, count: u32) -> Result<Self, PartError> {
        if index >= count {
            return Err(grid.has_no(format!("part {index} of {count}")));
        }
        let cells = u128::from(grid.batches) * u128::from(grid.bands);
        let bound = |i: u32| u128::from(i) * cells / u128::from(count);
        let range = bound(index)..bound(index + 1);
        Ok(Self::of(grid, |cell| {
            range.contains(&(grid.index(cell) as u128))
        }))
    }

    /// Some batches, of all pixels.
    pub fn batches(grid: Grid, batches: Range<u32>) -> Result<Self, PartError> {
        if batches.start > batches.end || batches.end > grid.batches {
            return Err(grid.has_no(format!("range of batches {batches:?}")));
        }
        Ok(Self::of(grid, |cell| batches.contains(&cell.batch)))
    }

    /// Some bands of pixels, with all of their samples.
    pub fn bands(grid: Grid, bands: Range<u32>) -> Result<Self, PartError> {
        if bands.start > bands.end || bands.end > grid.bands {
            return Err(grid.has_no(format!("range of bands {bands:?}")));
        }
        Ok(Self::of(grid, |cell| bands.contains(&cell.band)))
    }

    /// These cells, such as those that are still missing.
    pub fn cells(grid: Grid, cells: &[Cell]) -> Result<Self, PartError> {
        let whole = Self::whole(grid);
        if let Some(cell) = cells.iter().find(|&&cell| !whole.contains(cell)) {
            return Err(grid.has_no(format!("cell {cell:?}")));
        }
        Ok(Self::of(grid, |cell| cells.contains(&cell)))
    }

    /// An error if it is a part of other cells than these.
    pub fn check(&self, grid: Grid) -> Result<(), PartError> {
        match self.grid == grid {
            true => Ok(()),
            false => {
                let Grid { batches, bands } = self.grid;
                Err(grid.has_no(format!("part of {batches} batches and {bands} bands")))
            }
        }
    }

    fn of(grid: Grid, is_in: impl Fn(Cell) -> bool) -> Self {
        Self {
            grid,
            chosen: grid.cells().map(is_in).collect(),
        }
    }

    /// The cells that some of are in the part.
    pub fn grid(&self) -> Grid {
        self.grid
    }

    /// True if a cell is in the part.
    pub fn contains(&self, cell: Cell) -> bool {
        let is_in_grid = cell.batch < self.grid.batches && cell.band < self.grid.bands;
        is_in_grid && self.chosen[self.grid.index(cell)]
    }

    /// The bands of a batch that are in the part.
    pub fn bands_of(&self, batch: u32) -> Vec<u32> {
        let is_in = |&band: &u32| self.contains(Cell { batch, band });
        (0..self.grid.bands).filter(is_in).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// However the work is cut, each cell is in one part, and the cells cover all samples
    /// and rows.
    #[test]
    fn parts_cover_the_grid_once() {
        for (spp, group, rows) in [(1_u32, 1, 1), (5, 1, 3), (64, 1, 48), (100, 4, 7)] {
            let grid = Grid::DEFAULT.filled(spp.div_ceil(group), rows);
            let samples: Vec<u32> = (0..grid.batches)
                .flat_map(|batch| grid.samples(batch, spp, group))
                .collect();
            assert_eq!(samples, (0..spp).collect::<Vec<_>>());
            let all: Vec<u32> = (0..grid.bands).flat_map(|i| grid.rows(i, rows)).collect();
            assert_eq!(all, (0..rows).collect::<Vec<_>>());
            for count in [1, 2, 7, 40, 1000] {
                let parts: Vec<_> = (0..count)
                    .map(|i| Part::nth(grid, i, count).expect("a part"))
                    .collect();
                for cell in grid.cells() {
                    assert_eq!(parts.iter().filter(|part| part.contains(cell)).count(), 1);
                }
            }
            assert!(Part::nth(grid, 3, 3).is_err());
            assert!(Part::bands(grid, 0..grid.bands + 1).is_err());
            assert!(Part::batches(grid, 0..grid.batches + 1).is_err());
        }
    }
}
