//! Shapes: where they are, which side is their front, what they are made of.
//!
//! In Mitsuba the shading normal decides which side of a surface is its front,
//! for materials and emitters alike. Our faces are wound to agree with it.

use capwalk_math::{Affine, Vec3};
use capwalk_scene::{Attribute, Pattern, ShadingNormals, Shape, Texture};

use super::curve::CURVES;
use super::lowering::Lowering;
use super::mesh_file::MESH_PLUGINS;
use super::placed_surface::{PlacedSurface, file_stem, placement};
use super::primitive_shape::primitive;
use super::surface::{Surface, agree};
use crate::fields::{Child, Fields};
use crate::mesh::{FileAttribute, MeshFile, direction};
use crate::node::Kind;
use crate::problem::Problem;
use crate::texts::Span;

/// Values of `type` that are read.
const SHAPES: [&str; 13] = [
    "obj",
    "ply",
    "serialized",
    "gltf",
    "rectangle",
    "cube",
    "disk",
    "cylinder",
    "sphere",
    "bsplinecurve",
    "linearcurve",
    "shapegroup",
    "instance",
];

/// Shapes that are not read, and what to do instead.
const REFUSED: [(&str, &str); 1] = [(
    "sdfgrid",
    "surfaces are triangles; extract a mesh where the distances are 0 (marching cubes), save it as \
     .ply, and write <shape type=\"ply\">",
)];

impl Lowering<'_> {
    /// Adds the shapes that an object of the scene stands for.
    pub(super) fn shape(&mut self, child: Child) -> Result<(), Problem> {
        let fields = Fields::new(self.context, child.node);
        if child.by_reference {
            return Err(Problem::invalid(child.span, "a shape is referred to").help(
                "each shape stands in the scene once; copy it, or show a shapegroup by instances",
            ));
        }
        match fields.node.plugin.as_str() {
            "shapegroup" => self.shape_group(child.node),
            "instance" => self.instance(&fields),
            _ => {
                let (shape, span) = self.single_shape(&fields)?;
                self.add_shape(shape, span);
                Ok(())
            }
        }
    }

    /// Adds a shape that stands at `span`.
    pub(super) fn add_shape(&mut self, shape: Shape, span: Span) {
        self.places.shapes.push(span);
        self.shapes.push(shape);
    }

    /// A shape, and where errors of its mesh are shown.
    pub(super) fn single_shape(&mut self, fields: &Fields) -> Result<(Shape, Span), Problem> {
        if fields.node.id.as_deref() == Some("sensor") {
            return Err(
                Problem::invalid(fields.node.span, "the id \"sensor\" is the sensor's")
                    .help("parameters are called by it; give the shape another id"),
            );
        }
        let to_world = placement(fields)?;
        let PlacedSurface {
            mut surface,
            world_from_object,
            attributes,
            stem,
        } = self.placed(fields, to_world)?;
        if !CURVES.contains(&fields.node.plugin.as_str())
            && fields.boolean("flip_normals", false)?
        {
            surface.flip();
        }
        let id = self.shape_name(fields.node.id.as_deref(), &stem);
        let emitter = fields.child(Kind::Emitter)?;
        let bsdf = match fields.child(Kind::Bsdf)? {
            Some(child) => self.bsdf(child.node, &format!("{id}.bsdf"))?,
            None => {
                let (emits, span) = (emitter.is_some(), fields.node.span);
                self.default_bsdf(&format!("{id}.bsdf"), emits, span)
            }
        };
        let emitter = match emitter {
            Some(child) => Some(self.area_emitter(child, &id)?),
            None => None,
        };
        fields.cosmetic(
            &["silhouette_sampling_weight"],
            "it tunes Mitsuba's own derivatives",
        );
        fields.finish()?;
        let attributes = self.attributes(&id, attributes, fields.span_of("filename"));
        let shape = Shape {
            id,
            mesh: surface.mesh,
            world_from_object,
            normals: surface.normals,
            bsdf,
            emitter,
            uvs: surface.uvs,
            attributes,
        };
        // That of the object, if no file is named.
        Ok((shape, fields.span_of("filename")))
    }

    /// The triangles of a shape in the world.
    fn placed(&self, fields: &Fields, to_world: Affine) -> Result<PlacedSurface, Problem> {
        let plugin = fields.node.plugin.as_str();
        if MESH_PLUGINS.contains(&plugin) {
            return self.placed_file(fields, to_world);
        }
        if CURVES.contains(&plugin) {
            return self.placed_curves(fields, to_world);
        }
        match primitive(fields, to_world, self.spheres)? {
            Some((surface, world_from_object)) => Ok(PlacedSurface {
                surface,
                world_from_object,
                attributes: Vec::new(),
                stem: plugin.to_owned(),
            }),
            None => Err(fields.refused_plugin(&SHAPES, &REFUSED)),
        }
    }

    /// The attributes of a shape as textures.
    fn attributes(
        &mut self,
        shape: &str,
        attributes: Vec<FileAttribute>,
        span: Span,
    ) -> Vec<Attribute> {
        let mut add = |attribute: FileAttribute| {
            if attribute.is_integer {
                let message = format!(
                    "the attribute \"{}\" has whole numbers; they are taken as they are, and \
                     colours are expected to be from 0 to 1",
                    attribute.name
                );
                self.context.warn(span, &message);
            }
            let pattern = match attribute.name.starts_with("face_") {
                true => Pattern::PerFace,
                false => Pattern::PerVertex,
            };
            let texture = Texture {
                id: format!("{shape}.{}", attribute.name),
                channels: attribute.channels,
                data: attribute.data,
                pattern,
            };
            Attribute {
                name: attribute.name,
                texture: self.add_texture(texture, span),
            }
        };
        attributes.into_iter().map(&mut add).collect()
    }

    /// The surface of a file in the world, its attributes, and a name for it.
    fn placed_file(&self, fields: &Fields, to_world: Affine) -> Result<PlacedSurface, Problem> {
        let flat = fields.boolean("face_normals", false)?;
        // Rows of bitmaps begin at v = 0; in OBJ files v points up.
        let flip_v = fields.boolean("flip_tex_coords", fields.node.plugin == "obj")?;
        let (file, path) = self.mesh_file(fields, !flat)?;
        let MeshFile {
            name,
            mut mesh,
            normals,
            uvs,
            attributes,
            ..
        } = file;
        let mut uvs = uvs.map(|uvs| {
            let of_vertex = |vertex: u32| {
                let [u, v] = uvs[vertex as usize];
                [u, if flip_v { 1.0 - v } else { v }]
            };
            let faces = mesh.faces.iter();
            faces.map(|corners| corners.map(of_vertex)).collect()
        });
        for position in &mut mesh.positions {
            *position = to_world.point(*position);
        }
        let normals = match normals {
            _ if flat => ShadingNormals::Face,
            // By glTF's own rule.
            None if fields.node.plugin == "gltf" => ShadingNormals::Face,
            None => ShadingNormals::computed(&mesh),
            Some(normals) => {
                let normals: Vec<Vec3> = normals
                    .into_iter()
                    .map(|n| direction(to_world.normal(n)))
                    .collect();
                agree(&mut mesh, &mut uvs, &normals);
                ShadingNormals::Given(normals)
            }
        };
        Ok(PlacedSurface {
            surface: Surface { mesh, normals, uvs },
            world_from_object: to_world,
            attributes,
            stem: name.unwrap_or_else(|| file_stem(&path, "mesh")),
        })
    }
}
