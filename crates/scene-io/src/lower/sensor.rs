//! Sensors, with Mitsuba's fields of view.

use capwalk_math::{Affine, Vec3};
use capwalk_scene::{Sensor, SensorModel};

use super::lowering::Lowering;
use super::sampler::{self, Sampler};
use crate::fields::Fields;
use crate::node::{Kind, NodeId};
use crate::problem::Problem;
use crate::sensor_settings::SensorSettings;

/// Values of `type` that are read.
const SENSORS: [&str; 3] = ["perspective", "thinlens", "orthographic"];

/// Diagonal of the 35 mm film that focal lengths refer to, millimetres.
const FILM_DIAGONAL: f64 = 43.266615305567875;

/// How far `to_world` may be from a rotation, in the entries of `M Mᵀ`: Mitsuba's
/// limit. Files with three or four digits stay below it.
pub(super) const RIGID: f64 = 1e-3;

impl Lowering<'_> {
    /// The sensor, its film and its sampler. `unnamed` is its name if it has none.
    pub(super) fn sensor(
        &mut self,
        node: NodeId,
        unnamed: &str,
    ) -> Result<SensorSettings, Problem> {
        let fields = Fields::new(self.context, node);
        let plugin = fields.node.plugin.as_str();
        if !SENSORS.contains(&plugin) {
            return Err(fields.unknown_plugin(&SENSORS));
        }
        let film = self.film(fields.child(Kind::Film)?.map(|child| child.node))?;
        let sampler = match fields.child(Kind::Sampler)? {
            Some(child) => sampler::lower(&Fields::new(self.context, child.node))?,
            None => Sampler::default(),
        };
        let id = self.shape_name(fields.node.id.as_deref(), unnamed);
        let far_clip = fields.float("far_clip", 1e4)?;
        let model = match plugin {
            "perspective" => SensorModel::Perspective {
                fov_x: fov_x(&fields, film.size)?,
                principal_point_offset: [
                    fields.float("principal_point_offset_x", 0.0)?,
                    fields.float("principal_point_offset_y", 0.0)?,
                ],
            },
            "thinlens" => SensorModel::ThinLens {
                fov_x: fov_x(&fields, film.size)?,
                aperture_radius: aperture_radius(&fields)?,
                focus_distance: focus_distance(&fields, far_clip)?,
            },
            _ => SensorModel::Orthographic,
        };
        let sensor = Sensor {
            world_from_camera: match model {
                SensorModel::Orthographic => invertible(&fields)?,
                _ => rigid(&fields)?,
            },
            model,
            near_clip: fields.float("near_clip", 1e-2)?,
            far_clip,
            id,
        };
        if !model.has_lens() {
            let reason = "without a lens everything is in focus";
            fields.cosmetic(&["focus_distance"], reason);
        }
        let reason = "nothing moves while the shutter is open";
        fields.cosmetic(&["shutter_open", "shutter_close"], reason);
        fields.refuse(
            &["srf"],
            "light is computed in red, green and blue, without spectral response functions",
        )?;
        fields.finish()?;
        for (number, property) in [
            ("to_world", "to_world"),
            ("near_clip", "near_clip"),
            ("fov", "fov"),
            ("principal_point_offset", "principal_point_offset_x"),
            ("aperture_radius", "aperture_radius"),
            ("focus_distance", "focus_distance"),
        ] {
            let name = format!("{}.{number}", sensor.id);
            self.places.numbers.insert(name, fields.span_of(property));
        }
        if sensor.near_clip <= 0.0 || sensor.near_clip >= sensor.far_clip {
            let (near, far) = (sensor.near_clip, sensor.far_clip);
            return Err(Problem::invalid(
                fields.span_of("near_clip"),
                format!("\"near_clip\" is {near} and \"far_clip\" is {far}"),
            )
            .help("expected 0 < near_clip < far_clip"));
        }
        Ok(SensorSettings {
            sensor,
            film,
            sampler: sampler.kind,
            spp: sampler.spp,
            seed: sampler.seed,
        })
    }
}

/// `to_world`, freed from the rounding of its digits: the view keeps its
/// direction, up is made orthogonal to it.
fn rigid(fields: &Fields) -> Result<Affine, Problem> {
    let given = fields.transform("to_world")?;
    if !given.is_rigid(RIGID) {
        return Err(Problem::invalid(
            fields.span_of("to_world"),
            "the \"to_world\" of a sensor scales or shears",
        )
        .help("expected a rotation and a translation; fov sets how much is seen"));
    }
    let [a, b, c] = given.rows;
    let column = |i: usize| Vec3::new(a[i], b[i], c[i]);
    let forward = column(2).normalized();
    let up = column(1).reject_from(forward).normalized();
    // A mirroring sensor stays one.
    let left = up.cross(forward) * given.determinant().signum();
    Ok(Affine {
        rows: [0, 1, 2].map(|i| Vec3::new(left[i], up[i], forward[i])),
        translation: given.translation,
    })
}

