//! Shapes: where they are, which side is their front, what they are made of.
//!
//! In Mitsuba the shading normal decides which side of a surface is its front,
//! for materials and emitters alike. Our faces are wound to agree with it.

use std::path::Path;

use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Vec3};
use capwalk_scene::primitive::{self, FaceUvs};
use capwalk_scene::{Attribute, Pattern, ShadingNormals, Shape, Texture};

use super::lowering::Lowering;
use super::mesh_file::MESH_PLUGINS;
use crate::fields::{Child, Fields};
use crate::mesh::{FileAttribute, LARGEST_COORDINATE, MeshFile, direction};
use crate::node::Kind;
use crate::problem::Problem;
use crate::texts::Span;

/// Values of `type` that are read.
const SHAPES: [&str; 8] = [
    "obj",
    "ply",
    "serialized",
    "gltf",
    "rectangle",
    "cube",
    "disk",
    "sphere",
];

/// How unequal the axes of a sphere may be scaled, relative: rounding of the
/// digits in scene files.
const UNIFORM_SCALE: f64 = 1e-4;

impl Lowering<'_> {
    pub(super) fn shape(&mut self, child: Child) -> Result<(), Problem> {
        let fields = Fields::new(self.context, child.node);
        if child.by_reference {
            return Err(Problem::invalid(child.span, "a shape is referred to")
                .help("each shape stands in the scene once; copy it"));
        }
        if fields.node.id.as_deref() == Some("sensor") {
            return Err(
                Problem::invalid(fields.node.span, "the id \"sensor\" is the sensor's")
                    .help("parameters are called by it; give the shape another id"),
            );
        }
        let to_world = fields.transform("to_world")?;
        if to_world.determinant() == 0.0 || !to_world.determinant().is_finite() {
            return Err(Problem::invalid(
                fields.span_of("to_world"),
                "\"to_world\" cannot be inverted",
            )
            .help("scale by finite numbers other than 0"));
        }
        let rows = to_world.rows.iter().chain([&to_world.translation]);
        let mut numbers = rows.flat_map(|row| row.to_array());
        if numbers.any(|x| x.abs() > LARGEST_COORDINATE) {
            let span = fields.span_of("to_world");
            let help = format!("scale and translate by numbers up to {LARGEST_COORDINATE:e}");
            return Err(Problem::invalid(span, "\"to_world\" leads out of reach").help(help));
        }
        let plugin = fields.node.plugin.as_str();
        let mut stem = plugin.to_owned();
        let mut of_file = Vec::new();
        let mut world_from_object = to_world;
        let (mut surface, is_flipped) = match plugin {
            _ if MESH_PLUGINS.contains(&plugin) => {
                let (surface, attributes, name) = self.placed_file(&fields, to_world)?;
                stem = name;
                of_file = attributes;
                (surface, fields.boolean("flip_normals", false)?)
            }
            "rectangle" | "cube" => {
                // They are flat in any case.
                fields.boolean("face_normals", false)?;
                let (mesh, uvs) = match plugin {
                    "rectangle" => {
                        let mesh = primitive::rectangle(to_world);
                        (mesh, primitive::rectangle_uvs(to_world))
                    }
                    _ => (primitive::cube(to_world), primitive::cube_uvs(to_world)),
                };
                let flip = fields.boolean("flip_normals", false)?;
                (Surface::new(mesh, uvs), flip)
            }
            "disk" => {
                let mesh = primitive::disk(to_world);
                let flip = fields.boolean("flip_normals", false)?;
                (Surface::new(mesh, primitive::disk_uvs(to_world)), flip)
            }
            "sphere" => {
                let (surface, is_flipped, from_unit) = sphere(&fields, to_world)?;
                world_from_object = from_unit;
                (surface, is_flipped)
            }
            _ => return Err(fields.unknown_plugin(&SHAPES)),
        };
        if is_flipped {
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
        self.places.shapes.push(match plugin {
            _ if MESH_PLUGINS.contains(&plugin) => fields.span_of("filename"),
            _ => fields.node.span,
        });
        let attributes = self.attributes(&id, of_file, fields.span_of("filename"));
        self.shapes.push(Shape {
            id,
            mesh: surface.mesh,
            world_from_object,
            normals: surface.normals,
            bsdf,
            emitter,
            uvs: surface.uvs,
            attributes,
        });
        Ok(())
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
    fn placed_file(
        &self,
        fields: &Fields,
        to_world: Affine,
    ) -> Result<(Surface, Vec<FileAttribute>, String), Problem> {
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
        let name = name.unwrap_or_else(|| {
            let stem = path.file_stem().unwrap_or(Path::new("mesh").as_os_str());
            stem.to_string_lossy().into_owned()
        });
        let surface = Surface { mesh, normals, uvs };
        Ok((surface, attributes, name))
    }
}

/// A mesh with what goes around with its faces.
struct Surface {
    mesh: Mesh,
    normals: ShadingNormals,
    uvs: Option<FaceUvs>,
}

impl Surface {
    fn new((mesh, normals): (Mesh, ShadingNormals), uvs: FaceUvs) -> Self {
        Self {
            mesh,
            normals,
            uvs: Some(uvs),
        }
    }

    /// Makes the back of a surface its front.
    fn flip(&mut self) {
        for face in &mut self.mesh.faces {
            face.swap(1, 2);
        }
        for corners in self.uvs.iter_mut().flatten() {
            corners.swap(1, 2);
        }
        match &mut self.normals {
            ShadingNormals::Face => {}
            ShadingNormals::Given(normals) | ShadingNormals::Computed(normals) => {
                for normal in normals {
                    *normal = -*normal;
                }
            }
        }
    }
}

/// Winds each face so that its normal is on the side of its vertices' normals.
fn agree(mesh: &mut Mesh, uvs: &mut Option<FaceUvs>, normals: &[Vec3]) {
    for face in 0..mesh.faces.len() {
        let [a, b, c] = mesh.faces[face].map(|i| normals[i as usize]);
        if mesh.face_cross(face).dot(a + b + c) < 0.0 {
            mesh.faces[face].swap(1, 2);
            if let Some(uvs) = uvs {
                uvs[face].swap(1, 2);
            }
        }
    }
}

/// A sphere, and whether its sides must be exchanged. As in Mitsuba, a mirroring
/// transform turns a sphere inside out ([`primitive::sphere`] does it).
/// A sphere, whether its sides are swapped, and what puts the unit sphere there.
fn sphere(fields: &Fields, to_world: Affine) -> Result<(Surface, bool, Affine), Problem> {
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
    let mesh = primitive::sphere(to_world, centre, radius.abs());
    let surface = Surface::new(mesh, primitive::sphere_uvs());
    // A negative radius mirrors, too.
    let is_flipped = fields.boolean("flip_normals", false)? != (radius < 0.0);
    let unit = Affine::translate(centre) * Affine::scale(Vec3::splat(radius.abs()));
    Ok((surface, is_flipped, to_world * unit))
}
