//! What reverse mode collects: a covector on everything that can move or
//! change, and the linear maps after the samples.

use std::sync::Arc;

use capwalk_boundary::{Accel, Boundaries, bends_images};
use capwalk_math::tape::Adjoints;
use capwalk_math::{Tape, Vec3};
use capwalk_render::Accumulate;
use capwalk_scene::{
    Emitter, EmitterVectors, Gradient, Optic, Quantity, Scene, SensorVectors, ShadingNormals,
    Shape, ShapeId, ShapeVectors, Tangent, TextureId, corner_normals, normal_sums,
};
use serde::{Deserialize, Serialize};

use crate::sparse_sums::SparseSums;

/// Which parameters' gradients are wanted: the others count as constants, and
/// cost nothing.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Wanted {
    /// The vertices of each shape, with the normals that are computed from them.
    pub shapes: Vec<bool>,
    /// The normals given with each shape; shapes without count as constant.
    pub normals: Vec<bool>,
    /// The data of each texture: the numbers of materials and emitters.
    pub textures: Vec<bool>,
    /// Where each emitter without extent is.
    pub emitters: Vec<bool>,
    /// The sensor's position.
    pub sensor_origin: bool,
    /// How the sensor is turned.
    pub sensor_axes: bool,
    /// The radius of the sensor's lens.
    pub aperture: bool,
    /// The sensor's other numbers, which move the film under the rays.
    pub film: bool,
}

impl Wanted {
    /// Everything.
    pub fn all(scene: &Scene) -> Self {
        Self {
            shapes: vec![true; scene.shapes.len()],
            normals: vec![true; scene.shapes.len()],
            textures: vec![true; scene.textures.len()],
            emitters: scene.emitters.iter().map(Emitter::is_delta).collect(),
            sensor_origin: true,
            sensor_axes: true,
            aperture: true,
            film: true,
        }
    }

    /// What changes in a motion.
    pub fn by(tangent: &Tangent) -> Self {
        let moves = |shape: &ShapeVectors| shape.vertices.iter().any(|&v| v != Vec3::zero());
        let turns = |shape: &ShapeVectors| shape.normals.is_some();
        let shapes = tangent.shapes.iter().map(Option::as_ref);
        let sensor = &tangent.sensor;
        let [left, up, forward] = sensor.axes;
        let turning = [sensor.rotation, left, up, forward];
        let optic = |optic: Optic| sensor.optics[optic as usize] != 0.0;
        Self {
            shapes: shapes.clone().map(|s| s.is_some_and(moves)).collect(),
            normals: shapes.map(|s| s.is_some_and(turns)).collect(),
            textures: tangent.textures.iter().map(Option::is_some).collect(),
            emitters: tangent
                .emitters
                .iter()
                .map(|moving| *moving != EmitterVectors::default())
                .collect(),
            sensor_origin: sensor.translation != Vec3::zero(),
            sensor_axes: turning.into_iter().any(|v| v != Vec3::zero()),
            aperture: optic(Optic::ApertureRadius),
            film: optic(Optic::FovX) || optic(Optic::FocusDistance),
        }
    }

    /// Also what another one wants.
    pub fn add(&mut self, other: &Self) {
        let add = |own: &mut [bool], others: &[bool]| {
            own.iter_mut()
                .zip(others)
                .for_each(|(own, other)| *own |= other);
        };
        add(&mut self.shapes, &other.shapes);
        add(&mut self.normals, &other.normals);
        add(&mut self.textures, &other.textures);
        add(&mut self.emitters, &other.emitters);
        self.sensor_origin |= other.sensor_origin;
        self.sensor_axes |= other.sensor_axes;
        self.aperture |= other.aperture;
        self.film |= other.film;
    }

    /// About how many numbers sums of covectors on all of it have.
    pub fn numbers(&self, scene: &Scene) -> u64 {
        let textures = scene.textures.iter().zip(&self.textures);
        let texels = textures.map(|(texture, &wanted)| match wanted {
            true => texture.data.len() as u64,
            false => 0,
        });
        let shapes = scene.shapes.iter();
        // A position and a normal of each vertex, whichever is wanted.
        let points = shapes.map(|shape| 6 * shape.mesh.positions.len() as u64);
        let points = if self.moves() { points.sum() } else { 0 };
        texels.sum::<u64>() + points
    }

