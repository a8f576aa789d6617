//! What `peers.py` found, as tables.
//!
//! Of Mitsuba's ways (guiding, samples) the cheapest counts whose derivative images are
//! unbiased as far as can be seen. Where no guiding gives such, the cheapest of all
//! counts, and is marked.

use serde_json::Value;

/// Mitsuba's guidings, as `peers.py` calls them.
const GUIDINGS: [&str; 3] = ["none", "grid", "octree"];
/// A relative bias that costs may have (they include its square): within this, or so
/// many of its standard errors.
const NO_BIAS: f64 = 0.05;
const SIGNIFICANT: f64 = 3.0;
/// Stands behind costs of biased estimates.
const BIASED: &str = " b";

/// All tables: derivative images, gradients, set-up, gradients of texels, images. Each has the
/// scenes in which it was measured.
pub fn all(results: &[Value], methods: &[&str]) -> String {
    let with = |part: &str| -> Vec<&Value> {
        let results = results.iter();
        results.filter(|result| !result[part].is_null()).collect()
    };
    let with_derivatives = with("forward");
    let parts = [
        (
            "derivative images, mean squared error × CPU seconds (b: biased with any guiding)",
            table(&with_derivatives, |result| {
                derivative_images(result, methods)
            }),
        ),
        (
            "relative bias of derivative images",
            table(&with_derivatives, |result| biases(result, methods)),
        ),
        (
            "gradients of a loss, mean squared error × CPU seconds: seven numbers of the \
             pose (geometric mean), all vertices (sum)",
            table(&with_derivatives, |result| gradients(result, methods)),
        ),
        (
            "set-up of derivative images, CPU seconds",
            table(&with_derivatives, set_up),
        ),
        (
            "gradients of a loss with respect to texels, squared error × CPU seconds, summed over \
             all entries, and relative bias",
            table(&with("texels"), texels),
        ),
        (
            "images, variance × CPU seconds",
            table(&with("image"), images),
        ),
    ];
    let parts = parts.into_iter().filter(|(_, lines)| !lines.is_empty());
    let texts = parts.map(|(title, lines)| format!("\n{title}\n{lines}"));
    texts.collect()
}

/// Cells of a line: heading and content.
type Cells = Vec<(String, String)>;

/// A line for each scene, under the headings of the first.
fn table(results: &[&Value], line: impl Fn(&Value) -> Cells) -> String {
    let lines: Vec<Cells> = results
        .iter()
        .map(|result| {
            let scene = result["scene"].as_str().unwrap_or_default();
            let mut cells = vec![("scene".to_owned(), scene.to_owned())];
            cells.extend(line(result));
            cells
        })
        .collect();
    let Some(first) = lines.first() else {
        return String::new();
    };
    let headings: Vec<&str> = first.iter().map(|(heading, _)| heading.as_str()).collect();
    let contents = lines
        .iter()
        .map(|cells| cells.iter().map(|(_, content)| content.as_str()).collect());
    let rows: Vec<Vec<&str>> = std::iter::once(headings).chain(contents).collect();
    aligned(&rows)
}

/// Rows of cells in columns: the first to the left, numbers to the right.
fn aligned(rows: &[Vec<&str>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let length = |column: usize| {
        let cells = rows.iter().filter_map(|row| row.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(length).collect();
    let mut text = String::new();
    for row in rows {
        let cells = row.iter().zip(&widths).enumerate();
        let cells = cells.map(|(i, (cell, width))| match i {
            0 => format!("{cell:width$}"),
            _ => format!("{cell:>width$}"),
        });
        text += cells.collect::<Vec<_>>().join("   ").trim_end();
        text.push('\n');
    }
    text
}

/// The rows of a part that one program made.
fn rows<'a>(part: &'a Value, program: &str) -> Vec<&'a Value> {
    let rows = part["rows"].as_array().map_or(&[][..], Vec::as_slice);
    rows.iter()
        .filter(|row| row["program"] == program)
        .collect()
}

/// capwalk's row by a method.
fn ours<'a>(part: &'a Value, method: &str) -> Option<&'a Value> {
    let rows = rows(part, "capwalk");
    rows.into_iter().find(|row| row["method"] == method)
}

