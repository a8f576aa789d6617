//! Sums in fixed point, which are the same in every order: `sums.slang` adds them up.

use capwalk_boundary::{Accel, Boundaries};
use capwalk_diff::{Adjoint, Target, Wanted};
use capwalk_geometry::buffers::NONE;
use capwalk_math::Vec3;
use capwalk_scene::{Emitter, Gradient, Pattern, Scene};

use crate::layout::change::{BOUNDARIES_MOVE, IS_BLIND, MOTION_AT, TEXTURE_CHANGES, UNITS, WALKS};
use crate::layout::fault::{NOT_FINITE, SUMS, TOO_LARGE};
use crate::layout::sum::SUM_WORDS;
use crate::layout::sum_limit::LARGEST_DERIVATIVE;
use crate::texture_records::Shown;

/// Derivatives that are as large as expected have so many binary digits. Those with six more still
/// fit in a sum (`LARGEST_DERIVATIVE`).
const DIGITS: i32 = 80;

/// These digits if something moves: one over the distance of an edge may be large.
const DIGITS_IN_MOTION: i32 = 50;

/// The sensor's position, the images of its axes, and its other numbers.
const SENSOR_VECTORS: usize = 5;

/// If any is larger, units are larger by so many binary digits, and everything is done again.
const FEWER_DIGITS: i32 = 20;

/// The derivatives that are asked for.
#[derive(Debug)]
pub struct Sums<'a> {
    accel: &'a Accel,
    boundaries: &'a Boundaries,
    wanted: &'a Wanted,
    textures: Vec<TextureSums>,
    /// Where those with respect to points of the boundaries start, three for each, in local units; if
    /// anything moves.
    points: Option<usize>,
    /// The place of each shape's normals among the sums.
    normals: Vec<Option<usize>>,
    /// The place of the sensor's five vectors among the sums.
    sensor: Option<usize>,
    /// Local units in one of the world.
    inverse_scale: f64,
    /// How many sums there are.
    pub count: usize,
    /// A unit is two to minus this.
    digits: i32,
}

/// The sums of one record of a texture.
#[derive(Clone, Copy, Debug)]
struct TextureSums {
    shown: Shown,
    /// The first sum, if any is asked for.
    first: Option<usize>,
}

/// What a part of the work adds.
#[derive(Debug)]
pub struct PartSums {
    /// In units.
    pub sums: Vec<i128>,
    /// Derivatives that were left out because they are too large for a sum.
    pub too_large: u32,
    /// Derivatives that were left out because they are infinite or NaN.
    pub non_finite: u32,
}

impl PartSums {
    /// What the words of a device say.
    pub fn read(words: &[u32]) -> Self {
        let (counts, sums) = words.split_at(SUMS);
        let sums = sums.as_chunks::<SUM_WORDS>().0.iter();
        let sum = |words: &[u32; SUM_WORDS]| {
            let from_highest = words.iter().rev();
            from_highest.fold(0, |sum: u128, &word| sum << 32 | u128::from(word)) as i128
        };
        Self {
            sums: sums.map(sum).collect(),
            too_large: counts[TOO_LARGE],
            non_finite: counts[NOT_FINITE],
        }
    }
}

impl<'a> Sums<'a> {
    /// Those that are wanted, with these textures, of a loss whose derivatives with respect to pixels
    /// are near one at most. Units are chosen by what derivatives are expected: as large as that,
    /// times the brightest radiance if that is above one.
    pub fn new(
        accel: &'a Accel,
        boundaries: &'a Boundaries,
        shown: &[Shown],
        wanted: &'a Wanted,
        inverse_scale: f64,
    ) -> Self {
        let scene = &*accel.scene;
        let brightness: f64 = scene
            .emitters
            .iter()
            .map(|e| brightest(scene, e))
            .fold(0.0, f64::max);
        let mut count = 0;
        let mut place = |sums: usize| {
            count += sums;
            Some(count - sums)
        };
        let textures = shown.iter().map(|&shown| {
            let id = shown.numbers;
            let is_wanted = wanted.textures[id.0 as usize];
            let first = is_wanted.then(|| place(scene.texture(id).data.len()));
            TextureSums {
                shown,
                first: first.flatten(),
            }
        });
        let textures = textures.collect();
        let points = wanted.shapes.contains(&true);
        let points = points
            .then(|| place(3 * boundaries.point_count()))
            .flatten();
        let shapes = scene.shapes.iter().enumerate();
        let normals = shapes.map(|(i, shape)| {
            let normals = shape.normals.per_vertex()?;
            wanted
                .normals_of(scene, i)
                .then(|| place(3 * normals.len()))?
        });
        let normals = normals.collect();
        let sensor = wanted.sensor().then(|| place(3 * SENSOR_VECTORS)).flatten();
        // Units that single precision has, whatever is expected.
        let exponent = brightness.max(1.0).log2().ceil().clamp(0.0, 120.0);
        let digits = match wanted.moves() {
            true => DIGITS_IN_MOTION,
            false => DIGITS,
        };
        Self {
            accel,
            boundaries,
            wanted,
            textures,
            points,
            normals,
            sensor,
            inverse_scale,
            count,
            digits: digits - exponent as i32,
        }
    }

    /// The words of the sums on the device.
    pub fn words(&self) -> usize {
        SUMS + SUM_WORDS * self.count
    }

