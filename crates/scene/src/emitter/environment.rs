//! Images of all directions, as Mitsuba 3.9 maps them: the polar angle from
//! `+y` over the rows, from the first to the last; the azimuth over the columns,
//! whose centres are at `(i + 0.5) / width`, with `-z` at 0 and `+x` at 1/4.

use std::f64::consts::PI;

use capwalk_math::{Affine, Real, Rgb, Vec3};
use serde::{Deserialize, Serialize};

use crate::texture::Texture;

/// Where the texels of an environment map are.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EnvironmentMap {
    /// Texels per row; at least 1.
    pub width: u32,
    /// Rows; at least 2.
    pub height: u32,
    /// A rotation from the map's directions to the world's.
    pub world_from_map: Affine,
}

impl EnvironmentMap {
    /// The texels' mean at a unit direction of the world, bilinear. Continuous,
    /// also where the azimuth wraps around; at the poles only in value.
    pub fn lookup<R: Real>(
        &self,
        direction: Vec3<R>,
        mut texel: impl FnMut(usize) -> Rgb<R>,
    ) -> Rgb<R> {
        let [x, y] = self.place(direction);
        let (width, height) = (i64::from(self.width), i64::from(self.height));
        let mut at = |x: i64, y: i64| {
            let (x, y) = (x.rem_euclid(width), y.clamp(0, height - 1));
            texel((y * width + x) as usize)
        };
        let split = |x: R| {
            let below = x.value().floor();
            (below as i64, x - R::constant(below))
        };
        let ((x, s), (y, t)) = (split(x), split(y));
        let mut row = |y: i64| {
            let (left, right) = (at(x, y), at(x + 1, y));
            left + (right - left) * s
        };
        let (first, second) = (row(y), row(y + 1));
        first + (second - first) * t
    }

    /// Column and row of a direction, in texels; whole numbers are centres.
    fn place<R: Real>(&self, direction: Vec3<R>) -> [R; 2] {
        // The transpose of a rotation is its inverse.
        let [a, b, c] = self.world_from_map.rows.map(Vec3::constant);
        let d = a * direction.x + b * direction.y + c * direction.z;
        let azimuth = angle(d.x, -d.z);
        let sin = (d.x * d.x + d.z * d.z).sqrt();
        let polar = angle(sin, d.y);
        let (width, height) = (f64::from(self.width), f64::from(self.height));
        [
            azimuth * R::constant(0.5 / PI * width) - R::constant(0.5),
            polar * R::constant((height - 1.0) / PI),
        ]
    }

    /// The unit direction of the world at an azimuth and the cosine of a polar
    /// angle.
    fn direction(&self, azimuth: f64, cos: f64) -> Vec3 {
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        let (sin_azimuth, cos_azimuth) = azimuth.sin_cos();
        let local = Vec3::new(sin_azimuth * sin, cos, -cos_azimuth * sin);
        self.world_from_map.vector(local)
    }
}

/// `atan2(sin, cos)` with its derivative, which is zero where both are.
fn angle<R: Real>(sin: R, cos: R) -> R {
    let (s, c) = (sin.value(), cos.value());
    let squared = s * s + c * c;
    let value = R::constant(s.atan2(c));
    if squared == 0.0 {
        return value;
    }
    let change = (sin - R::constant(s)) * R::constant(c) - (cos - R::constant(c)) * R::constant(s);
    value + change * R::constant(1.0 / squared)
}

/// Directions drawn in proportion to the brightness of an environment map: the
/// sphere in cells between the centres of texels, each with the mean luminance
/// of its corners. Within a cell all directions are equally likely.
#[derive(Clone, Debug)]
pub struct EnvironmentTable {
    map: EnvironmentMap,
    /// Sums of the cells' chances up to each row, then within each row.
    rows: Vec<f64>,
    cells: Vec<f64>,
    /// Density per solid angle of each cell.
    densities: Vec<f64>,
}

