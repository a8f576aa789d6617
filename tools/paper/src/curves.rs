//! Curves as SVG.

use plotters::coord::Shift;
use plotters::coord::ranged1d::ValueFormatter;
use plotters::prelude::*;

use crate::claim::digits;
use crate::figure::{Curve, Plot, Scale};

/// Size of a plot, CSS pixels.
const SIZE: (u32, u32) = (460, 320);

/// ColorBrewer's `Dark2` (Harrower and Brewer 2003).
const COLOURS: [RGBColor; 6] = [
    RGBColor(27, 158, 119),
    RGBColor(217, 95, 2),
    RGBColor(117, 112, 179),
    RGBColor(231, 41, 138),
    RGBColor(102, 166, 30),
    RGBColor(166, 118, 29),
];

/// The plot as an SVG element.
pub fn svg(plot: &Plot) -> String {
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        draw(plot, &area).expect("a string can always be written to");
    }
    text
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawing = Result<(), Box<dyn std::error::Error>>;

fn draw(plot: &Plot, area: &Area) -> Drawing {
    area.fill(&WHITE)?;
    let [across, up] = [0, 1].map(|axis| extent(plot, axis));
    let mut builder = ChartBuilder::on(area);
    builder
        .caption(&plot.title, ("sans-serif", 15))
        .margin(8)
        .x_label_area_size(36)
        .y_label_area_size(58);
    let [across, up] = [across, up].map(|(low, high)| low..high);
    match plot.scale {
        Scale::Linear => fill(plot, &mut builder.build_cartesian_2d(across, up)?),
        Scale::Semilogarithmic => fill(
            plot,
            &mut builder.build_cartesian_2d(across, up.log_scale())?,
        ),
        Scale::Logarithmic => {
            let axes = builder.build_cartesian_2d(across.log_scale(), up.log_scale());
            fill(plot, &mut axes?)
        }
    }
}

/// The points of a curve that the axes have.
fn drawn<'a>(plot: &Plot, curve: &'a Curve) -> impl Iterator<Item = &'a [f64; 3]> + Clone {
    let logarithmic = plot.scale.logarithmic();
    let is_on = move |point: &&[f64; 3]| (0..2).all(|axis| !logarithmic[axis] || point[axis] > 0.0);
    curve.points.iter().filter(is_on)
}

/// Axes, curves with bands of two standard errors, names.
fn fill<'a, 'b: 'a, X, Y>(plot: &Plot, chart: &mut Chart<'a, 'b, X, Y>) -> Drawing
where
    X: Ranged<ValueType = f64> + ValueFormatter<f64>,
    Y: Ranged<ValueType = f64> + ValueFormatter<f64>,
{
    let label = |x: &f64| digits_short(*x);
    chart
        .configure_mesh()
        .light_line_style(WHITE)
        .bold_line_style(RGBColor(225, 225, 225))
        .x_desc(&plot.axes[0])
        .y_desc(&plot.axes[1])
        .x_labels(6)
        .y_labels(6)
        .x_label_formatter(&label)
        .y_label_formatter(&label)
        .draw()?;
    let [_, up] = plot.scale.logarithmic();
    for (i, curve) in plot.curves.iter().enumerate() {
        let points = drawn(plot, curve);
        let colour = COLOURS[i % COLOURS.len()];
        let bars = points.clone().filter(|[_, _, error]| *error > 0.0);
        let bars = bars.map(|&[x, y, error]| {
            let least = match up {
                true => 0.1 * y,
                false => f64::NEG_INFINITY,
            };
            let ends = vec![(x, (y - 2.0 * error).max(least)), (x, y + 2.0 * error)];
            PathElement::new(ends, colour.mix(0.35))
        });
        chart.draw_series(bars)?;
        let line = points.map(|&[x, y, _]| (x, y));
        chart
            .draw_series(LineSeries::new(line, colour.stroke_width(2)))?
            .label(curve.name.clone())
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 16, y)], colour.stroke_width(2)));
    }
    if plot.curves.len() > 1 {
        chart
            .configure_series_labels()
            .position(match up {
                true => SeriesLabelPosition::UpperRight,
                false => SeriesLabelPosition::UpperLeft,
            })
            .background_style(WHITE.mix(0.8))
            .border_style(RGBColor(200, 200, 200))
            .draw()?;
    }
    Ok(())
}

type Chart<'a, 'b, X, Y> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<X, Y>>;

/// The range of an axis, with a margin.
fn extent(plot: &Plot, axis: usize) -> (f64, f64) {
    let points = plot.curves.iter().flat_map(|curve| drawn(plot, curve));
    let mut range = (f64::INFINITY, f64::NEG_INFINITY);
    for point in points.filter(|p| p[axis].is_finite()) {
        range = (range.0.min(point[axis]), range.1.max(point[axis]));
    }
    if range.0 > range.1 {
        return (1.0, 2.0);
    }
    match plot.scale.logarithmic()[axis] {
        true => (range.0 / 1.3, range.1 * 1.3),
        false => {
            let margin = 0.04 * (range.1 - range.0).max(1e-9);
            (range.0 - margin, range.1 + margin)
        }
    }
}

/// A number beside an axis.
fn digits_short(x: f64) -> String {
    if x.abs() < 1e-12 {
        return "0".into();
    }
    let text = digits(x);
    match text.contains('.') && !text.contains('e') {
        true => text.trim_end_matches('0').trim_end_matches('.').into(),
        false => text.replace(".00e", "e"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_become_lines_with_names() {
        let plot = |scale| Plot {
            title: "a & b".into(),
            axes: ["x".into(), "y".into()],
            scale,
            curves: vec![
                Curve {
                    name: "first".into(),
                    points: vec![[1.0, 2.0, 0.1], [2.0, 3.0, 0.0]],
                },
                Curve {
                    name: "second".into(),
                    points: vec![[1.0, 1.0, 0.0], [2.0, 1.5, 0.0], [3.0, -0.5, 0.0]],
                },
            ],
        };
        for (scale, points) in [
            (Scale::Linear, 3),
            (Scale::Semilogarithmic, 2),
            (Scale::Logarithmic, 2),
        ] {
            let svg = svg(&plot(scale));
            // The line of the second curve, in its colour.
            let line = svg.split("<polyline").find(|line| line.contains("#D95F02"));
            let line = line.and_then(|line| line.split("points=\"").nth(1));
            let line = line.and_then(|line| line.split('"').next()).unwrap_or("");
            assert_eq!(line.split_whitespace().count(), points, "{scale:?}: {line}");
            assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
            for part in ["first", "second", "a &amp; b", "<polyline"] {
                assert!(svg.contains(part), "{part} in {svg}");
            }
        }
    }
}
