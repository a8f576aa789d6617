//! Images of all directions, as Mitsuba 3.9 maps them: the polar angle from
//! `+y` over the rows, from the first to the last; the azimuth over the columns,
//! whose centres are at `(i + 0.5) / width`, with `-z` at 0 and `+x` at 1/4.

use std::f64::consts::PI;

use capwalk_math::elementary::{angle_of, floor, sin_cos};
use capwalk_math::{Affine, Real, Rgb, Vec3};
use serde::{Deserialize, Serialize};

use super::guides::{Guides, Start};
use crate::texture::{Texture, between, bilinear};

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
        texel: impl FnMut(usize) -> Rgb<R>,
    ) -> Rgb<R> {
        self.at(&self.place(direction), texel)
    }

    /// The texels' mean at a place, see [`Self::lookup`].
    #[inline(always)]
    pub fn at<R: Real>(&self, place: &MapPlace<R>, texel: impl FnMut(usize) -> Rgb<R>) -> Rgb<R> {
        let (corners, along) = self.corners(place);
        between(corners.map(texel), along)
    }

    /// The texels whose mean [`Self::at`] is, with their weights.
    pub fn weights(&self, place: &MapPlace<f64>) -> [(usize, f64); 4] {
        let (corners, along) = self.corners(place);
        bilinear(corners, along)
    }

    /// The texels around a place, row by row, and the fractions of the way from the first of them.
    #[inline(always)]
    pub fn corners<R: Real>(&self, place: &MapPlace<R>) -> ([usize; 4], [R; 2]) {
        let (width, height) = (i64::from(self.width), i64::from(self.height));
        let split = |x: R| {
            let below = floor(x.value());
            (below as i64, x - R::constant(below))
        };
        let [(x, s), (y, t)] = place.texel.map(split);
        let [x, next_x] = [x, x + 1].map(|x| self.wrapped(x));
        let [y, next_y] = [y, y + 1].map(|y| y.clamp(0, height - 1) * width);
        let corners = [y + x, y + next_x, next_y + x, next_y + next_x];
        (corners.map(|index| index as usize), [s, t])
    }

    /// The column that stands for another one, around the map.
    #[inline(always)]
    fn wrapped(&self, column: i64) -> i64 {
        let width = i64::from(self.width);
        match (0..width).contains(&column) {
            true => column,
            false => column.rem_euclid(width),
        }
    }

    /// Where a unit direction of the world is.
    #[inline(always)]
    pub fn place<R: Real>(&self, direction: Vec3<R>) -> MapPlace<R> {
        // The transpose of a rotation is its inverse.
        let [a, b, c] = self.world_from_map.rows.map(Vec3::constant);
        let d = a * direction.x + b * direction.y + c * direction.z;
        let azimuth = angle(d.x, -d.z);
        let sin = (d.x * d.x + d.z * d.z).sqrt();
        let polar = angle(sin, d.y);
        let (width, height) = (f64::from(self.width), f64::from(self.height));
        MapPlace {
            texel: [
                azimuth * R::constant(0.5 / PI * width) - R::constant(0.5),
                polar * R::constant((height - 1.0) / PI),
            ],
            cos: d.y.value(),
        }
    }

    /// The unit direction of the world at an azimuth and the cosine of a polar
    /// angle.
    #[inline(always)]
    fn direction(&self, azimuth: f64, cos: f64) -> Vec3 {
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        let (sin_azimuth, cos_azimuth) = sin_cos(azimuth);
        let local = Vec3::new(sin_azimuth * sin, cos, -cos_azimuth * sin);
        self.world_from_map.vector(local)
    }
}

/// A direction, as a map has it.
#[derive(Clone, Copy, Debug, Default)]
pub struct MapPlace<R> {
    /// Column and row, in texels; whole numbers are centres.
    pub texel: [R; 2],
    /// Cosine of the polar angle.
    pub cos: f64,
}

