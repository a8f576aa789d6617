//! Curves with a thickness: `bsplinecurve` and `linearcurve`.

use capwalk_math::Affine;
use capwalk_scene::primitive::{self, CurveKind, TubeError};

use super::instance::MOST_TRIANGLES;
use super::lowering::Lowering;
use super::placed_surface::{PlacedSurface, file_stem};
use super::surface::Surface;
use crate::fields::Fields;
use crate::mesh::read_curves;
use crate::problem::Problem;

/// The plugins that read files of curves.
pub(super) const CURVES: [&str; 2] = ["bsplinecurve", "linearcurve"];

impl Lowering<'_> {
    /// The tubes around the curves of a file. As in Mitsuba, `to_world` moves their control
    /// points and leaves their radii.
    pub(super) fn placed_curves(
        &self,
        fields: &Fields,
        to_world: Affine,
    ) -> Result<PlacedSurface, Problem> {
        let kind = match fields.node.plugin.as_str() {
            "linearcurve" => CurveKind::Linear,
            _ => CurveKind::BSpline,
        };
        let example = "add <string name=\"filename\" value=\"curves.txt\"/>";
        let (bytes, path, span) = self.file(fields, example)?;
        let shown = path.display().to_string();
        let curves = read_curves(&bytes, kind.least());
        let mut curves = curves.map_err(|error| Problem::mesh(span, &shown, error))?;
        for point in curves.iter_mut().flatten() {
            point.position = to_world.point(point.position);
        }
        let tubes = primitive::tubes(kind, &curves, MOST_TRIANGLES);
        let (mesh, normals, uvs) = tubes.map_err(|error| match error {
            TubeError::NoDirection { curve, point } => Problem::invalid(
                span,
                format!(
                    "curve {curve} of \"{shown}\" has no direction at its control point {point}, \
                     both counted from 0"
                ),
            )
            .help("expected control points at different places"),
            TubeError::TooMany { most } => Problem::unsupported(
                span,
                format!("the curves of \"{shown}\" have more than {most} triangles"),
            )
            .help("divide the file, or give the curves fewer control points"),
        })?;
        Ok(PlacedSurface {
            surface: Surface::new((mesh, normals), uvs),
            world_from_object: to_world,
            attributes: Vec::new(),
            stem: file_stem(&path, "curves"),
        })
    }
}