    /// What is asked for, as `changes.slang` reads it.
    pub fn changes(&self) -> Vec<u32> {
        let word = |first: Option<usize>| first.map_or(NONE, |first| first as u32);
        let moves = self.wanted.moves();
        let mut words = vec![NONE; TEXTURE_CHANGES];
        words[BOUNDARIES_MOVE] = self.wanted.geometry().into();
        words[UNITS] = 2_f32.powi(self.digits).to_bits();
        words[IS_BLIND] = 1;
        words[WALKS] = 0;
        words.extend(self.textures.iter().map(|texture| word(texture.first)));
        if moves {
            words[MOTION_AT] = words.len() as u32;
            for (shape, normals) in self.normals.iter().enumerate() {
                let first = 3 * self.accel.first_vertex[shape] as usize;
                let points = self.points.filter(|_| self.wanted.shapes[shape]);
                words.extend([word(points.map(|at| at + first)), word(*normals)]);
            }
        }
        words
    }

    /// Enlarges the unit for derivatives that were too large.
    pub fn widen(&mut self) {
        self.digits -= FEWER_DIGITS;
    }

    /// Where the sums of a point of the boundaries start, if there are any.
    pub fn of_point(&self, point: u32) -> Option<u32> {
        self.points.map(|first| first as u32 + 3 * point)
    }

    /// Adds a derivative with respect to a vector of the world to sums, to which the device adds others.
    /// One that is too large, or that single precision does not have, is counted instead.
    pub fn add(&self, to: &mut PartSums, target: Target, covector: Vec3) {
        let first = match target {
            Target::Point(point) => self.points.map(|first| first + 3 * point as usize),
            Target::Normal(shape, normal) => self.normals[shape].map(|at| at + 3 * normal as usize),
            Target::Texel(..) => None,
            Target::SensorOrigin => self.sensor,
            Target::SensorAxis(axis) => self.sensor.map(|first| first + 3 * (1 + axis)),
            Target::SensorOptics => self.sensor.map(|first| first + 3 * 4),
        };
        let Some(first) = first else {
            return;
        };
        let covector = match target {
            Target::Point(_) => covector / self.inverse_scale,
            _ => covector,
        };
        for (sum, derivative) in to.sums[first..].iter_mut().zip(covector.to_array()) {
            let units = (derivative * 2_f64.powi(self.digits)).round();
            let is_finite = derivative.abs() <= f64::from(f32::MAX); // false for NaN
            if !is_finite {
                to.non_finite += 1;
            } else if units.abs() > LARGEST_DERIVATIVE {
                to.too_large += 1;
            } else {
                *sum += units as i128;
            }
        }
    }

    /// The gradient that these sums are so many times.
    pub fn gradient(&self, sums: &[i128], times: f64) -> Gradient {
        let unit = 2_f64.powi(-self.digits) / times;
        let vector = |at: usize| Vec3::from([0, 1, 2].map(|axis| sums[at + axis] as f64 * unit));
        let scene = &*self.accel.scene;
        // Textures by numbers, not by texels.
        let no_texels = Wanted {
            textures: vec![false; scene.textures.len()],
            ..self.wanted.clone()
        };
        let mut adjoint = Adjoint::zero(scene, self.boundaries, &no_texels);
        if let Some(first) = self.points {
            for point in 0..self.boundaries.point_count() {
                let covector = vector(first + 3 * point) * self.inverse_scale;
                adjoint.add(Target::Point(point as u32), covector);
            }
        }
        for (shape, first) in self.normals.iter().enumerate() {
            let normals = scene.shapes[shape].normals.per_vertex();
            let (Some(first), Some(normals)) = (first, normals) else {
                continue;
            };
            for normal in 0..normals.len() {
                let target = Target::Normal(shape, normal as u32);
                adjoint.add(target, vector(first + 3 * normal));
            }
        }
        if let Some(first) = self.sensor {
            let axes = [0, 1, 2].map(Target::SensorAxis);
            let targets = [Target::SensorOrigin].into_iter().chain(axes);
            let targets = targets.chain([Target::SensorOptics]);
            for (i, target) in targets.enumerate() {
                adjoint.add(target, vector(first + 3 * i));
            }
        }
        let mut gradient = adjoint.gradient(self.accel, self.boundaries, &no_texels);
        let data = scene.textures.iter().zip(&self.wanted.textures);
        let data = data.map(|(texture, &wanted)| wanted.then(|| vec![0.0; texture.data.len()]));
        gradient.textures = data.collect();
        for texture in &self.textures {
            let id = texture.shown.numbers.0 as usize;
            let (Some(first), Some(numbers)) = (texture.first, &mut gradient.textures[id]) else {
                continue;
            };
            for (number, &sum) in numbers.iter_mut().zip(&sums[first..]) {
                *number += sum as f64 * (texture.shown.scale * unit);
            }
        }
        gradient
    }
}

/// The largest radiance of an emitter.
fn brightest(scene: &Scene, emitter: &Emitter) -> f64 {
    let shape = emitter.shape().map(|shape| scene.shape(shape));
    let radiance = emitter.radiance();
    let numbers = shape.map_or(radiance, |shape| scene.numbers_of(radiance, shape));
    let largest = |id| {
        let data: &[f64] = &scene.texture(id).data;
        data.iter().fold(0.0_f64, |most, x| most.max(x.abs()))
    };
    let scale = match &scene.texture(radiance).pattern {
        Pattern::MeshAttribute { scale, .. } => scale.abs(),
        _ => emitter.factor().map_or(1.0, largest),
    };
    largest(numbers) * scale
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Words of 128 bits, the lowest first, with their sign.
    #[test]
    fn sums_are_read_with_their_sign() {
        let minus_three = [u32::MAX - 2, u32::MAX, u32::MAX, u32::MAX];
        let large = [5, 0, 7, 0];
        let words = [&[4, 9, 0, 0][..], &minus_three, &large].concat();
        assert_eq!(words.len(), SUMS + 2 * SUM_WORDS);
        let read = PartSums::read(&words);
        assert_eq!(read.sums, [-3, (7 << 64) + 5]);
        assert_eq!((read.too_large, read.non_finite), (4, 9));
    }
}
