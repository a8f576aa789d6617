//! Figures as files.

use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use capwalk_scene_io::image::{self, ImageError, LayeredImage, Panel, Preview};

use crate::curves;
use crate::figure::{Figure, Plot, Row, Shown, Table};
use crate::report;

/// Why figures could not be written.
#[derive(Debug)]
pub enum WriteError {
    /// A file or folder.
    File {
        /// Which.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
    /// An image.
    Image(ImageError),
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File { path, error } => write!(f, "cannot write {}: {error}", path.display()),
            Self::Image(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for WriteError {}

impl From<ImageError> for WriteError {
    fn from(error: ImageError) -> Self {
        Self::Image(error)
    }
}

/// Writes figures into a folder, which is created: for each figure a PNG and an
/// EXR file of every row of images, an SVG and a CSV file of every plot, a CSV
/// file of every table; `claims.csv`; and `report.html` with everything in it.
/// Returns what was written.
pub fn write(figures: &[Figure], folder: &Path) -> Result<Vec<PathBuf>, WriteError> {
    fs::create_dir_all(folder).map_err(|error| WriteError::File {
        path: folder.to_owned(),
        error,
    })?;
    let mut writer = Writer {
        folder,
        written: Vec::new(),
    };
    for figure in figures {
        for (i, row) in figure.rows.iter().enumerate() {
            match row {
                Row::Images(shown) => writer.images(figure, i, shown)?,
                Row::Plots(plots) => {
                    for plot in plots {
                        writer.plot(figure, plot)?;
                    }
                }
            }
        }
        for table in &figure.tables {
            writer.csv(figure, &table.title, &table_csv(table))?;
        }
    }
    writer.text("claims.csv", &claims_csv(figures))?;
    writer.text("report.html", &report::html(figures)?)?;
    Ok(writer.written)
}

struct Writer<'a> {
    folder: &'a Path,
    written: Vec<PathBuf>,
}

impl Writer<'_> {
    fn text(&mut self, name: &str, text: &str) -> Result<(), WriteError> {
        let path = self.folder.join(name);
        match fs::write(&path, text) {
            Ok(()) => self.written.push(path),
            Err(error) => return Err(WriteError::File { path, error }),
        }
        Ok(())
    }

    fn csv(&mut self, figure: &Figure, title: &str, text: &str) -> Result<(), WriteError> {
        self.text(&format!("{}-{}.csv", figure.name, slug(title)), text)
    }

    fn plot(&mut self, figure: &Figure, plot: &Plot) -> Result<(), WriteError> {
        self.csv(figure, &plot.title, &plot_csv(plot))?;
        let name = format!("{}-{}.svg", figure.name, slug(&plot.title));
        self.text(&name, &curves::svg(plot))
    }

    /// Side by side as PNG, and the numbers of those of the first one's size as
    /// EXR.
    fn images(&mut self, figure: &Figure, row: usize, shown: &[Shown]) -> Result<(), WriteError> {
        let panels: Vec<Panel> = shown
            .iter()
            .map(|shown| Panel {
                title: &shown.title,
                image: &shown.image,
                style: shown.style,
            })
            .collect();
        let stem = self.folder.join(format!("{}-row{}", figure.name, row + 1));
        let path = stem.with_extension("png");
        let metadata = [("figure".into(), figure.name.into())];
        image::write_panels(&path, &panels, &metadata)?;
        self.written.push(path);

        let mut layers = LayeredImage {
            metadata: metadata.into(),
            ..LayeredImage::default()
        };
        let size = |shown: &Shown| (shown.image.width, shown.image.height);
        for other in shown.iter().filter(|other| size(other) == size(&shown[0])) {
            layers.push(&slug(&other.title), other.image.clone());
        }
        let path = stem.with_extension("exr");
        image::write(&path, &layers, &Preview::default())?;
        self.written.push(path);
        Ok(())
    }
}

/// Letters and digits of a title, for a file's name.
fn slug(title: &str) -> String {
    let mut slug = String::new();
    for c in title.to_lowercase().chars() {
        match c.is_ascii_alphanumeric() {
            true => slug.push(c),
            false if !slug.ends_with('-') => slug.push('-'),
            false => {}
        }
    }
    slug.trim_matches('-').into()
}

fn table_csv(table: &Table) -> String {
    let columns: Vec<String> = table.columns.iter().map(|&c| c.into()).collect();
    let rows = table.rows.iter();
    rows.fold(csv_line(&columns), |text, row| text + &csv_line(row))
}

fn plot_csv(plot: &Plot) -> String {
    let [x, y] = plot.axes.clone();
    let mut text = csv_line(&["curve".into(), x, y, "standard error".into()]);
    for curve in &plot.curves {
        for [x, y, error] in &curve.points {
            let line = [
                curve.name.clone(),
                x.to_string(),
                y.to_string(),
                error.to_string(),
            ];
            text += &csv_line(&line);
        }
    }
    text
}

fn claims_csv(figures: &[Figure]) -> String {
    let mut text = csv_line(&["figure", "claim", "paper", "here", "verdict"].map(String::from));
    for figure in figures {
        for claim in &figure.claims {
            text += &csv_line(&[
                figure.name.into(),
                claim.statement.clone(),
                claim.paper.clone(),
                claim.ours.clone(),
                claim.verdict.to_string(),
            ]);
        }
    }
    text
}

/// A line of a CSV file (RFC 4180).
fn csv_line(cells: &[String]) -> String {
    let quoted = cells
        .iter()
        .map(|cell| match cell.contains(['"', ',', '\n', '\r']) {
            true => format!("\"{}\"", cell.replace('"', "\"\"")),
            false => cell.clone(),
        });
    quoted.collect::<Vec<_>>().join(",") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_cells_are_safe() {
        assert_eq!(slug("(b) Ours, M = 1: ∂v/∂x"), "b-ours-m-1-v-x");
        let line = csv_line(&["a,b".into(), "say \"x\"".into(), "1".into()]);
        assert_eq!(line, "\"a,b\",\"say \"\"x\"\"\",1\n");
    }
}