/// The row with the smallest cost.
fn cheapest<'a>(rows: Vec<&'a Value>, cost: &str) -> Option<&'a Value> {
    let rows = rows.into_iter();
    rows.min_by(|a, b| number(a, cost).total_cmp(&number(b, cost)))
}

fn number(row: &Value, key: &str) -> f64 {
    row[key].as_f64().unwrap_or(f64::NAN)
}

/// Mitsuba's best row of a part.
struct Theirs<'a> {
    row: Option<&'a Value>,
    biased: bool,
}

impl<'a> Theirs<'a> {
    /// The best by this cost among the rows of a part; which guidings are biased is
    /// seen in derivative images.
    fn best(result: &'a Value, part: &str, cost: &str) -> Self {
        let faithful = |row: &&Value| {
            let guiding = row["guiding"].as_str().unwrap_or_default();
            longest(&result["forward"], guiding).is_some_and(is_faithful)
        };
        let rows = rows(&result[part], "mitsuba");
        let unbiased = rows.iter().copied().filter(faithful).collect();
        match cheapest(unbiased, cost) {
            Some(row) => Self {
                row: Some(row),
                biased: false,
            },
            None => Self {
                row: cheapest(rows, cost),
                biased: true,
            },
        }
    }

    fn guiding(&self) -> String {
        self.row.map_or("-".into(), |row| {
            let guiding = row["guiding"].as_str().unwrap_or_default();
            format!("{guiding}, {} spp", row["spp"])
        })
    }
}

/// Mitsuba's row with this guiding and most samples: it shows bias best.
fn longest<'a>(part: &'a Value, guiding: &str) -> Option<&'a Value> {
    let rows = rows(part, "mitsuba").into_iter();
    let of_guiding = rows.filter(|row| row["guiding"] == guiding);
    of_guiding.max_by(|a, b| number(a, "spp").total_cmp(&number(b, "spp")))
}

fn is_faithful(row: &Value) -> bool {
    let error = number(row, "bias_error");
    number(row, "bias").abs() <= NO_BIAS.max(SIGNIFICANT * error)
}

fn derivative_images(result: &Value, methods: &[&str]) -> Cells {
    let motion = &result["forward"]["motion"];
    let motion = motion.as_str().unwrap_or_default().to_owned();
    let mut cells = vec![("moves".to_owned(), motion)];
    cells.extend(costs(result, "forward", methods, "cost", ""));
    let theirs = Theirs::best(result, "forward", "cost");
    cells.push(("guiding".into(), theirs.guiding()));
    cells
}

fn gradients(result: &Value, methods: &[&str]) -> Cells {
    let mut cells = costs(result, "reverse", methods, "pose_cost", "pose, ");
    cells.extend(costs(
        result,
        "reverse",
        methods,
        "vertex_cost",
        "vertices, ",
    ));
    cells
}

/// The costs of our methods, that of Mitsuba's best, and its ratio to our best.
fn costs(result: &Value, part: &str, methods: &[&str], cost: &str, heading: &str) -> Cells {
    let of = |row: Option<&Value>| row.map_or(f64::NAN, |row| number(row, cost));
    let heading = |name: &str| format!("{heading}{name}");
    let own = &result[part];
    let mut cells: Cells = methods
        .iter()
        .map(|method| (heading(method), digits(of(ours(own, method)))))
        .collect();
    let best = of(cheapest(rows(own, "capwalk"), cost));
    let theirs = Theirs::best(result, part, cost);
    let mark = match theirs.biased && theirs.row.is_some() {
        true => BIASED,
        false => "",
    };
    let theirs = of(theirs.row);
    cells.push((heading("Mitsuba"), digits(theirs) + mark));
    cells.push(("ratio".into(), digits(theirs / best) + mark));
    cells
}

