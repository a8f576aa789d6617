//! Figure 1: the shadow of the Voronoi bunny at equal samples.

use crate::equal::{self, Comparison, Errors};
use crate::figure::Figure;
use crate::lattice;
use crate::reach;
use crate::settings::{Failure, Settings};

pub fn draw(settings: &Settings) -> Result<Figure, Failure> {
    let quality = settings.quality;
    let size = quality.choose([12, 9], [48, 36], [256, 192]);
    // The paper's figure 10 has 1000 samples of the same scene.
    let spp = quality.choose([8, 16, 32], [1024, 3072, 2048], [1024, 2048, 4096]);
    let subject = lattice::shadow(settings, size)?;
    let comparison = Comparison {
        subject: &subject,
        place: "Figure 1",
        agreement: "“converges closely”",
        errors: Some(Errors {
            ours: 0.032,
            was: 0.053,
            psdr_was: 0.069,
        }),
        spp,
    };
    Ok(Figure {
        caption: format!(
            "Derivative of the shadow of the {} by its y-translation, {} × {} pixels. Above, central differences over \
             ±{:.2e} with {} samples per pixel on each side, and the method `edges`, the reference \
             of mean L1 errors; below, equal samples: our field around the point \
             and on the triangle that is met, as in the paper; baselines have 8 auxiliary rays for \
             every direction. The scene's brightness is not the paper's, so ratios can be compared, \
             errors cannot. {}",
            lattice::name(settings),
            size[0],
            size[1],
            subject.step,
            spp[2],
            reach::CAPTION
        ),
        ..equal::draw(&comparison, settings)?
    })
}
