//! Shapes without a file: their properties, and where they put them.

use capwalk_math::{Affine, Frame, Vec3};
use capwalk_scene::primitive;

use super::size::radius as world_radius;
use super::sphere_division::SphereDivision;
use super::surface::Surface;
use crate::fields::Fields;
use crate::problem::Problem;

/// How unequal the axes of a sphere may be scaled, relative: rounding of the
/// digits in scene files.
const UNIFORM_SCALE: f64 = 1e-4;

/// The primitive that a shape is, and what puts the coordinates that it is described in
/// into the world; or `None` if it is none.
pub(super) fn primitive(
    fields: &Fields,
    to_world: Affine,
    spheres: SphereDivision,
) -> Result<Option<(Surface, Affine)>, Problem> {
    Ok(Some(match fields.node.plugin.as_str() {
        "rectangle" => {
            // It is flat in any case.
            fields.boolean("face_normals", false)?;
            let mesh = primitive::rectangle(to_world);
            let uvs = primitive::rectangle_uvs(to_world);
            (Surface::new(mesh, uvs), to_world)
        }
        "cube" => {
            fields.boolean("face_normals", false)?;
            let mesh = primitive::cube(to_world);
            (Surface::new(mesh, primitive::cube_uvs(to_world)), to_world)
        }
        "disk" => {
            let mesh = primitive::disk(to_world);
            (Surface::new(mesh, primitive::disk_uvs(to_world)), to_world)
        }
        "cylinder" => cylinder(fields, to_world)?,
        "sphere" => sphere(fields, to_world, spheres)?,
        _ => return Ok(None),
    }))
}

/// A cylinder, and what puts the one around the z axis from 0 to 1 there.
fn cylinder(fields: &Fields, to_world: Affine) -> Result<(Surface, Affine), Problem> {
    let start = fields.point("p0")?.unwrap_or(Vec3::zero());
    let end = fields.point("p1")?.unwrap_or(Vec3::new(0.0, 0.0, 1.0));
    let radius = fields.float("radius", 1.0)?;
    if radius == 0.0 {
        let span = fields.span_of("radius");
        return Err(
            Problem::invalid(span, "\"radius\" is 0").help("expected a number other than 0")
        );
    }
    let along = end - start;
    let length = along.length();
    if length == 0.0 {
        let given = if fields.get("p1").is_some() {
            "p1"
        } else {
            "p0"
        };
        return Err(
            Problem::invalid(fields.span_of(given), "the cylinder ends where it begins")
                .help("expected two different points, \"p0\" and \"p1\""),
        );
    }
    let Frame { s, t, .. } = Frame::from_normal(along / length);
    let columns = [s * radius, t * radius, along];
    let unit = Affine {
        rows: [0, 1, 2].map(|row| Vec3::from(columns.map(|column| column[row]))),
        translation: start,
    };
    let world_from_unit = to_world * unit;
    let mesh = primitive::cylinder(world_from_unit);
    let uvs = primitive::cylinder_uvs(world_from_unit);
    Ok((Surface::new(mesh, uvs), world_from_unit))
}

/// A sphere, and what puts the unit sphere there. As in Mitsuba, a mirroring transform
/// turns a sphere inside out ([`primitive::sphere`] does it).
fn sphere(
    fields: &Fields,
    to_world: Affine,
    spheres: SphereDivision,
) -> Result<(Surface, Affine), Problem> {
    let centre = fields.point("center")?.unwrap_or(Vec3::zero());
    let radius = fields.float("radius", 1.0)?;
    if radius == 0.0 {
        let span = fields.span_of("radius");
        return Err(
            Problem::invalid(span, "\"radius\" is 0").help("expected a number other than 0")
        );
    }
    let [a, b, c] = to_world.rows;
    let columns = [0, 1, 2].map(|i| Vec3::new(a[i], b[i], c[i]));
    let scale = columns[0].length();
    let tolerance = UNIFORM_SCALE * scale;
    let is_uniform = (0..3).all(|i| {
        let (next, own) = (columns[(i + 1) % 3], columns[i]);
        (own.length() - scale).abs() <= tolerance && own.dot(next).abs() <= tolerance * scale
    });
    if !is_uniform {
        return Err(Problem::invalid(
            fields.span_of("to_world"),
            "\"to_world\" scales the axes of a sphere differently",
        )
        .help(
            "expected a uniform scale (Mitsuba ignores that of y and z); an ellipsoid can be given \
             as a mesh",
        ));
    }
    let division = spheres.at(world_radius(fields));
    let mesh = primitive::divided_sphere(to_world, centre, radius.abs(), division);
    let mut surface = Surface::new(mesh, primitive::divided_sphere_uvs(division));
    // A negative radius mirrors, too.
    if radius < 0.0 {
        surface.flip();
    }
    let unit = Affine::translate(centre) * Affine::scale(Vec3::splat(radius.abs()));
    Ok((surface, to_world * unit))
}
