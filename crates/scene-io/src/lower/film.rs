//! Film and reconstruction filter: `hdrfilm` with the filters of Mitsuba.

use capwalk_scene::{Film, Filter};

use super::lowering::Lowering;
use crate::fields::Fields;
use crate::node::{Kind, NodeId};
use crate::problem::Problem;

/// Mitsuba's size of a film that gives none.
const DEFAULT_SIZE: [u32; 2] = [768, 576];

/// Values of `type` of a `<film>`.
const FILMS: [&str; 1] = ["hdrfilm"];

/// Values of `type` of an `<rfilter>`.
const FILTERS: [&str; 6] = [
    "box",
    "tent",
    "gaussian",
    "mitchell",
    "catmullrom",
    "lanczos",
];

/// The filter of a film that gives none.
const DEFAULT_FILTER: Filter = Filter::Gaussian { stddev: 0.5 };

impl Lowering<'_> {
    pub(super) fn film(&mut self, node: Option<NodeId>) -> Result<Film, Problem> {
        let Some(node) = node else {
            let [width, height] = DEFAULT_SIZE;
            return Ok(Film::new(width, height, DEFAULT_FILTER));
        };
        let fields = Fields::new(self.context, node);
        if fields.node.plugin != "hdrfilm" {
            return Err(fields.unknown_plugin(&FILMS));
        }
        let size = [
            fields.count("width", 0, DEFAULT_SIZE[0])?,
            fields.count("height", 0, DEFAULT_SIZE[1])?,
        ];
        let film = Film {
            size,
            crop_offset: [
                fields.count("crop_offset_x", 0, 0)?,
                fields.count("crop_offset_y", 0, 0)?,
            ],
            crop_size: [
                fields.count("crop_width", 0, size[0])?,
                fields.count("crop_height", 0, size[1])?,
            ],
            filter: match fields.child(Kind::Filter)? {
                Some(child) => self.filter(child.node)?,
                None => DEFAULT_FILTER,
            },
            sample_border: fields.boolean("sample_border", false)?,
        };
        output_format(&fields)?;
        fields.finish()?;
        self.places.film = Some(match size {
            [0, _] => fields.span_of("width"),
            [_, 0] => fields.span_of("height"),
            _ => fields.node.span,
        });
        for name in ["crop_width", "crop_height"] {
            let span = fields.span_of(name);
            self.places.numbers.insert(format!("film.{name}"), span);
        }
        Ok(film)
    }

    fn filter(&mut self, node: NodeId) -> Result<Filter, Problem> {
        let fields = Fields::new(self.context, node);
        let filter = match fields.node.plugin.as_str() {
            "box" => Filter::Box,
            "tent" => Filter::Tent {
                radius: fields.float("radius", 1.0)?,
            },
            "gaussian" => Filter::Gaussian {
                stddev: fields.float("stddev", 0.5)?,
            },
            "mitchell" => Filter::Mitchell {
                b: fields.float("B", 1.0 / 3.0)?,
                c: fields.float("C", 1.0 / 3.0)?,
            },
            "catmullrom" => Filter::CATMULL_ROM,
            "lanczos" => Filter::Lanczos {
                lobes: fields.count("lobes", 1, 3)?,
            },
            _ => return Err(fields.unknown_plugin(&FILTERS)),
        };
        fields.finish()?;
        for name in ["radius", "stddev", "B", "C", "lobes"] {
            let span = fields.span_of(name);
            self.places.numbers.insert(format!("rfilter.{name}"), span);
        }
        Ok(filter)
    }
}

/// How Mitsuba would write the image. Ours are linear RGB in single
/// precision, and the ending of the output's name chooses the format.
fn output_format(fields: &Fields) -> Result<(), Problem> {
    let formats: [(&'static str, &[&str], &[&str]); 3] = [
        // Name, what Mitsuba knows, and what is what we write.
        (
            "file_format",
            &["openexr", "exr", "rgbe", "pfm"],
            &["openexr", "exr"],
        ),
        (
            "pixel_format",
            &["luminance", "luminance_alpha", "rgb", "rgba", "xyz", "xyza"],
            &["rgb"],
        ),
        (
            "component_format",
            &["float16", "float32", "uint32"],
            &["float32"],
        ),
    ];
    for (name, known, same) in formats {
        let Some(text) = fields.string(name)? else {
            continue;
        };
        let format = text.to_ascii_lowercase();
        if !known.contains(&format.as_str()) {
            return Err(Problem::unknown(
                fields.span_of(name),
                format!("\"{text}\" is not a {name} of Mitsuba's"),
            )
            .help(format!("expected one of {}", known.join(", "))));
        }
        if !same.contains(&format.as_str()) {
            let reason = "images are linear RGB in single precision, and the ending of the \
                          output's name chooses the file format";
            fields.cosmetic(&[name], reason);
        }
    }
    fields.cosmetic(&["banner"], "images have none");
    fields.cosmetic(
        &["compensate"],
        "it concerns the rounding of Mitsuba's sums",
    );
    // A property of Mitsuba 2 that changes the pixels at the border.
    fields.refuse(&["high_quality_edges"], "Mitsuba 3 calls it sample_border")?;
    Ok(())
}
