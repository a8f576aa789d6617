//! Figure 1: the shadow of the Voronoi bunny at equal samples.

use capwalk_render::Method;

use crate::equal::{self, Comparison};
use crate::figure::Figure;
use crate::lattice;
use crate::settings::{Failure, Settings};

pub fn draw(settings: &Settings) -> Result<Figure, Failure> {
    let quality = settings.quality;
    let size = quality.choose([12, 9], [80, 60], [256, 192]);
    let spp = quality.choose([8, 16, 32], [32, 256, 1024], [64, 2048, 16_384]);
    let subject = lattice::shadow(settings, size)?;
    let comparison = Comparison {
        subject: &subject,
        place: "Figure 1",
        agreement: "“converges closely”",
        errors: &[0.032, 0.053, 0.069],
        spp,
        reference: Method::Edges,
    };
    Ok(Figure {
        caption: format!(
            "Derivative of {} by its y-translation, {} × {} pixels. Above, central differences over \
             ±{:.2e} with {} samples per pixel on each side, and ours; below, equal samples: our \
             field around the point (reaching 0.2 rad), and on the triangle that is met, as in the \
             paper. Mean L1 \
             errors are against the method `edges` with {} samples, whose agreement with differences \
             is tested, too: it has the least noise here. The scene's brightness is not the paper's, \
             so ratios can be compared, errors cannot.",
            lattice::name(settings),
            size[0],
            size[1],
            subject.step,
            spp[2],
            spp[1]
        ),
        ..equal::draw(&comparison, settings)?
    })
}