/// `atan2(sin, cos)` with its derivative, which is zero where both are.
#[inline(always)]
fn angle<R: Real>(sin: R, cos: R) -> R {
    let (s, c) = (sin.value(), cos.value());
    let squared = s * s + c * c;
    let value = R::constant(angle_of([c, s]));
    if sin.is_constant() && cos.is_constant() || squared == 0.0 {
        return value;
    }
    let change = (sin - R::constant(s)) * R::constant(c) - (cos - R::constant(c)) * R::constant(s);
    value + change * R::constant(1.0 / squared)
}

/// Directions drawn in proportion to the brightness of an environment map, or to what of it exceeds the
/// mean: a density that is at the
/// centres of texels proportional to their luminance, and in the cells between them linear in the
/// azimuth and in the cosine of the polar angle. The map itself is linear in the polar angle, which
/// differs near the poles alone.
#[derive(Clone, Debug)]
pub struct EnvironmentTable {
    map: EnvironmentMap,
    is_black: bool,
    /// Cosine of the polar angle of each row of texels.
    cosines: Vec<f64>,
    /// Sums of the cells' chances up to each row, then within each row.
    rows: Vec<f64>,
    cells: Vec<f64>,
    row_guide: Guides,
    cell_guides: Guides,
    /// Density per solid angle at each texel.
    densities: Vec<f64>,
}

/// A map whose brightness exceeds its mean by less than this share counts as the same everywhere.
const FLAT: f64 = 1e-9;

impl EnvironmentTable {
    /// The table of a map with these texels. If surfaces draw directions, too, which find light from
    /// everywhere, it is that of what is brighter than the mean (Karlík et al. 2019, MIS
    /// compensation with the map's mean).
    pub fn new(map: &EnvironmentMap, texture: &Texture, surfaces_draw: bool) -> Self {
        let (width, height) = (map.width as usize, map.height as usize);
        let luminance = |texel: usize| texture.texel(texel).luminance().max(0.0);
        let densities: Vec<f64> = (0..width * height).map(luminance).collect();
        let polar = |row: usize| PI * row as f64 / (height - 1) as f64;
        let cosines: Vec<f64> = (0..height).map(|row| polar(row).cos()).collect();
        let table = Self {
            map: map.clone(),
            is_black: true,
            cosines,
            rows: Vec::new(),
            cells: Vec::new(),
            row_guide: Guides::default(),
            cell_guides: Guides::default(),
            densities,
        };
        let (of_all, total) = table.with_sums();
        if !surfaces_draw || of_all.is_black {
            return of_all;
        }
        let mean = total / (4.0 * PI);
        let brighter = |density: &f64| (density * total - mean).max(0.0);
        let densities = of_all.densities.iter().map(brighter).collect();
        let (of_brighter, rest) = Self {
            densities,
            ..of_all.clone()
        }
        .with_sums();
        // Of a map that is the same everywhere there is nothing left but rounding.
        match rest > FLAT * total {
            true => of_brighter,
            false => of_all,
        }
    }

    /// This table with the sums of its densities, which become those of directions, and their
    /// integral before.
    fn with_sums(mut self) -> (Self, f64) {
        let (width, height) = (self.map.width as usize, self.map.height as usize);
        (self.rows, self.cells) = (Vec::new(), Vec::with_capacity(width * (height - 1)));
        let mut total = 0.0;
        for y in 0..height - 1 {
            let solid_angle = 2.0 * PI / width as f64 * (self.cosines[y] - self.cosines[y + 1]);
            let mut of_row = 0.0;
            for x in 0..width {
                let [above, below] = self.corner_densities(x, y);
                let mean = [above, below].as_flattened().iter().sum::<f64>() / 4.0;
                of_row += mean * solid_angle;
                self.cells.push(of_row);
            }
            total += of_row;
            self.rows.push(total);
        }
        self.is_black = !(total > 0.0 && total.is_finite());
        if !self.is_black {
            let densities = self.densities.iter_mut();
            densities.for_each(|density| *density /= total);
        }
        self.row_guide = Guides::new(&self.rows, height - 1);
        self.cell_guides = Guides::new(&self.cells, width);
        (self, total)
    }

