//! All figures on one HTML page that needs no other file and no script.

use std::fmt::Write;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use capwalk_scene_io::image::{self, ImageError, Scale, Style};

use crate::claim::{Claim, Verdict, digits};
use crate::curves;
use crate::figure::{Figure, Row, Shown, Table};

const STYLE: &str = "\
body{font:15px/1.45 system-ui,sans-serif;max-width:1180px;margin:2em auto;padding:0 1em;color:#222}\
h1{font-size:1.6em}h2{margin-top:2.2em;border-bottom:1px solid #ccc}\
.row{display:grid;grid-template-columns:repeat(var(--columns),minmax(0,1fr));gap:14px;margin:1em 0}\
figure{margin:0;max-width:100%}figure svg,figure img.image{max-width:100%;height:auto}\
figcaption{text-align:center;font-size:.9em;color:#444;margin-top:3px}\
figure img.image{image-rendering:pixelated;border:1px solid #888;display:block;box-sizing:border-box}\
.bar{display:flex;align-items:center;gap:6px;justify-content:center;font-size:.8em;color:#555}\
.bar img{width:120px;min-width:0;flex-shrink:1;height:9px;border:1px solid #999}\
.scroll{overflow-x:auto}\
table{border-collapse:collapse;margin:1em 0;font-size:.92em}\
td,th{border:1px solid #ddd;padding:4px 9px;text-align:left;vertical-align:top}\
th{background:#f4f4f4}\
.holds{background:#e3f4e3}.not{background:#fbe0dd}.unsure{background:#fdf3d6}.other{background:#eee}\
.small{color:#666;font-size:.88em}";

/// The page.
pub fn html(figures: &[Figure]) -> Result<String, ImageError> {
    let mut page = String::new();
    page += "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n";
    page += "<title>capwalk: figures and claims</title>\n";
    let _ = writeln!(page, "<style>{STYLE}</style></head><body>");
    page += "<h1>Figures and claims, measured</h1>\n";
    page += "<p>The figures of <em>Unbiased Differential Visibility Using Fixed-Step \
             Walk-on-Spherical-Caps And Closest Silhouettes</em> (Wu et al. 2025), drawn anew by \
             capwalk. Every number in the column “here” was measured in the run that made this \
             page. Numbers are compared at three standard errors; images as <code>capwalk check</code> \
             does, where “holds” excludes that a derivative is off by 10 % or more.</p>\n";
    page += "<h2 id=\"claims\">Claims</h2>\n";
    page += &claims_table(figures.iter().flat_map(|figure| {
        let link = format!("<a href=\"#{0}\">{0}</a>", figure.name);
        figure
            .claims
            .iter()
            .map(move |claim| (Some(link.clone()), claim))
    }));
    for figure in figures {
        page += &section(figure)?;
    }
    let _ = writeln!(
        page,
        "<p class=\"small\">Made by <code>capwalk-paper figures</code>, version {}.</p>\n</body></html>",
        env!("CARGO_PKG_VERSION")
    );
    Ok(page)
}

fn section(figure: &Figure) -> Result<String, ImageError> {
    let mut text = format!(
        "<section id=\"{}\">\n<h2>{}</h2>\n<p>{}</p>\n",
        figure.name,
        escape(figure.title),
        prose(&figure.caption)
    );
    // Rows of images have the columns of the longest, so that all line up.
    let columns = figure.rows.iter().map(|row| match row {
        Row::Images(shown) => shown.len(),
        Row::Plots(_) => 1,
    });
    let columns = columns.max().unwrap_or(1).max(LEAST_COLUMNS);
    for row in &figure.rows {
        match row {
            Row::Images(shown) => {
                text += &begin_row(columns);
                for shown in shown {
                    text += &image(shown, columns)?;
                }
            }
            Row::Plots(plots) => {
                text += &begin_row(plots.len().max(2));
                for plot in plots {
                    let _ = writeln!(text, "<figure>{}</figure>", curves::svg(plot));
                }
            }
        }
        text += "</div>\n";
    }
    text += &claims_table(figure.claims.iter().map(|claim| (None, claim)));
    for shown in &figure.tables {
        text += &table(shown);
    }
    let _ = writeln!(
        text,
        "<p class=\"small\">Quality {}, {} s, {} CPU s.</p>\n</section>",
        figure.quality.name(),
        digits(figure.seconds),
        digits(figure.cpu_seconds)
    );
    Ok(text)
}