    /// True if geometry, emitters or the camera's rays depend on something wanted.
    pub fn geometry(&self) -> bool {
        let rays_move = self.sensor_origin || self.sensor_axes || self.aperture;
        rays_move || self.shapes.contains(&true) || self.emitters.contains(&true)
    }

    /// True if something wanted moves what is seen, or turns specular directions.
    pub fn turns_light(&self, scene: &Scene) -> bool {
        let turns = |quantity: Quantity| {
            matches!(
                quantity,
                Quantity::RefractiveIndex { bends: true } | Quantity::Normal | Quantity::Height
            )
        };
        let shapes = scene.shapes.iter().enumerate();
        let mut bent = shapes.filter(|(_, shape)| bends_images(scene, shape));
        let by_material = |(i, shape): (usize, &Arc<Shape>)| {
            let slots = scene.slots_below(shape.bsdf);
            self.normals[i]
                || slots.iter().any(|slot| {
                    let numbers = scene.numbers_of(slot.texture, shape);
                    turns(slot.quantity) && self.textures[numbers.0 as usize]
                })
        };
        self.geometry() || bent.any(by_material)
    }

    /// True if anything of the sensor is wanted.
    pub fn sensor(&self) -> bool {
        self.sensor_origin || self.sensor_axes || self.aperture || self.film
    }

    /// True if anything may move that a boundary is seen from, lies on, or is projected by.
    pub fn moves(&self) -> bool {
        self.geometry() || self.film || self.normals.contains(&true)
    }

    /// For every point of the boundaries, whether it depends on a shape or a light that is
    /// wanted.
    pub fn points(&self, accel: &Accel, boundaries: &Boundaries) -> Vec<bool> {
        let vertices = 0..accel.mesh.positions.len() as u32;
        let mut points: Vec<bool> = vertices.map(|i| self.vertices(accel, i)).collect();
        let emitters = accel.scene.emitters.iter().zip(&self.emitters);
        points.extend(emitters.flat_map(|(emitter, &wanted)| {
            let anchors = emitter.anchors().len();
            std::iter::repeat_n(wanted, anchors)
        }));
        let ends = boundaries
            .crossings
            .iter()
            .flat_map(|crossing| &crossing.ends);
        let wanted: Vec<bool> = ends
            .map(|end| end.vertices().any(|i| points[i as usize]))
            .collect();
        points.extend(wanted);
        points
    }

    pub(crate) fn shape(&self, id: ShapeId) -> bool {
        self.shapes[id.0 as usize]
    }

    pub(crate) fn vertices(&self, accel: &Accel, vertex: u32) -> bool {
        self.shape(accel.shape_of_vertex(vertex))
    }

    /// True if the shading normals of a shape depend on something wanted.
    pub fn normals_of(&self, scene: &Scene, shape: usize) -> bool {
        match scene.shapes[shape].normals {
            ShadingNormals::Face => false,
            ShadingNormals::Given(_) => self.normals[shape],
            ShadingNormals::Computed(_) => self.shapes[shape],
        }
    }
}

/// What a covector is on: three numbers of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// A point of the boundaries: a vertex of the joined mesh, an anchor of a light, or
    /// the end of a crossing.
    Point(u32),
    /// The shading normal of a vertex of a shape.
    Normal(usize, u32),
    /// A texel of a texture; all three are on the one number of a grey.
    Texel(TextureId, usize),
    /// The sensor's position.
    SensorOrigin,
    /// The world-space image of an axis of the camera.
    SensorAxis(usize),
    /// The sensor's other numbers.
    SensorOptics,
}

/// Sums of covectors.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Adjoint {
    points: SparseSums<Vec3>,
    normals: Vec<Option<SparseSums<Vec3>>>,
    textures: Vec<SparseSums<f64>>,
    channels: Vec<usize>,
    sensor_origin: Vec3,
    sensor_axes: [Vec3; 3],
    sensor_optics: Vec3,
}