    /// True if the map is black (or has no finite sum): nothing can be drawn.
    pub fn is_black(&self) -> bool {
        self.is_black
    }

    /// The map whose directions are drawn.
    pub fn map(&self) -> &EnvironmentMap {
        &self.map
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

    /// Density per solid angle at the centre of each texel, row by row.
    pub fn densities(&self) -> &[f64] {
        &self.densities
    }

    /// A unit direction of the world, and its place, unless the map [is black](Self::is_black).
    pub fn sample(&self, u: [f64; 2]) -> (Vec3, MapPlace<f64>) {
        let [cell] = self.choose(|_| u, std::iter::once(0));
        self.within(&cell)
    }

    /// A cell for each of some lanes, which has two random numbers: the first chooses the column,
    /// the second the row, and what is left of them says where in the cell.
    ///
    /// Tables are larger than caches. Lanes ask together for what the next step reads: then
    /// they wait for memory once, and not one after the other.
    #[inline(always)]
    pub fn choose<const LANES: usize>(
        &self,
        u: impl Fn(usize) -> [f64; 2],
        lanes: impl Iterator<Item = usize> + Clone,
    ) -> [ChosenCell; LANES] {
        let mut rows = [(0, 0.0); LANES];
        for lane in lanes.clone() {
            let start = self.row_guide.start(&self.rows, 0, u(lane)[1]);
            rows[lane] = self.row_guide.choose(&self.rows, 0, start);
        }
        let mut starts = [Start::default(); LANES];
        for lane in lanes.clone() {
            starts[lane] = self
                .cell_guides
                .start(&self.cells, rows[lane].0, u(lane)[0]);
        }
        let mut columns = [(0, 0.0); LANES];
        for lane in lanes.clone() {
            columns[lane] = self
                .cell_guides
                .choose(&self.cells, rows[lane].0, starts[lane]);
        }
        let mut cells = [ChosenCell::default(); LANES];
        for lane in lanes {
            let ((row, down), (column, along)) = (rows[lane], columns[lane]);
            cells[lane] = ChosenCell {
                column: column as f64,
                cosines: [self.cosines[row], self.cosines[row + 1]],
                densities: self.corner_densities(column, row),
                u: [along, down],
            };
        }
        cells
    }

    /// A unit direction of the world to a cell, and its place. Without a branch.
    #[inline(always)]
    pub fn within(&self, cell: &ChosenCell) -> (Vec3, MapPlace<f64>) {
        let [[a, b], [c, d]] = cell.densities;
        let down = sample_linear([a + b, c + d], cell.u[1]);
        let [left, right] = [a + (c - a) * down, b + (d - b) * down];
        let along = sample_linear([left, right], cell.u[0]);
        let [top, bottom] = cell.cosines;
        let cos = top + (bottom - top) * down;
        let column = cell.column + along;
        let azimuth = 2.0 * PI / f64::from(self.map.width) * (column + 0.5);
        let polar = angle_of([cos, (1.0 - cos * cos).max(0.0).sqrt()]);
        let rows = (f64::from(self.map.height) - 1.0) / PI;
        let place = MapPlace {
            texel: [column, polar * rows],
            cos,
        };
        (self.map.direction(azimuth, cos), place)
    }

    /// Density per solid angle of [`EnvironmentTable::sample`] at a place.
    #[inline(always)]
    pub fn pdf(&self, place: &MapPlace<f64>) -> f64 {
        let [x, y] = place.texel;
        let column = floor(x);
        let along = x - column;
        let row = (floor(y) as i64).clamp(0, i64::from(self.map.height) - 2) as usize;
        let (top, bottom) = (self.cosines[row], self.cosines[row + 1]);
        let down = ((top - place.cos) / (top - bottom)).clamp(0.0, 1.0);
        let column = self.map.wrapped(column as i64) as usize;
        let [[a, b], [c, d]] = self.corner_densities(column, row);
        let [left, right] = [a + (c - a) * down, b + (d - b) * down];
        left + (right - left) * along
    }

    /// The densities at the corners of a cell, row by row.
    #[inline(always)]
    fn corner_densities(&self, column: usize, row: usize) -> [[f64; 2]; 2] {
        let width = self.map.width as usize;
        let next = if column + 1 == width { 0 } else { column + 1 };
        let of_row = |row: usize| [column, next].map(|x| self.densities[row * width + x]);
        [of_row(row), of_row(row + 1)]
    }
}

/// A cell of a table that was chosen.
#[derive(Clone, Copy, Debug, Default)]
pub struct ChosenCell {
    column: f64,
    /// Of the polar angles of its rows of texels.
    cosines: [f64; 2],
    /// At its corners, row by row.
    densities: [[f64; 2]; 2],
    /// Numbers that say where in it.
    u: [f64; 2],
}

/// A number from 0 to 1, drawn from a density that is proportional to `start` at 0, to `end` at 1,
/// and linear in between.
#[inline(always)]
fn sample_linear([start, end]: [f64; 2], u: f64) -> f64 {
    let root = (start * start + u * (end * end - start * start)).sqrt();
    let sum = start + root;
    // Where nothing is drawn but by rounding, it is even.
    let is_drawn = sum > 0.0;
    let x = u * (start + end) / if is_drawn { sum } else { 1.0 };
    if is_drawn { x.min(1.0) } else { u }
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
        for surfaces_draw in [false, true] {
            let table = EnvironmentTable::new(&map, &texture, surfaces_draw);
            const N: usize = 600;
            let mut sum = 0.0;
            for i in 0..N {
                for j in 0..N {
                    let cos = 2.0 * (i as f64 + 0.5) / N as f64 - 1.0;
                    let azimuth = 2.0 * PI * (j as f64 + 0.5) / N as f64;
                    sum += table.pdf(&map.place(map.direction(azimuth, cos)));
                }
            }
            let integral = sum * 4.0 * PI / (N * N) as f64;
            assert!((integral - 1.0).abs() < 1e-3, "{integral}");
        }
    }