fn begin_row(columns: usize) -> String {
    format!("<div class=\"row\" style=\"--columns:{columns}\">\n")
}

/// A row of fewer images leaves space at its end.
const LEAST_COLUMNS: usize = 4;

/// Width of the page and of the gap between columns, pixels, as in [`STYLE`].
const WIDTH: usize = 1180;
const GAP: usize = 14;
/// Images below this width, pixels, are enlarged, if there is space.
const LEAST_WIDTH: usize = 240;

/// An image in one of so many columns. Its caption is no wider than the image.
fn image(shown: &Shown, columns: usize) -> Result<String, ImageError> {
    let width = shown.image.width.max(1);
    let space = (WIDTH + GAP) / columns - GAP;
    let zoom = LEAST_WIDTH.div_ceil(width).min(space / width).max(1);
    let source = data_uri(&image::pixels_as_png(&shown.image, shown.style)?);
    let mut text = format!(
        "<figure style=\"width:{0}px\"><img class=\"image\" width=\"{0}\" height=\"{1}\" alt=\"{2}\" \
         src=\"{source}\">",
        shown.image.width * zoom,
        shown.image.height * zoom,
        escape(&shown.title),
    );
    if let Style::Diverging(Scale { limit, .. }) = shown.style {
        let bar = data_uri(&image::colour_bar_as_png()?);
        let limit = digits(limit);
        let _ = write!(
            text,
            "<div class=\"bar\">−{limit}<img alt=\"colour bar\" src=\"{bar}\">{limit}</div>"
        );
    }
    let _ = writeln!(
        text,
        "<figcaption>{}</figcaption></figure>",
        prose(&shown.title)
    );
    Ok(text)
}

fn data_uri(png: &[u8]) -> String {
    format!("data:image/png;base64,{}", STANDARD.encode(png))
}

/// The first column is a link to a claim's figure, if there is one.
fn claims_table<'a>(claims: impl Iterator<Item = (Option<String>, &'a Claim)>) -> String {
    let mut rows = String::new();
    let mut linked = false;
    for (link, claim) in claims {
        let class = match claim.verdict {
            Verdict::Holds => "holds",
            Verdict::DoesNotHold(_) => "not",
            Verdict::Inconclusive(_) => "unsure",
            Verdict::NotComparable(_) => "other",
        };
        linked |= link.is_some();
        let first = link.map_or(String::new(), |link| format!("<td>{link}</td>"));
        let _ = writeln!(
            rows,
            "<tr>{first}<td>{}</td><td>{}</td><td>{}</td><td class=\"{class}\">{}</td></tr>",
            prose(&claim.statement),
            prose(&claim.paper),
            prose(&claim.ours),
            prose(&claim.verdict.to_string())
        );
    }
    if rows.is_empty() {
        return String::new();
    }
    let first = if linked { "<th>figure</th>" } else { "" };
    format!(
        "<div class=\"scroll\"><table><tr>{first}<th>claim</th><th>paper</th><th>here</th>\
         <th>verdict</th></tr>\n{rows}</table></div>\n"
    )
}

fn table(table: &Table) -> String {
    let cells = |tag: &str, cells: &mut dyn Iterator<Item = &str>| {
        let cells = cells.map(|cell| format!("<{tag}>{}</{tag}>", prose(cell)));
        format!("<tr>{}</tr>\n", cells.collect::<String>())
    };
    let head = cells("th", &mut table.columns.iter().copied());
    let rows = table.rows.iter();
    let rows: String = rows
        .map(|row| cells("td", &mut row.iter().map(String::as_str)))
        .collect();
    let title = escape(&table.title);
    format!("<div class=\"scroll\"><table><caption>{title}</caption>{head}{rows}</table></div>\n")
}

/// Text with what stands between backticks as code.
fn prose(text: &str) -> String {
    let mut html = String::new();
    let mut parts = escape(text);
    while let Some((before, (code, after))) = parts
        .split_once('`')
        .and_then(|(before, rest)| Some((before, rest.split_once('`')?)))
    {
        let _ = write!(html, "{before}<code>{code}</code>");
        parts = after.to_owned();
    }
    html + &parts
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_of_backticks_are_code() {
        assert_eq!(
            prose("by `a<b`, `c`"),
            "by <code>a&lt;b</code>, <code>c</code>"
        );
        assert_eq!(prose("`a` and ` alone"), "<code>a</code> and ` alone");
    }
}