fn biases(result: &Value, methods: &[&str]) -> Cells {
    let part = &result["forward"];
    let mut cells: Cells = methods
        .iter()
        .map(|method| ((*method).to_owned(), bias(ours(part, method))))
        .collect();
    for name in GUIDINGS {
        cells.push((format!("Mitsuba, {name}"), bias(longest(part, name))));
    }
    cells
}

/// The relative bias of a row, with its standard error.
fn bias(row: Option<&Value>) -> String {
    match row {
        None => "-".into(),
        Some(row) => format!(
            "{:+.2} ± {:.2} %",
            100.0 * number(row, "bias"),
            100.0 * number(row, "bias_error")
        ),
    }
}

/// Mitsuba's cheapest number of samples counts; the bias is that of its largest.
fn texels(result: &Value) -> Cells {
    let part = &result["texels"];
    let of = |row: Option<&Value>| row.map_or(f64::NAN, |row| number(row, "cost"));
    let ours = cheapest(rows(part, "capwalk"), "cost");
    let theirs = cheapest(rows(part, "mitsuba"), "cost");
    let with_most = rows(part, "mitsuba").into_iter();
    let with_most = with_most.max_by(|a, b| number(a, "spp").total_cmp(&number(b, "spp")));
    let array = part["array"].as_str().unwrap_or_default();
    vec![
        ("array".into(), array.into()),
        ("entries".into(), part["entries"].to_string()),
        ("capwalk".into(), digits(of(ours))),
        ("prb".into(), digits(of(theirs))),
        ("ratio".into(), digits(of(theirs) / of(ours))),
        ("bias, capwalk".into(), bias(ours)),
        ("bias, prb".into(), bias(with_most)),
    ]
}

fn images(result: &Value) -> Cells {
    let part = &result["image"];
    let ours = cheapest(rows(part, "capwalk"), "cost").map_or(f64::NAN, |row| number(row, "cost"));
    let mut cells = vec![("capwalk".to_owned(), digits(ours))];
    for variant in ["scalar_rgb", "llvm_ad_rgb"] {
        let theirs = rows(part, "mitsuba").into_iter();
        let theirs = theirs.filter(|row| row["variant"] == variant).collect();
        let cost = cheapest(theirs, "cost").map_or(f64::NAN, |row| number(row, "cost"));
        cells.push((variant.into(), digits(cost)));
        cells.push(("ratio".into(), digits(cost / ours)));
    }
    // Seconds are minima, whose error is not known.
    let errors = ["capwalk", "mitsuba"].map(|program| {
        let row = rows(part, program).into_iter().next();
        row.map_or(f64::NAN, |row| number(row, "relative_error"))
    });
    let error = errors[0].hypot(errors[1]);
    cells.push(("error of variances".into(), percentage(error)));
    cells
}

fn set_up(result: &Value) -> Cells {
    let part = &result["forward"];
    let mut cells: Cells = rows(part, "capwalk")
        .iter()
        .map(|row| {
            let method = row["method"].as_str().unwrap_or_default();
            (method.to_owned(), digits(number(row, "set_up")))
        })
        .collect();
    let theirs = &result["mitsuba_set_up"];
    cells.push(("Mitsuba, loading".into(), digits(number(theirs, "loading"))));
    let first = Theirs::best(result, "forward", "cost").row;
    let first = first.map_or(f64::NAN, |row| number(row, "first_run"));
    cells.push(("first run".into(), digits(first)));
    for name in GUIDINGS {
        let seconds = number(&theirs["guiding"], name);
        cells.push((format!("guiding {name}"), digits(seconds)));
    }
    cells
}

/// Three digits that count, powers of ten where there were many, a dash for what is
/// not there.
fn digits(x: f64) -> String {
    let magnitude = x.abs().log10().floor();
    match magnitude {
        _ if !x.is_finite() => "-".into(),
        _ if x == 0.0 => "0".into(),
        -3.0..4.0 => format!("{x:.*}", (2.0 - magnitude).max(0.0) as usize),
        _ => format!("{x:.2e}"),
    }
}