impl Adjoint {
    /// Zero.
    pub fn zero(scene: &Scene, boundaries: &Boundaries, wanted: &Wanted) -> Self {
        let normals = |normals: &ShadingNormals| {
            let count = normals.per_vertex()?.len();
            Some(SparseSums::zero(count))
        };
        Self {
            points: SparseSums::zero(boundaries.point_count()),
            normals: scene.shapes.iter().map(|s| normals(&s.normals)).collect(),
            textures: scene
                .textures
                .iter()
                .zip(&wanted.textures)
                .map(|(texture, &wanted)| if wanted { texture.data.len() } else { 0 })
                .map(SparseSums::zero)
                .collect(),
            channels: scene.textures.iter().map(|t| t.channels).collect(),
            sensor_origin: Vec3::zero(),
            sensor_axes: [Vec3::zero(); 3],
            sensor_optics: Vec3::zero(),
        }
    }

    /// Adds to a covector.
    #[inline]
    pub fn add(&mut self, target: Target, covector: Vec3) {
        match target {
            Target::Point(i) => self.points.add(i as usize, covector),
            Target::Normal(shape, vertex) => {
                let normals = self.normals[shape].as_mut();
                normals
                    .expect("a shape with normals")
                    .add(vertex as usize, covector);
            }
            Target::Texel(id, index) => {
                let data = &mut self.textures[id.0 as usize];
                match self.channels[id.0 as usize] {
                    1 => data.add(index, covector.x + covector.y + covector.z),
                    _ => data.add_each(3 * index, covector.to_array()),
                }
            }
            Target::SensorOrigin => self.sensor_origin += covector,
            Target::SensorAxis(i) => self.sensor_axes[i] += covector,
            Target::SensorOptics => self.sensor_optics += covector,
        }
    }

    /// Sums on the numbers of each texture that is wanted.
    #[cfg(test)]
    pub fn textures(self) -> Vec<Vec<f64>> {
        let textures = self.textures.into_iter();
        textures.map(SparseSums::into_list).collect()
    }

    /// Multiplies everything by a factor.
    pub fn scale(&mut self, factor: f64) {
        let normals = self.normals.iter_mut().flatten();
        let vectors = normals.chain([&mut self.points]);
        vectors.for_each(|sums| sums.scale(factor));
        self.textures.iter_mut().for_each(|sums| sums.scale(factor));
        let sensor = [&mut self.sensor_origin, &mut self.sensor_optics];
        let sensor = self.sensor_axes.iter_mut().chain(sensor);
        sensor.for_each(|v| *v = *v * factor);
    }

    /// The gradient: what is left are the maps that do not depend on samples, from
    /// vertices to the curves where faces cross and to computed normals.
    pub fn gradient(mut self, accel: &Accel, boundaries: &Boundaries, wanted: &Wanted) -> Gradient {
        let scene = &accel.scene;
        let vertex_count = accel.mesh.positions.len();
        let mut points = self.points.into_list();
        let (fixed, ends) = points.split_at_mut(vertex_count + accel.anchors.len());
        let crossings = boundaries.crossings.iter();
        for (end, &covector) in crossings.flat_map(|crossing| &crossing.ends).zip(&*ends) {
            end.pull_back(covector, fixed);
        }
        let (vertices, anchors) = fixed.split_at(vertex_count);
        let emitters = scene
            .pull_anchors(anchors)
            .into_iter()
            .zip(&wanted.emitters);
        let emitters = emitters.map(|(vectors, &wanted)| match wanted {
            true => vectors,
            // Boundaries of something else may have left something here.
            false => EmitterVectors::default(),
        });
        let emitters = emitters.collect();
        let mut shapes = Vec::new();
        for (i, shape) in scene.shapes.iter().enumerate() {
            let count = shape.mesh.positions.len();
            let first = accel.first_vertex[i] as usize;
            let mut on_vertices = match (wanted.shapes[i], wanted.normals_of(scene, i)) {
                (false, false) => {
                    shapes.push(None);
                    continue;
                }
                // Boundaries of other shapes may have left something here.
                (false, true) => vec![Vec3::zero(); count],
                (true, _) => vertices[first..first + count].to_vec(),
            };
            let on_normals = self.normals[i].take().map(SparseSums::into_list);
            let normals = match (&shape.normals, on_normals) {
                (ShadingNormals::Given(_), Some(on_normals)) if wanted.normals[i] => {
                    Some(on_normals)
                }
                (ShadingNormals::Computed(_), Some(on_normals)) => {
                    pull_computed_normals(&shape.mesh, &on_normals, &mut on_vertices);
                    None
                }
                _ => None,
            };
            shapes.push(Some(ShapeVectors {
                vertices: on_vertices,
                normals,
            }));
        }
        let textures = self
            .textures
            .into_iter()
            .zip(&wanted.textures)
            .map(|(sums, wanted)| wanted.then(|| sums.into_list()))
            .collect();
        let sensor = SensorVectors {
            translation: self.sensor_origin,
            rotation: turning(&scene.sensor.state().axes, &self.sensor_axes),
            axes: self.sensor_axes,
            optics: self.sensor_optics,
        };
        Gradient::new(shapes, textures, emitters, sensor)
    }
}