impl EnvironmentTable {
    /// The table of a map with these texels, or `None` if it is black.
    pub fn new(map: &EnvironmentMap, texture: &Texture) -> Option<Self> {
        let (width, height) = (map.width as usize, map.height as usize);
        let luminance =
            |x: usize, y: usize| texture.texel(y * width + x % width).luminance().max(0.0);
        let count = width * (height - 1);
        let (mut densities, mut cells) = (Vec::with_capacity(count), Vec::with_capacity(count));
        let mut rows = Vec::new();
        let mut total = 0.0;
        for y in 0..height - 1 {
            let solid_angle = Self::solid_angle(map, y);
            let mut of_row = 0.0;
            for x in 0..width {
                let corners = [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)];
                let mean = corners.map(|(x, y)| luminance(x, y)).iter().sum::<f64>() / 4.0;
                densities.push(mean);
                of_row += mean * solid_angle;
                cells.push(of_row);
            }
            total += of_row;
            rows.push(total);
        }
        if !(total > 0.0 && total.is_finite()) {
            return None;
        }
        densities.iter_mut().for_each(|density| *density /= total);
        Some(Self {
            map: map.clone(),
            rows,
            cells,
            densities,
        })
    }

    /// Sums of the cells' chances up to each row of cells and with it, of which there is one less
    /// than of texels.
    pub fn row_sums(&self) -> &[f64] {
        &self.rows
    }

    /// Sums of the chances up to each cell of its row and with it, row by row.
    pub fn cell_sums(&self) -> &[f64] {
        &self.cells
    }

    /// Density per solid angle of each cell, row by row.
    pub fn densities(&self) -> &[f64] {
        &self.densities
    }

    /// Cosine of the polar angle at the top of a row of cells.
    fn cos_of_row(map: &EnvironmentMap, row: usize) -> f64 {
        (PI * row as f64 / f64::from(map.height - 1)).cos()
    }

    /// Solid angle of each cell of a row.
    fn solid_angle(map: &EnvironmentMap, row: usize) -> f64 {
        let height = Self::cos_of_row(map, row) - Self::cos_of_row(map, row + 1);
        2.0 * PI / f64::from(map.width) * height
    }

    /// A unit direction of the world, and its density per solid angle.
    pub fn sample(&self, u: [f64; 2]) -> (Vec3, f64) {
        let width = self.map.width as usize;
        // The first interval that ends beyond `u`, and the way through it. Cells
        // without light have length zero and are never chosen.
        let choose = |sums: &[f64], u: f64| {
            let target = u * sums[sums.len() - 1];
            let last = sums.partition_point(|&sum| sum < sums[sums.len() - 1]);
            let chosen = sums.partition_point(|&sum| sum <= target).min(last);
            let below = if chosen == 0 { 0.0 } else { sums[chosen - 1] };
            let through = (target - below) / (sums[chosen] - below);
            (chosen, through.clamp(0.0, 1.0))
        };
        let (row, down) = choose(&self.rows, u[1]);
        let (column, along) = choose(&self.cells[row * width..(row + 1) * width], u[0]);
        let azimuth = 2.0 * PI * (column as f64 + 0.5 + along) / width as f64;
        let top = Self::cos_of_row(&self.map, row);
        let bottom = Self::cos_of_row(&self.map, row + 1);
        let direction = self.map.direction(azimuth, top + (bottom - top) * down);
        (direction, self.densities[row * width + column])
    }

    /// Density per solid angle of [`EnvironmentTable::sample`] at a unit direction.
    pub fn pdf(&self, direction: Vec3) -> f64 {
        let [x, y] = self.map.place(direction);
        let (width, height) = (i64::from(self.map.width), i64::from(self.map.height));
        let column = (x.floor() as i64).rem_euclid(width);
        let row = (y.floor() as i64).clamp(0, height - 2);
        self.densities[(row * width + column) as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::Pattern;

    fn map() -> (EnvironmentMap, Texture) {
        // As in the script that Mitsuba's values come from.
        let data = [
            0.8, 0.1, 0.3, 0.2, 0.9, 0.4, 0.5, 0.0, 0.6, 0.7, 0.3, 0.2, //
            0.1, 0.2, 0.9, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.4, 0.8, 0.1, //
            0.3, 0.6, 0.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5, 0.1, 0.7,
        ];
        let texture = Texture {
            id: "sky".into(),
            channels: 3,
            data: data.to_vec(),
            pattern: Pattern::Environment,
        };
        let map = EnvironmentMap {
            width: 4,
            height: 3,
            world_from_map: Affine::IDENTITY,
        };
        (map, texture)
    }

    fn turned() -> (EnvironmentMap, Texture) {
        let (mut map, texture) = map();
        map.world_from_map = Affine::rotate(Vec3::new(0.3, 0.8, -0.5).normalized(), 1.1);
        (map, texture)
    }

    const DIRECTIONS: [[f64; 3]; 5] = [
        [0.3, 0.2, 0.9],
        [-0.5, 0.8, -0.1],
        [0.01, -0.9, -0.4],
        [-1.0, 0.1, 0.01],
        [-0.1, 0.1, -1.0],
    ];

    /// Values of Mitsuba 3.9.1.
    #[test]
    fn directions_are_mapped_as_in_mitsuba() {
        let (map, texture) = map();
        let expected = [
            [0.0381678, 0.0839081, 0.0607183],
            [0.4897125, 0.3007108, 0.2459944],
            [0.3564453, 0.3932430, 0.4608692],
            [0.2229137, 0.3792473, 0.0717722],
            [0.2990019, 0.5175266, 0.4362591],
        ];
        for (direction, expected) in DIRECTIONS.into_iter().zip(expected) {
            let direction = Vec3::from(direction).normalized();
            let value = map.lookup(direction, |i| texture.texel(i));
            let error = (value - Rgb::from(expected)).length();
            assert!(error < 1e-6, "{direction:?}: {value:?}");
        }
    }

    /// A turned map shows at the turned direction what it showed before.
    #[test]
    fn maps_turn() {
        let ((map, texture), (turned, _)) = (map(), turned());
        for direction in DIRECTIONS {
            let direction = Vec3::from(direction).normalized();
            let before = map.lookup(direction, |i| texture.texel(i));
            let after = turned.world_from_map.vector(direction);
            let after = turned.lookup(after, |i| texture.texel(i));
            assert!((before - after).length() < 1e-13);
        }
    }

    #[test]
    fn lookups_differentiate() {
        let (map, texture) = turned();
        let value = |d: Vec3| map.lookup(d, |i| texture.texel(i));
        let h = 1e-6;
        for direction in DIRECTIONS {
            let d = Vec3::from(direction).normalized();
            let velocity = Vec3::new(0.5, -0.2, 0.9).reject_from(d);
            let dual = map.lookup(d.with_tangent(velocity), |i| {
                Rgb::constant(texture.texel(i))
            });
            let at = |t: f64| value((d + velocity * t).normalized());
            let difference = (at(h) - at(-h)) / (2.0 * h);
            assert!((dual.tangent(0) - difference).length() < 1e-8, "{d:?}");
            assert!(difference.length() > 0.01);
        }
    }

    /// The density integrates to one, over rows of equal heights.
    #[test]
    fn densities_integrate_to_one() {
        let (map, texture) = turned();
        let table = EnvironmentTable::new(&map, &texture).expect("not black");
        const N: usize = 600;
        let mut sum = 0.0;
        for i in 0..N {
            for j in 0..N {
                let cos = 2.0 * (i as f64 + 0.5) / N as f64 - 1.0;
                let azimuth = 2.0 * PI * (j as f64 + 0.5) / N as f64;
                sum += table.pdf(map.direction(azimuth, cos));
            }
        }
        let integral = sum * 4.0 * PI / (N * N) as f64;
        assert!((integral - 1.0).abs() < 1e-3, "{integral}");
    }

    /// The area element of the sampling map is one over the density, and the
    /// density is that of the direction drawn.
    #[test]
    fn area_element_of_sample_is_one_over_pdf() {
        let (map, texture) = turned();
        let table = EnvironmentTable::new(&map, &texture).expect("not black");
        let h = 1e-6;
        for u in [
            [0.3, 0.7],
            [0.04, 0.2],
            [0.93, 0.9],
            [0.5, 0.31],
            [0.77, 0.05],
        ] {
            let (direction, pdf) = table.sample(u);
            assert!((direction.length() - 1.0).abs() < 1e-12);
            assert!((table.pdf(direction) - pdf).abs() < 1e-12, "{u:?}");
            let along = |axis: usize| {
                let at = |t: f64| {
                    let mut u = u;
                    u[axis] += t;
                    table.sample(u).0
                };
                (at(h) - at(-h)) / (2.0 * h)
            };
            let area = along(0).cross(along(1)).length();
            assert!((area * pdf - 1.0).abs() < 1e-6, "{u:?}: {}", area * pdf);
        }
        // Cells without light are not drawn, whatever the numbers.
        for u in [[0.0, 0.0], [1.0 - 1e-16, 1.0 - 1e-16], [0.5, 0.999_999]] {
            let (direction, pdf) = table.sample(u);
            assert!(pdf > 0.0 && direction.is_finite(), "{u:?}");
        }
    }

    #[test]
    fn a_black_map_has_no_table() {
        let (map, mut texture) = map();
        texture.data.fill(0.0);
        assert!(EnvironmentTable::new(&map, &texture).is_none());
    }
}