/// A percentage with one digit after the point, or a dash.
fn percentage(x: f64) -> String {
    match x.is_finite() {
        true => format!("{:.1} %", 100.0 * x),
        false => "-".into(),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn columns_are_aligned() {
        let text = aligned(&[vec!["scene", "cost"], vec!["a", "1"], vec!["bcd", "12345"]]);
        assert_eq!(text, "scene    cost\na           1\nbcd     12345\n");
    }

    #[test]
    fn digits_that_count() {
        assert_eq!(digits(0.012345), "0.0123");
        assert_eq!(digits(123.4), "123");
        assert_eq!(digits(1.234e-7), "1.23e-7");
        assert_eq!(digits(f64::NAN), "-");
    }

    fn contents(rows: Value) -> Vec<String> {
        let result = json!({ "scene": "s", "forward": { "motion": "m", "rows": rows } });
        let line = derivative_images(&result, &["walk", "edges"]);
        line.into_iter().map(|(_, content)| content).collect()
    }

    fn theirs(guiding: &str, spp: u32, cost: f64, bias: f64) -> Value {
        json!({
            "program": "mitsuba", "guiding": guiding, "spp": spp, "cost": cost,
            "bias": bias, "bias_error": 0.01,
        })
    }

    /// Mitsuba's best is compared with our best; a guiding that is seen to be biased at
    /// its largest number of samples does not count.
    #[test]
    fn the_best_of_each_is_compared() {
        let walk = json!({ "program": "capwalk", "method": "walk", "cost": 2.0 });
        let edges = json!({ "program": "capwalk", "method": "edges", "cost": 0.5 });
        let biased = theirs("octree", 8, 1.0, -0.3);
        let found = contents(json!([
            walk,
            edges,
            theirs("none", 4, 9.0, 0.04),
            theirs("grid", 8, 3.0, 0.01),
            theirs("octree", 4, 0.1, 0.0),
            biased,
        ]));
        assert_eq!(found, ["m", "2.00", "0.500", "3.00", "6.00", "grid, 8 spp"]);
        let found = contents(json!([walk, edges, biased]));
        assert_eq!(
            found,
            ["m", "2.00", "0.500", "1.00 b", "2.00 b", "octree, 8 spp"]
        );
    }

    /// Mitsuba's cost is that of its cheapest row, its bias that of its largest number of samples.
    #[test]
    fn gradients_of_texels_are_compared() {
        let theirs = |spp: u32, cost: f64, bias: f64| {
            json!({
                "program": "mitsuba", "spp": spp, "cost": cost, "bias": bias, "bias_error": 0.01,
            })
        };
        let ours = json!({ "program": "capwalk", "cost": 2.0, "bias": 0.0, "bias_error": 0.02 });
        let rows = json!([ours, theirs(8, 3.0, 0.2), theirs(64, 4.0, -0.1)]);
        let line = texels(&json!({ "texels": { "array": "a", "entries": 12, "rows": rows } }));
        let contents: Vec<&str> = line.iter().map(|(_, content)| content.as_str()).collect();
        let biases = ["+0.00 ± 2.00 %", "-10.00 ± 1.00 %"];
        assert_eq!(contents[..5], ["a", "12", "2.00", "3.00", "1.50"]);
        assert_eq!(contents[5..], biases);
    }

    /// Without LLVM there are no derivatives by Mitsuba, nor tables of them.
    #[test]
    fn tables_without_rows_are_left_out() {
        let rows = json!([{ "program": "capwalk", "method": "render", "cost": 2.0 }]);
        let text = all(&[json!({ "scene": "s", "image": { "rows": rows } })], &[]);
        let expected = "\nimages, variance × CPU seconds\n\
            scene   capwalk   scalar_rgb   ratio   llvm_ad_rgb   ratio   error of variances\n\
            s          2.00            -       -             -       -                    -\n";
        assert_eq!(text, expected);
    }
}