impl Accumulate for Adjoint {
    fn fits(&self, next: &Self) -> bool {
        let mut normals = self.normals.iter().zip(&next.normals);
        let mut textures = self.textures.iter().zip(&next.textures);
        self.points.fits(&next.points)
            && self.normals.len() == next.normals.len()
            && normals.all(|pair| match pair {
                (Some(own), Some(next)) => own.fits(next),
                (own, next) => own.is_none() && next.is_none(),
            })
            && self.textures.len() == next.textures.len()
            && textures.all(|(own, next)| own.fits(next))
            && self.channels == next.channels
    }

    fn add(&mut self, next: &Self) {
        self.points.add_all(&next.points);
        let normals = self.normals.iter_mut().flatten();
        for (own, next) in normals.zip(next.normals.iter().flatten()) {
            own.add_all(next);
        }
        for (own, next) in self.textures.iter_mut().zip(&next.textures) {
            own.add_all(next);
        }
        for (own, next) in self.sensor_axes.iter_mut().zip(&next.sensor_axes) {
            *own += *next;
        }
        self.sensor_origin += next.sensor_origin;
        self.sensor_optics += next.sensor_optics;
    }
}

/// The transpose of `ω -> ω × a` for each of the axes.
fn turning(axes: &[Vec3; 3], on_axes: &[Vec3; 3]) -> Vec3 {
    let pairs = axes.iter().zip(on_axes);
    pairs.fold(Vec3::zero(), |sum, (axis, &covector)| {
        sum + axis.cross(covector)
    })
}

/// The transpose of the derivative of [`capwalk_scene::vertex_normals`], face
/// by face: a normal is the direction of a sum over the faces around it.
fn pull_computed_normals(
    mesh: &capwalk_geometry::Mesh,
    on_normals: &[Vec3],
    on_vertices: &mut [Vec3],
) {
    let sums = normal_sums(&mesh.positions, &mesh.faces);
    // Covectors on the sums: of v / |v|, orthogonal to it.
    let on_sums: Vec<Vec3> = sums
        .into_iter()
        .zip(on_normals)
        .map(|(sum, &covector)| match sum.length() {
            0.0 => Vec3::zero(),
            length => covector.reject_from(sum / length) / length,
        })
        .collect();
    let mut tape = Tape::default();
    let mut adjoints = Adjoints::default();
    for (face, vertices) in mesh.faces.iter().enumerate() {
        if vertices
            .iter()
            .all(|&i| on_sums[i as usize] == Vec3::zero())
        {
            continue;
        }
        {
            let corners = mesh.corners(face).map(|p| tape.variables(p));
            if let Some(parts) = corner_normals(corners) {
                adjoints.reset(&tape);
                for (&i, part) in vertices.iter().zip(parts) {
                    adjoints.add_vector(part, on_sums[i as usize]);
                }
                tape.sweep(&mut adjoints, 0..tape.len());
                for (&i, corner) in vertices.iter().zip(corners) {
                    on_vertices[i as usize] += adjoints.of_vector(corner);
                }
            }
        }
        tape.clear();
    }
}
