//! Emitters: `area` inside shapes, `constant` around the scene.

use capwalk_scene::scene::{EmitterId, ShapeId};
use capwalk_scene::{Emitter, Quantity};

use super::Lowering;
use crate::fields::{Child, Fields};
use crate::source::{Problem, Span};

/// The plugins.
const EMITTERS: [&str; 2] = ["area", "constant"];

impl Lowering<'_> {
    /// The area emitter that stands in the shape that is added next.
    pub(super) fn area_emitter(
        &mut self,
        child: Child,
        shape_name: &str,
    ) -> Result<EmitterId, Problem> {
        let fields = Fields::new(self.context, child.node);
        match fields.node.plugin.as_str() {
            "area" => {}
            "constant" => {
                return Err(
                    Problem::new(child.span, "a constant emitter stands inside a shape")
                        .help("move it into <scene>, or write <emitter type=\"area\">"),
                );
            }
            _ => return Err(fields.unknown_plugin(&EMITTERS)),
        }
        if !self.attached.insert(child.node) {
            return Err(
                Problem::new(child.span, "this emitter belongs to another shape already")
                    .help("give each lamp an emitter of its own"),
            );
        }
        if let Some(transform) = fields.get("to_world") {
            return Err(
                Problem::new(transform.value_span, "an area emitter has no \"to_world\"")
                    .help("it stands where its shape stands; move the shape"),
            );
        }
        let holder = format!("{shape_name}.emitter");
        let radiance = self.slot(&fields, &holder, "radiance", Quantity::Radiance, 1.0)?;
        sampling_weight(&fields)?;
        fields.finish()?;
        let shape = ShapeId(self.shapes.len() as u32);
        Ok(self.add_emitter(Emitter::Area { shape, radiance }, child.span))
    }

    /// An emitter that stands in the scene.
    pub(super) fn scene_emitter(&mut self, child: Child) -> Result<(), Problem> {
        let fields = Fields::new(self.context, child.node);
        match fields.node.plugin.as_str() {
            "constant" => {}
            // Defined here, used in a shape by a <ref>.
            "area" if self.attached.contains(&child.node) => return Ok(()),
            "area" => {
                return Err(Problem::new(
                    child.span,
                    "an area emitter stands outside of any shape",
                )
                .help("move it into the <shape> that emits"));
            }
            _ => return Err(fields.unknown_plugin(&EMITTERS)),
        }
        let id = fields.node.id.clone();
        let id = id.unwrap_or_else(|| "environment".into());
        let radiance = self.slot(&fields, &id, "radiance", Quantity::Radiance, 1.0)?;
        sampling_weight(&fields)?;
        fields.finish()?;
        if !self.textures[radiance.0 as usize].is_constant() {
            let problem = Problem::new(
                fields.span_of("radiance"),
                "the radiance of a constant emitter is a texture",
            );
            return Err(problem.help("give one colour, or write <emitter type=\"envmap\">"));
        }
        self.add_emitter(Emitter::Constant { id, radiance }, child.span);
        Ok(())
    }

    fn add_emitter(&mut self, emitter: Emitter, span: Span) -> EmitterId {
        self.emitters.push(emitter);
        self.places.emitters.push(span);
        EmitterId(self.emitters.len() as u32 - 1)
    }
}

/// How often Mitsuba samples this emitter; the mean of the picture does not
/// depend on it unless it is zero.
fn sampling_weight(fields: &Fields) -> Result<(), Problem> {
    match fields.optional_float("sampling_weight")? {
        None => Ok(()),
        Some(weight) if weight > 0.0 => {
            if weight != 1.0 {
                let reason = "emitters are chosen by our own rule; the mean is the same";
                fields.cosmetic(&["sampling_weight"], reason);
            }
            Ok(())
        }
        Some(weight) => Err(Problem::new(
            fields.span_of("sampling_weight"),
            format!("\"sampling_weight\" is {weight}"),
        )
        .help("expected a number above 0; remove the emitter to switch it off")),
    }
}
