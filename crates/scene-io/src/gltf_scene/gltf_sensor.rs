//! Cameras: they look along -z, with +y up.

use capwalk_geometry::mesh::LARGEST_COORDINATE;
use capwalk_math::{Affine, Vec3};

use super::graph_builder::GraphBuilder;
use crate::mesh::{MeshFileError, direction, shown_name, unsupported};
use crate::node::{Kind, NodeId, PropertyValue};

/// Mitsuba's width of a film, pixels.
const WIDTH: f64 = 768.0;

/// Where parallel rays start that may start at the camera itself, over where they end: nothing is
/// nearer that is seen.
const NEAREST: f64 = 1e-9;

impl GraphBuilder<'_> {
    /// The camera with this index, which stands at a node.
    pub(super) fn sensor(
        &mut self,
        node: usize,
        camera: usize,
        to_scene: Affine,
    ) -> Result<NodeId, MeshFileError> {
        let (file, line) = (self.file, self.line_of_node(node));
        let root = file.document.as_json();
        let name = root.nodes[node].name.as_deref();
        let name = shown_name(name).or(shown_name(root.cameras[camera].name.as_deref()));
        let to_world = view(to_scene, node)?;
        let place = |key: &str| format!("cameras[{camera}].{key}");
        let (plugin, key) = match &root.cameras[camera] {
            given if given.perspective.is_some() => ("perspective", "perspective"),
            given if given.orthographic.is_some() => ("orthographic", "orthographic"),
            _ => {
                let help = "expected \"perspective\" or \"orthographic\"";
                return Err(unsupported(&place("type"), "the camera has no lens", help));
            }
        };
        let number = |name: &str, default| file.number(&place(&format!("{key}.{name}")), default);
        let sensor = self.add(Kind::Sensor, plugin, name, line);
        let (scale, aspect) = match plugin {
            "perspective" => {
                let fov = number("yfov", 0.0)?.to_degrees();
                self.set(sensor, "fov", PropertyValue::Float(fov));
                self.set(sensor, "fov_axis", PropertyValue::String("y".into()));
                (1.0, number("aspectRatio", 0.0)?)
            }
            _ => {
                let half_width = number("xmag", 0.0)?;
                (half_width, half_width / number("ymag", 0.0)?)
            }
        };
        let to_world = to_world * Affine::scale(Vec3::new(scale, scale, 1.0));
        self.set(sensor, "to_world", PropertyValue::Transform(to_world));
        // Without an end, it sees as far as there may be anything.
        let far = number("zfar", LARGEST_COORDINATE)?;
        // Parallel rays may start at the camera itself in glTF.
        let near = match number("znear", 0.0)? {
            0.0 => far * NEAREST,
            near => near,
        };
        self.set(sensor, "near_clip", PropertyValue::Float(near));
        self.set(sensor, "far_clip", PropertyValue::Float(far));
        if aspect > 0.0 {
            let film = self.add(Kind::Film, "hdrfilm", None, line);
            let height = (WIDTH / aspect).round().clamp(1.0, u32::MAX.into());
            self.set(film, "width", PropertyValue::Integer(WIDTH as i64));
            self.set(film, "height", PropertyValue::Integer(height as i64));
            self.put(sensor, film);
        }
        Ok(sensor)
    }
}

/// Where a camera or an emitter of a node stands and looks: a rotation and a translation. As glTF has
/// it, a scale of the node has no effect.
pub(super) fn view(to_scene: Affine, node: usize) -> Result<Affine, MeshFileError> {
    let forward = direction(to_scene.vector(Vec3::new(0.0, 0.0, -1.0)));
    let up = to_scene.vector(Vec3::new(0.0, 1.0, 0.0));
    let up = direction(up.reject_from(forward));
    // Mitsuba's cameras look along +z, with +x to the left.
    let left = up.cross(forward);
    if !left.is_finite() {
        let message = "its camera or its light looks nowhere: its transform cannot be inverted";
        let help = "scale by finite numbers other than 0";
        return Err(unsupported(&format!("nodes[{node}]"), message, help));
    }
    let rows = [
        Vec3::new(left.x, up.x, forward.x),
        Vec3::new(left.y, up.y, forward.y),
        Vec3::new(left.z, up.z, forward.z),
    ];
    Ok(Affine {
        rows,
        translation: to_scene.translation,
    })
}
