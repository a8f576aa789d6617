//! What a figure is: images, curves, tables and claims.

use capwalk_scene::Image;
use capwalk_scene_io::image::Style;

use crate::claim::Claim;
use crate::settings::Quality;

/// A figure, drawn.
#[derive(Clone, Debug, Default)]
pub struct Figure {
    /// Its name, the beginning of its files' names.
    pub name: &'static str,
    /// What it shows, in one line.
    pub title: &'static str,
    /// What was measured, and how.
    pub caption: String,
    /// Images and curves, laid out as in the paper.
    pub rows: Vec<Row>,
    /// Numbers.
    pub tables: Vec<Table>,
    /// What the paper claims, and what we find.
    pub claims: Vec<Claim>,
    /// How much work it was worth.
    pub quality: Quality,
    /// How long it took.
    pub seconds: f64,
    /// Seconds of the CPU, all threads together, without other programs that it starts.
    pub cpu_seconds: f64,
}

/// What stands side by side.
#[derive(Clone, Debug)]
pub enum Row {
    /// Images.
    Images(Vec<Shown>),
    /// Curves.
    Plots(Vec<Plot>),
}

/// An image with its title.
#[derive(Clone, Debug)]
pub struct Shown {
    /// What stands below it, for example "(a) ours".
    pub title: String,
    /// Its pixels.
    pub image: Image,
    /// How they are shown.
    pub style: Style,
}

/// Curves over one axis.
#[derive(Clone, Debug)]
pub struct Plot {
    /// What stands above it; also in its file's name.
    pub title: String,
    /// What the axes are, horizontal and vertical.
    pub axes: [String; 2],
    /// How its axes are divided.
    pub scale: Scale,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// How axes are divided. Points that a logarithmic axis does not have are among
/// the numbers of a plot, but not drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scale {
    /// Both evenly.
    #[default]
    Linear,
    /// The vertical axis logarithmically.
    Semilogarithmic,
    /// Both logarithmically.
    Logarithmic,
}

impl Scale {
    /// True if the axes are logarithmic, horizontal and vertical.
    pub(crate) fn logarithmic(self) -> [bool; 2] {
        [self == Self::Logarithmic, self != Self::Linear]
    }
}

/// One curve.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Its name.
    pub name: String,
    /// Points: across, up, standard error (0 if there is none).
    pub points: Vec<[f64; 3]>,
}

/// A table of numbers.
#[derive(Clone, Debug)]
pub struct Table {
    /// What stands above it; also in its file's name.
    pub title: String,
    /// Names of the columns.
    pub columns: Vec<&'static str>,
    /// The rows, as text.
    pub rows: Vec<Vec<String>>,
}
