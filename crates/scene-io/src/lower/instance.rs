//! Groups of shapes and their instances: copies of all shapes of a group, each with the
//! transform of the instance.

use std::rc::Rc;

use capwalk_scene::Shape;

use super::lowering::Lowering;
use super::placed_surface::placement;
use super::surface::copy;
use crate::fields::Fields;
use crate::node::{Kind, NodeId, PropertyValue};
use crate::problem::Problem;
use crate::texts::Span;

/// The most triangles that all instances of a scene have together, and the curves of a
/// file: with the trees of a rendering they take a few gigabytes.
pub(super) const MOST_TRIANGLES: usize = 1 << 24;

impl Lowering<'_> {
    /// A group, which by itself shows nothing.
    pub(super) fn shape_group(&mut self, node: NodeId) -> Result<(), Problem> {
        self.shapes_of_group(node)?;
        let is_of_group = |value: &PropertyValue| matches!(value, PropertyValue::Object { node: n, .. } if *n == node);
        let mut nodes = self.context.graph.nodes.iter();
        let has_instance = nodes.any(|other| {
            other.plugin == "instance" && other.properties.iter().any(|p| is_of_group(&p.value))
        });
        if !has_instance {
            let fields = Fields::new(self.context, node);
            fields.warn("no instance shows this group: it is not in the image");
        }
        Ok(())
    }

    /// Reads the shapes of a group, once.
    fn shapes_of_group(&mut self, node: NodeId) -> Result<(), Problem> {
        if self.groups.contains_key(&node) {
            return Ok(());
        }
        let fields = Fields::new(self.context, node);
        let mut shapes = Vec::new();
        for child in fields.children(Kind::Shape) {
            let shape = Fields::new(self.context, child.node);
            if ["shapegroup", "instance"].contains(&shape.node.plugin.as_str()) {
                let message = format!("{} stands in a group", shape.title());
                return Err(Problem::unsupported(child.span, message)
                    .help("expected shapes; groups stand in the scene, side by side"));
            }
            if let Some(emitter) = shape.child(Kind::Emitter)? {
                let message = format!("{} cannot have an emitter", shape.title());
                return Err(Problem::unsupported(emitter.span, message).help(
                    "shapes of groups emit no light, as in Mitsuba; put it outside of the group",
                ));
            }
            shapes.push(self.single_shape(&shape)?);
        }
        fields.finish()?;
        self.groups.insert(node, shapes.into());
        Ok(())
    }

    /// Adds a copy of each shape of a group.
    pub(super) fn instance(&mut self, fields: &Fields) -> Result<(), Problem> {
        let title = fields.title();
        let to_world = placement(fields)?;
        let Some(group) = fields.child(Kind::Shape)? else {
            let message = format!("{title} shows no group");
            return Err(Problem::missing(fields.node.span, message)
                .help("add <ref id=\"...\"/> with the id of a <shape type=\"shapegroup\">"));
        };
        if self.context.graph.node(group.node).plugin != "shapegroup" {
            let message = format!("{title} shows a shape that is not a group");
            return Err(Problem::invalid(group.span, message)
                .help("expected a <shape type=\"shapegroup\"> around the shape"));
        }
        fields.finish()?;
        self.shapes_of_group(group.node)?;
        let id = self.shape_name(fields.node.id.as_deref(), "instance");
        // The group's shapes are shared by its instances.
        let shapes = Rc::clone(&self.groups[&group.node]);
        self.count_triangles(&shapes, fields.node.span)?;
        if shapes.is_empty() {
            fields.warn("the group of this instance has no shapes: it is not in the image");
        }
        let is_single = shapes.len() == 1;
        for (shape, span) in shapes.iter() {
            // The only shape of a group is called by its instance.
            let id = match is_single {
                true => id.clone(),
                false => self.shape_ids.make_unique(&format!("{id}.{}", shape.id)),
            };
            self.add_shape(copy(shape, id, to_world), *span);
        }
        Ok(())
    }

    /// An error at `span` if with these copies there are too many triangles.
    fn count_triangles(&mut self, shapes: &[(Shape, Span)], span: Span) -> Result<(), Problem> {
        let triangles = |(shape, _): &(Shape, Span)| shape.mesh.faces.len();
        self.triangles_of_instances += shapes.iter().map(triangles).sum::<usize>();
        if self.triangles_of_instances <= MOST_TRIANGLES {
            return Ok(());
        }
        let count = self.triangles_of_instances;
        let message = format!("with this instance, all instances have {count} triangles");
        Err(Problem::unsupported(span, message).help(format!(
            "each instance is a copy; expected {MOST_TRIANGLES} triangles at most"
        )))
    }
}
