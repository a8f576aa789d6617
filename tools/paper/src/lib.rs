//! Reproduces the figures of the paper and tests its claims: each [`Figure`] has images, curves and
//! tables, measured when it is drawn, and for each [`Claim`] the paper's number, ours, and a
//! verdict by a statistical test.
//!
//! [`write()`] puts figures into a folder: PNG, EXR and CSV files, and one HTML page that needs no
//! other file. The crate also has what the paper compares with, walks ([`walk`]) and velocity
//! fields ([`fields`]), and its scene ([`bunny_shadow`]).
//!
//! ```no_run
//! use capwalk_paper::{ALL, Quality, Settings, write};
//! let figure = ALL[0].draw(&Settings::new(Quality::Draft))?;
//! write(&[figure], "report".as_ref())?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bunny;
pub mod bunny_shadow;
mod claim;
mod curves;
mod equal;
pub mod fields;
mod fig01;
mod fig03;
mod fig08;
mod fig09;
mod fig10;
mod fig11;
mod fig12;
mod figure;
mod gradients;
mod lattice;
mod output;
mod projective;
mod queries;
mod random;
mod reach;
mod report;
mod settings;
mod variance;
pub mod walk;

use std::time::Instant;

use cpu_time::ProcessTime;

pub use claim::{Claim, Measured, Verdict};
pub use figure::{Figure, Plot, Row, Scale, Shown, Table};
pub use output::{WriteError, write};
pub use settings::{Failure, Quality, Settings, Stages};

/// A figure that can be drawn.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Its name on the command line and in file names.
    pub name: &'static str,
    /// What it shows, in one line.
    pub title: &'static str,
    make: fn(&Settings) -> Result<Figure, Failure>,
}

/// All figures, in the order of the report.
pub const ALL: [Entry; 9] = [
    Entry {
        name: "fig01",
        title: "Figure 1: a shadow at equal samples",
        make: fig01::draw,
    },
    Entry {
        name: "fig03",
        title: "Figure 3: the toy in one dimension",
        make: fig03::draw,
    },
    Entry {
        name: "fig08",
        title: "Figure 8: derivatives of fields, flat and spherical",
        make: fig08::draw,
    },
    Entry {
        name: "fig09",
        title: "Figure 9: a box in a room",
        make: fig09::draw,
    },
    Entry {
        name: "fig10",
        title: "Figure 10: how many steps, at equal time",
        make: fig10::draw,
    },
    Entry {
        name: "fig11",
        title: "Figure 11: derivatives of shadows, plain and through a mirror",
        make: fig11::draw,
    },
    Entry {
        name: "fig12",
        title: "Figure 12: a shape from its shadow",
        make: fig12::draw,
    },
    Entry {
        name: "queries",
        title: "Section 7.2: cone queries and rays",
        make: queries::draw,
    },
    Entry {
        name: "variance",
        title: "Beyond the paper: the printed estimator and the anchored one",
        make: variance::draw,
    },
];

impl Entry {
    /// The figure, and how long it took.
    pub fn draw(&self, settings: &Settings) -> Result<Figure, Failure> {
        let (started, cpu) = (Instant::now(), ProcessTime::now());
        let mut figure = (self.make)(settings)?;
        figure.name = self.name;
        figure.title = self.title;
        figure.quality = settings.quality;
        figure.seconds = started.elapsed().as_secs_f64();
        figure.cpu_seconds = cpu.elapsed().as_secs_f64();
        Ok(figure)
    }
}