/// `to_world` of a camera whose rays are parallel: it may scale, which sets how
/// much is seen.
fn invertible(fields: &Fields) -> Result<Affine, Problem> {
    let given = fields.transform("to_world")?;
    match given.inverse() {
        Some(_) => Ok(given),
        None => Err(Problem::invalid(
            fields.span_of("to_world"),
            "the \"to_world\" of a sensor cannot be inverted",
        )
        .help("scale by finite numbers other than 0")),
    }
}

fn aperture_radius(fields: &Fields) -> Result<f64, Problem> {
    let Some(radius) = fields.optional_float("aperture_radius")? else {
        let message = "a thin lens has no \"aperture_radius\"";
        return Err(Problem::missing(fields.node.span, message)
            .help("add it, in world units; a perspective sensor has none"));
    };
    if radius >= 0.0 {
        return Ok(radius);
    }
    let message = format!("\"aperture_radius\" is {radius}");
    Err(Problem::invalid(fields.span_of("aperture_radius"), message).help("expected 0 or more"))
}

fn focus_distance(fields: &Fields, far_clip: f64) -> Result<f64, Problem> {
    let distance = fields.float("focus_distance", far_clip)?;
    if distance > 0.0 {
        return Ok(distance);
    }
    let message = format!("\"focus_distance\" is {distance}");
    Err(Problem::invalid(fields.span_of("focus_distance"), message)
        .help("expected the depth that is sharp, above 0"))
}

/// The horizontal field of view of a film or an image with so many pixels, radians (`parse_fov` of
/// Mitsuba).
pub(super) fn fov_x(fields: &Fields, size: [u32; 2]) -> Result<f64, Problem> {
    let aspect = f64::from(size[0]) / f64::from(size[1]);
    let fov = fields.optional_float("fov")?;
    let focal_length = fields.string("focal_length")?;
    let axis = fields.string("fov_axis")?;
    let Some(degrees) = fov else {
        if axis.is_some() {
            let span = fields.span_of("fov_axis");
            return Err(
                Problem::invalid(span, "\"fov_axis\" is given without \"fov\"")
                    .help("focal lengths refer to the diagonal; remove it, or give fov"),
            );
        }
        let millimetres = focal_length_millimetres(fields, focal_length.unwrap_or("50mm"))?;
        let tan_half_diagonal = 0.5 * FILM_DIAGONAL / millimetres;
        return Ok(2.0 * half_width(tan_half_diagonal, aspect).atan());
    };
    if focal_length.is_some() {
        let span = fields.span_of("focal_length");
        return Err(
            Problem::invalid(span, "both \"fov\" and \"focal_length\" are given")
                .help("keep one of them"),
        );
    }
    let span = fields.span_of("fov");
    let limits = "expected an angle between 0 and 180 degrees";
    if !(degrees > 0.0 && degrees < 180.0) {
        return Err(Problem::invalid(span, format!("\"fov\" is {degrees}")).help(limits));
    }
    let tan_half = (0.5 * degrees.to_radians()).tan();
    let axis = axis.unwrap_or("x").to_ascii_lowercase();
    let tan_half_x = match (axis.as_str(), aspect > 1.0) {
        ("x", _) | ("smaller", false) | ("larger", true) => tan_half,
        ("y", _) | ("smaller", true) | ("larger", false) => tan_half * aspect,
        ("diagonal", _) => half_width(tan_half, aspect),
        _ => {
            let span = fields.span_of("fov_axis");
            return Err(
                Problem::invalid(span, format!("\"fov_axis\" is \"{axis}\""))
                    .help("expected x, y, diagonal, smaller or larger"),
            );
        }
    };
    Ok(2.0 * tan_half_x.atan())
}

/// Half the width of a film at distance 1 from half its diagonal.
fn half_width(half_diagonal: f64, aspect: f64) -> f64 {
    half_diagonal / (1.0 + 1.0 / (aspect * aspect)).sqrt()
}

fn focal_length_millimetres(fields: &Fields, text: &str) -> Result<f64, Problem> {
    let number = text.strip_suffix("mm").unwrap_or(text).trim();
    let millimetres: Option<f64> = number.parse().ok();
    let positive = millimetres.filter(|x| x.is_finite() && *x > 0.0);
    positive.ok_or_else(|| {
        Problem::invalid(
            fields.span_of("focal_length"),
            format!("\"focal_length\" is \"{text}\""),
        )
        .help("expected millimetres above 0, such as 50mm")
    })
}
