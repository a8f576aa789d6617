//! How many triangles the shapes of a file become, before they are made: what is too large for the
//! machine is refused while it is small.

use std::collections::BTreeMap;

use capwalk_math::Vec3;
use capwalk_scene::memory::{OF_EMITTING_TRIANGLE, available, mib};
use capwalk_scene::primitive::{CYLINDER_TRIANGLES, DISK_TRIANGLES, sphere_triangles};

use super::placed_surface::placement;
use super::sphere_division::SphereDivision;
use crate::fields::{Child, Context, Fields};
use crate::node::{Kind, NodeId};
use crate::problem::Problem;
use crate::texts::Span;

/// Kinds of shapes that an error names, those with the most triangles.
const NAMED: usize = 3;

/// Triangles of shapes, by their kinds.
#[derive(Default)]
pub(super) struct Triangles {
    /// How many shapes of a kind there are, and how many triangles these have.
    of_kinds: BTreeMap<String, [u64; 2]>,
    /// The triangles of all shapes that emit light.
    emitting: u64,
}

impl Triangles {
    /// The triangles of shapes without a file, and of instances of these: they are known before anything is
    /// made.
    pub fn known(context: &Context, shapes: &[Child], division: SphereDivision) -> Self {
        let mut triangles = Self::default();
        let mut of_groups = BTreeMap::new();
        for child in shapes {
            let count = known(context, child.node, division, &mut of_groups);
            let emitters = Fields::new(context, child.node).children(Kind::Emitter);
            let kind = &context.graph.node(child.node).plugin;
            triangles.add(kind, count, !emitters.is_empty());
        }
        triangles
    }

    /// Counts a shape of a kind.
    pub fn add(&mut self, kind: &str, triangles: u64, emits: bool) {
        if emits {
            self.emitting = self.emitting.saturating_add(triangles);
        }
        let [shapes, all] = self.of_kinds.entry(kind.to_owned()).or_default();
        *shapes += 1;
        *all = all.saturating_add(triangles);
    }

    /// An error at `span` if so many bytes for each, and what the sampling of emitters takes, with
    /// so much for those around the scene, need more memory than is free.
    pub fn refuse_beyond_memory(&self, bytes: u64, skies: u64, span: Span) -> Result<(), Problem> {
        let total = self
            .of_kinds
            .values()
            .fold(0, |sum: u64, [_, triangles]| sum.saturating_add(*triangles));
        let emitters = self.emitting.saturating_mul(OF_EMITTING_TRIANGLE);
        let emitters = emitters.saturating_add(skies);
        let needed = total.saturating_mul(bytes).saturating_add(emitters);
        let Some(free) = available().filter(|&free| needed > free) else {
            return Ok(());
        };
        let mut kinds: Vec<_> = self.of_kinds.iter().collect();
        kinds.sort_by_key(|(_, [_, triangles])| std::cmp::Reverse(*triangles));
        let named = kinds
            .into_iter()
            .take(NAMED)
            .map(|(kind, [shapes, triangles])| format!("{kind}: {triangles} in {shapes}"));
        let light = match emitters {
            0 => String::new(),
            emitters => format!(" ({} of them for emitters)", mib(emitters)),
        };
        let message = format!(
            "the shapes have {total} triangles, which need {} MiB of memory{light} to be rendered, \
             and {} MiB are free",
            mib(needed),
            mib(free)
        );
        Err(Problem::unsupported(span, message).help(format!(
            "leave shapes out, or take meshes of fewer triangles; most (triangles in shapes) are of {}",
            named.collect::<Vec<_>>().join(", ")
        )))
    }
}

/// The triangles of a shape that are known without reading a file.
fn known(
    context: &Context,
    node: NodeId,
    division: SphereDivision,
    of_groups: &mut BTreeMap<NodeId, u64>,
) -> u64 {
    let fields = Fields::new(context, node);
    match fields.node.plugin.as_str() {
        "rectangle" => 2,
        "cube" => 12,
        "disk" => DISK_TRIANGLES.into(),
        "cylinder" => CYLINDER_TRIANGLES.into(),
        "sphere" => sphere_triangles(division.at(radius(&fields))).into(),
        "instance" => {
            // What is no group is refused when it is lowered.
            let groups = fields.children(Kind::Shape).into_iter();
            let group = groups
                .map(|child| child.node)
                .find(|&group| context.graph.node(group).plugin == "shapegroup");
            let Some(group) = group else { return 0 };
            if let Some(&count) = of_groups.get(&group) {
                return count;
            }
            let shapes = Fields::new(context, group).children(Kind::Shape);
            let shapes = shapes.into_iter().map(|child| child.node);
            let is_single = |shape: &NodeId| context.graph.node(*shape).plugin != "instance";
            let count = shapes
                .filter(is_single)
                .map(|shape| known(context, shape, division, of_groups))
                .fold(0, u64::saturating_add);
            of_groups.insert(group, count);
            count
        }
        _ => 0,
    }
}

/// How the spheres of a scene are divided, with a warning if they are many. Those in groups count
/// once.
pub(super) fn sphere_division(context: &Context) -> SphereDivision {
    let nodes = (0..context.graph.nodes.len()).map(NodeId);
    let mut spheres = nodes
        .filter(|&node| {
            let node = context.graph.node(node);
            node.kind == Kind::Shape && node.plugin == "sphere"
        })
        .peekable();
    let Some(&first) = spheres.peek() else {
        return SphereDivision::FINEST;
    };
    let radii: Vec<f64> = spheres
        .map(|node| radius(&Fields::new(context, node)))
        .collect();
    let division = SphereDivision::of(&radii);
    if let Some(warning) = division.warning(&radii) {
        context.warn(context.graph.node(first).plugin_span, &warning);
    }
    division
}

/// The radius of a sphere in the world; 1 where it is wrong, which is refused when it is lowered.
pub(super) fn radius(fields: &Fields) -> f64 {
    let own = fields.float("radius", 1.0).unwrap_or(1.0).abs();
    let scale = placement(fields).map_or(1.0, |to_world| {
        to_world.vector(Vec3::new(1.0, 0.0, 0.0)).length()
    });
    own * scale
}

#[cfg(test)]
mod tests {
    use crate::load::load_scene_str;

    /// A scene of these shapes.
    fn error_of(shapes: &str) -> Option<String> {
        let text = format!(
            "<scene version=\"3.0.0\"><integrator type=\"path\"/><sensor type=\"perspective\"/>\
             <emitter type=\"constant\"/>{shapes}</scene>"
        );
        let error = load_scene_str(&text, "".as_ref(), "scene.xml", &[]).err()?;
        Some(error.to_string())
    }

    /// Shapes of a hundred million triangles in a few hundred kilobytes are refused before they are
    /// made, with what they are; each alone is fine.
    #[test]
    fn many_triangles_are_refused_before_they_are_made() {
        if capwalk_scene::memory::available().is_none_or(|free| free > 1 << 40) {
            return; // a machine that has memory for all of them, or does not say
        }
        let shape = "<shape type=\"cylinder\"/>";
        assert_eq!(error_of(shape), None);
        // A terabyte and more: a group in many instances.
        let group = format!(
            "<shape type=\"shapegroup\" id=\"g\">{}</shape>",
            "<shape type=\"disk\"/>".repeat(2000)
        );
        let instances = "<shape type=\"instance\"><ref id=\"g\"/></shape>".repeat(10_000);
        let error = error_of(&(group + &instances)).expect("it needs a terabyte");
        assert!(error.contains("4480000000 triangles"), "{error}");
        assert!(error.contains("instance: 4480000000 in 10000"), "{error}");
    }
}
