//! Shapes: where they are, which side is their front, what they are made of.
//!
//! In Mitsuba the shading normal decides which side of a surface is its front,
//! for materials and lamps alike. Our faces are wound to agree with it.

use std::path::Path;

use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Vec3};
use capwalk_scene::primitive;
use capwalk_scene::{ShadingNormals, Shape};

use super::Lowering;
use crate::fields::{Child, Fields};
use crate::mesh::MeshFile;
use crate::node::Kind;
use crate::source::Problem;

/// The plugins.
const SHAPES: [&str; 6] = ["obj", "ply", "rectangle", "cube", "disk", "sphere"];

/// How unequal the axes of a sphere may be scaled, relative: rounding of the
/// digits in scene files.
const UNIFORM_SCALE: f64 = 1e-4;

impl Lowering<'_> {
    pub(super) fn shape(&mut self, child: Child) -> Result<(), Problem> {
        let fields = Fields::new(self.context, child.node);
        if child.by_reference {
            return Err(Problem::new(child.span, "a shape is referred to")
                .help("each shape stands in the scene once; copy it"));
        }
        if fields.node.id.as_deref() == Some("sensor") {
            return Err(
                Problem::new(fields.node.span, "the id \"sensor\" is the sensor's")
                    .help("parameters are called by it; give the shape another id"),
            );
        }
        let to_world = fields.transform("to_world")?;
        if to_world.determinant() == 0.0 || !to_world.determinant().is_finite() {
            return Err(Problem::new(
                fields.span_of("to_world"),
                "\"to_world\" cannot be inverted",
            )
            .help("scale by finite numbers other than 0"));
        }
        let plugin = fields.node.plugin.as_str();
        let mut stem = plugin.to_owned();
        let (mut mesh, mut normals, is_flipped) = match plugin {
            "obj" | "ply" => {
                let (mesh, normals, name) = self.placed_file(&fields, to_world)?;
                stem = name;
                (mesh, normals, fields.boolean("flip_normals", false)?)
            }
            "rectangle" | "cube" => {
                // They are flat in any case.
                fields.boolean("face_normals", false)?;
                let (mesh, normals) = match plugin {
                    "rectangle" => primitive::rectangle(to_world),
                    _ => primitive::cube(to_world),
                };
                (mesh, normals, fields.boolean("flip_normals", false)?)
            }
            "disk" => {
                let (mesh, normals) = primitive::disk(to_world);
                (mesh, normals, fields.boolean("flip_normals", false)?)
            }
            "sphere" => sphere(&fields, to_world)?,
            _ => return Err(fields.unknown_plugin(&SHAPES)),
        };
        if is_flipped {
            flip(&mut mesh, &mut normals);
        }
        let id = self.shape_name(fields.node.id.as_deref(), &stem);
        let emitter = fields.child(Kind::Emitter)?;
        let bsdf = match fields.child(Kind::Bsdf)? {
            Some(child) => self.bsdf(child.node, &format!("{id}.bsdf"))?,
            None => {
                let (is_lamp, span) = (emitter.is_some(), fields.node.span);
                self.default_bsdf(&format!("{id}.bsdf"), is_lamp, span)
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
            "obj" | "ply" => fields.span_of("filename"),
            _ => fields.node.span,
        });
        self.shapes.push(Shape {
            id,
            mesh,
            normals,
            bsdf,
            emitter,
        });
        Ok(())
    }

    /// The mesh of a file in the world, its normals, and a name for it.
    fn placed_file(
        &self,
        fields: &Fields,
        to_world: Affine,
    ) -> Result<(Mesh, ShadingNormals, String), Problem> {
        let flat = fields.boolean("face_normals", false)?;
        // Texture coordinates have no effect without textures.
        fields.boolean("flip_tex_coords", false)?;
        let (file, path) = self.mesh_file(fields, !flat)?;
        let MeshFile {
            mut mesh, normals, ..
        } = file;
        for position in &mut mesh.positions {
            *position = to_world.point(*position);
        }
        let normals = match normals {
            _ if flat => ShadingNormals::Face,
            None => ShadingNormals::computed(&mesh),
            Some(normals) => {
                let normals: Vec<Vec3> = normals
                    .into_iter()
                    .map(|n| to_world.normal(n).normalized())
                    .collect();
                agree(&mut mesh, &normals);
                ShadingNormals::Given(normals)
            }
        };
        let stem = path.file_stem().unwrap_or(Path::new("mesh").as_os_str());
        Ok((mesh, normals, stem.to_string_lossy().into_owned()))
    }
}

/// Winds each face so that its normal is on the side of its vertices' normals.
fn agree(mesh: &mut Mesh, normals: &[Vec3]) {
    for face in 0..mesh.faces.len() {
        let [a, b, c] = mesh.faces[face].map(|i| normals[i as usize]);
        if mesh.face_cross(face).dot(a + b + c) < 0.0 {
            mesh.faces[face].swap(1, 2);
        }
    }
}

/// Makes the back of a surface its front.
fn flip(mesh: &mut Mesh, normals: &mut ShadingNormals) {
    for face in &mut mesh.faces {
        face.swap(1, 2);
    }
    match normals {
        ShadingNormals::Face => {}
        ShadingNormals::Given(normals) | ShadingNormals::Computed(normals) => {
            for normal in normals {
                *normal = -*normal;
            }
        }
    }
}

/// A sphere, and whether its sides must be exchanged. As in Mitsuba, a mirroring
/// transform turns a sphere inside out ([`primitive::sphere`] does it).
fn sphere(fields: &Fields, to_world: Affine) -> Result<(Mesh, ShadingNormals, bool), Problem> {
    let centre = fields.point("center")?.unwrap_or(Vec3::zero());
    let radius = fields.float("radius", 1.0)?;
    if radius == 0.0 {
        let span = fields.span_of("radius");
        return Err(Problem::new(span, "\"radius\" is 0").help("expected a number other than 0"));
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
        return Err(Problem::new(
            fields.span_of("to_world"),
            "\"to_world\" scales the axes of a sphere differently",
        )
        .help(
            "expected a uniform scale (Mitsuba ignores that of y and z); an ellipsoid can be given \
             as a mesh",
        ));
    }
    let (mesh, normals) = primitive::sphere(to_world, centre, radius.abs());
    // A negative radius mirrors, too.
    let is_flipped = fields.boolean("flip_normals", false)? != (radius < 0.0);
    Ok((mesh, normals, is_flipped))
}
