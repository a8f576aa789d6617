//! Figure 9: a box in a room moves along x. Ours against finite differences, and
//! against warped-area sampling at equal samples.

use crate::equal::{self, Comparison};
use crate::figure::Figure;
use crate::gradients::Subject;
use crate::reach;
use crate::settings::{Failure, Settings};

/// Half the distance of differences for an image 256 pixels wide: an eightieth of a
/// pixel. Over a tenth, sides of the box that run nearly along a column of pixels
/// leave it for the next, and differences are off by half of the discontinuity.
const STEP: f64 = 2e-4;

pub fn draw(settings: &Settings) -> Result<Figure, Failure> {
    let quality = settings.quality;
    let size = quality.choose([16, 12], [96, 72], [256, 192]);
    let spp = quality.choose([8, 16, 32], [256, 1024, 4096], [1024, 2048, 4096]);
    let subject = Subject::builtin("box-room", size, STEP * 256.0 / f64::from(size[0]))?;
    let comparison = Comparison {
        subject: &subject,
        place: "Figure 9",
        agreement: "“closely matches”",
        errors: None,
        spp,
    };
    Ok(Figure {
        caption: format!(
            "Derivative by the x-translation of the box, {} × {} pixels with a box filter, direct \
             light. Above, central differences over ±{:.2e} with {} samples per pixel on each side, \
             and the method `edges`, the reference of mean L1 errors; below, equal samples: our field \
             around the point, and on the triangle that is met, as in the paper; \
             baselines have 8 auxiliary rays for every direction. {}",
            size[0],
            size[1],
            subject.step,
            spp[2],
            reach::CAPTION
        ),
        ..equal::draw(&comparison, settings)?
    })
}