    /// Beside directions that surfaces draw, only what is brighter than the mean is drawn, unless
    /// nothing is.
    #[test]
    fn what_is_dark_is_left_to_surfaces() {
        let (map, mut texture) = map();
        let table = EnvironmentTable::new(&map, &texture, true);
        let dark = table.densities().iter().filter(|&&d| d == 0.0).count();
        assert!((3..10).contains(&dark), "{dark}");
        texture.data.fill(0.7);
        let table = EnvironmentTable::new(&map, &texture, true);
        let uniform = 0.25 / PI;
        let even = |density: &f64| (density - uniform).abs() < 1e-12;
        assert!(table.densities().iter().all(even) && !table.is_black());
    }

    /// The area element of the sampling map is one over the density, and the
    /// density is that of the direction drawn.
    #[test]
    fn area_element_of_sample_is_one_over_pdf() {
        let (map, texture) = turned();
        let table = EnvironmentTable::new(&map, &texture, false);
        let h = 1e-6;
        for u in [
            [0.3, 0.7],
            [0.04, 0.2],
            [0.93, 0.9],
            [0.5, 0.31],
            [0.77, 0.05],
        ] {
            let (direction, place) = table.sample(u);
            assert!((direction.length() - 1.0).abs() < 1e-12);
            let pdf = table.pdf(&map.place(direction));
            assert!((table.pdf(&place) - pdf).abs() < 1e-12, "{u:?}");
            let (expected, found) = (map.place(direction).texel, place.texel);
            let turn = (expected[0] - found[0]) / f64::from(map.width);
            assert!((turn - turn.round()).abs() < 1e-12, "{u:?}");
            assert!((expected[1] - found[1]).abs() < 1e-12, "{u:?}");
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
            let (direction, place) = table.sample(u);
            assert!(table.pdf(&place) > 0.0 && direction.is_finite(), "{u:?}");
        }
    }

    #[test]
    fn a_black_map_is_known() {
        let (map, mut texture) = map();
        assert!(!EnvironmentTable::new(&map, &texture, false).is_black());
        texture.data.fill(0.0);
        assert!(EnvironmentTable::new(&map, &texture, false).is_black());
    }
}
