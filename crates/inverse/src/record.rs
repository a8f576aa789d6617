//! What is written down of every iteration: a row of a table (CSV).

use capwalk_diff::Dips;

use crate::problem::Problem;
use crate::samples::Descent;
use crate::variable::Variables;

/// Variables with more numbers than this have no columns of their own.
const MOST_COLUMNS: usize = 4;

/// An iteration in numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Steps taken before.
    pub iteration: u32,
    /// The loss before the step.
    pub loss: f64,
    /// Its standard error.
    pub loss_error: f64,
    /// What noise added to it and was subtracted; `None` if that is not known.
    pub loss_noise: Option<f64>,
    /// Samples per pixel of images and of gradients.
    pub spp: [u32; 2],
    /// The loss of each view.
    pub by_view: Vec<f64>,
    /// Values before the step.
    pub values: Vec<f64>,
    /// What the step was; `None` if there was none.
    pub step: Option<Step>,
}

/// A step in numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Length of the gradient with respect to the unknowns.
    pub gradient: f64,
    /// The length that noise alone would have about: the root of the sum of the
    /// squared standard errors, of the gradient for the image as it was.
    pub gradient_noise: f64,
    /// How far the unknowns went.
    pub length: f64,
    /// The learning rate, after the schedule.
    pub lr: f64,
    /// How fast the loss falls along the step before; 0 in the first step.
    pub descent: Descent,
    /// Rays whose motion is missing in the gradient.
    pub dips: Dips,
}

/// The first line of the table, with its end.
pub fn header(problem: &Problem) -> String {
    let mut names: Vec<String> = [
        "iteration",
        "loss",
        "loss_stderr",
        "loss_noise",
        "gradient_norm",
        "gradient_noise",
        "step_norm",
        "lr",
        "descent",
        "descent_variance_by_image",
        "descent_variance_by_gradient",
        "spp",
        "spp_grad",
    ]
    .map(String::from)
    .to_vec();
    if problem.views.len() > 1 {
        names.extend((1..=problem.views.len()).map(|view| format!("loss of view {view}")));
    }
    names.extend(
        columns(&problem.variables)
            .into_iter()
            .map(|(name, _)| name),
    );
    line(names)
}

impl Row {
    /// The row, with its end: numbers with all digits that they need, nothing
    /// where there is none.
    pub fn csv(&self, problem: &Problem) -> String {
        let number = |x: f64| format!("{x:?}");
        let maybe = |x: Option<f64>| x.map(number).unwrap_or_default();
        let step = |of: fn(&Step) -> f64| maybe(self.step.as_ref().map(of));
        let mut cells = vec![
            self.iteration.to_string(),
            number(self.loss),
            number(self.loss_error),
            maybe(self.loss_noise),
            step(|step| step.gradient),
            step(|step| step.gradient_noise),
            step(|step| step.length),
            step(|step| step.lr),
            step(|step| step.descent.value),
            maybe(
                self.step
                    .map(|step| step.descent.by[0])
                    .filter(|by| !by.is_nan()),
            ),
            step(|step| step.descent.by[1]),
            self.spp[0].to_string(),
            self.spp[1].to_string(),
        ];
        if problem.views.len() > 1 {
            cells.extend(self.by_view.iter().map(|&loss| number(loss)));
        }
        let columns = columns(&problem.variables).into_iter();
        cells.extend(columns.map(|(_, place)| number(self.values[place])));
        line(cells)
    }
}

/// Values that have columns: their names and where they are.
fn columns(variables: &Variables) -> Vec<(String, usize)> {
    let mut columns = Vec::new();
    for (variable, range) in variables.iter() {
        let name = &variable.name;
        match range.len() {
            1 => columns.push((name.clone(), range.start)),
            count if count <= MOST_COLUMNS => {
                let each = range.enumerate();
                columns.extend(each.map(|(i, place)| (format!("{name}[{i}]"), place)));
            }
            _ => {}
        }
    }
    columns
}

/// Cells in a line, quoted where that is needed (RFC 4180, but for the end of the
/// line).
fn line(cells: Vec<String>) -> String {
    let quoted = cells
        .into_iter()
        .map(|cell| match cell.contains([',', '"', '\n', '\r']) {
            true => format!("\"{}\"", cell.replace('"', "\"\"")),
            false => cell,
        });
    quoted.collect::<Vec<_>>().join(",") + "\n"
}

/// The part of a table that belongs to the first `iterations`: the header and
/// their rows. What comes after is of a run that was stopped before its state was
/// kept. `None` if rows are missing, or if the table has another header.
pub fn kept<'a>(table: &'a str, header: &str, iterations: u32) -> Option<&'a str> {
    let rows = table.strip_prefix(header)?;
    let mut end = header.len();
    for (row, iteration) in rows.split_inclusive('\n').zip(0..iterations) {
        let number = row.strip_suffix('\n')?.split(',').next()?;
        if number != iteration.to_string() {
            return None;
        }
        end += row.len();
    }
    let found = table[header.len()..end].matches('\n').count();
    (found == iterations as usize).then_some(&table[..end])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_cut_to_the_state() {
        let table = "iteration,loss\n0,1.5\n1,1.0\n2,0.";
        let header = "iteration,loss\n";
        assert_eq!(kept(table, header, 0), Some(header));
        assert_eq!(kept(table, header, 1), Some("iteration,loss\n0,1.5\n"));
        assert_eq!(
            kept(table, header, 2),
            Some("iteration,loss\n0,1.5\n1,1.0\n")
        );
        assert_eq!(kept(table, header, 3), None, "the row is torn");
        assert_eq!(
            kept(&table[..table.len() - 4], header, 3),
            None,
            "it is missing"
        );
        assert_eq!(kept(table, "iteration\n", 1), None);
        assert_eq!(kept("iteration,loss\n7,1.5\n", header, 1), None);
    }

    #[test]
    fn cells_are_quoted_where_needed() {
        let cells = ["a", "b,c", "d\"e"].map(String::from).to_vec();
        assert_eq!(line(cells), "a,\"b,c\",\"d\"\"e\"\n");
    }
}
