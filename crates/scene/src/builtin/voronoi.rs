//! Voronoi cells on the unit sphere.
//!
//! The Delaunay triangles of points on a sphere are the faces of their convex
//! hull, and the cell corners are the directions of the faces' normals (Brown
//! 1979). The hull is built point by point: faces that see the new point are
//! replaced by a fan from the point to their horizon.

use std::collections::HashMap;

use capwalk_math::Vec3;

/// The Voronoi diagram of points on the unit sphere.
pub struct Voronoi {
    /// Corners of the cells, unit vectors.
    pub corners: Vec<Vec3>,
    /// For each site its corners, counter-clockwise seen from outside.
    pub cells: Vec<Vec<u32>>,
}

/// `count` directions that are spread evenly but irregularly: random ones,
/// each moved `rounds` times to the middle of its Voronoi cell (Lloyd 1982).
/// They are the same on every call.
pub fn spread_directions(count: usize, rounds: usize) -> Vec<Vec3> {
    let mut state = 0x0c0f_fee0_u64;
    let mut sites: Vec<Vec3> = (0..count)
        .map(|_| {
            let z = 2.0 * uniform(&mut state) - 1.0;
            let (sin, cos) = (std::f64::consts::TAU * uniform(&mut state)).sin_cos();
            let radius = (1.0 - z * z).sqrt();
            Vec3::new(radius * cos, radius * sin, z)
        })
        .collect();
    for _ in 0..rounds {
        let Voronoi { corners, cells } = voronoi(&sites);
        for (site, cell) in sites.iter_mut().zip(&cells) {
            // The integral of the position over a spherical polygon: half the
            // sum of its sides' lengths times their planes' inward normals.
            let next = |i: usize| corners[cell[(i + 1) % cell.len()] as usize];
            let middle = (0..cell.len()).fold(Vec3::zero(), |sum, i| {
                let (a, b) = (corners[cell[i] as usize], next(i));
                let normal = a.cross(b);
                sum + normal.normalized() * normal.length().atan2(a.dot(b))
            });
            *site = middle.normalized();
        }
    }
    sites
}

/// The Voronoi diagram of at least four sites, no four of them on one circle
/// and not all in one hemisphere.
pub fn voronoi(sites: &[Vec3]) -> Voronoi {
    let faces = hull(sites);
    let corners = faces.iter().map(|&[a, b, c]| {
        let [a, b, c] = [a, b, c].map(|i| sites[i as usize]);
        (b - a).cross(c - a).normalized()
    });
    // The face to the left of each directed edge.
    let mut left: HashMap<(u32, u32), u32> = HashMap::new();
    for (i, f) in faces.iter().enumerate() {
        for k in 0..3 {
            left.insert((f[k], f[(k + 1) % 3]), i as u32);
        }
    }
    // Around a site: the face left of site → a has a third point b, and the
    // next face counter-clockwise is the one left of site → b.
    let mut first = vec![0; sites.len()];
    for f in &faces {
        for k in 0..3 {
            first[f[k] as usize] = f[(k + 1) % 3];
        }
    }
    let cell = |site: u32| {
        let start = first[site as usize];
        let (mut a, mut cell) = (start, Vec::new());
        loop {
            let face = left[&(site, a)];
            cell.push(face);
            let f = faces[face as usize];
            let corner = f
                .iter()
                .position(|&v| v == site)
                .expect("a face of the site");
            a = f[(corner + 2) % 3];
            if a == start {
                return cell;
            }
        }
    };
    Voronoi {
        corners: corners.collect(),
        cells: (0..sites.len() as u32).map(cell).collect(),
    }
}

/// The triangles of the convex hull, wound outward.
fn hull(points: &[Vec3]) -> Vec<[u32; 3]> {
    let sees = |p: Vec3, &[a, b, c]: &[u32; 3]| {
        let [a, b, c] = [a, b, c].map(|i| points[i as usize]);
        (b - a).cross(c - a).dot(p - a) > 0.0
    };
    let base = [0, 1, 2];
    let base = if sees(points[3], &base) {
        [0, 2, 1]
    } else {
        base
    };
    let [a, b, c] = base;
    let mut faces = vec![base, [a, c, 3], [c, b, 3], [b, a, 3]];
    for (i, &p) in points.iter().enumerate().skip(4) {
        let (seen, kept): (Vec<_>, Vec<_>) = faces.iter().partition(|face| sees(p, face));
        faces = kept;
        // The horizon: edges of seen faces whose other face is not seen.
        let edges = |f: &[u32; 3]| [(f[0], f[1]), (f[1], f[2]), (f[2], f[0])];
        let inner: std::collections::HashSet<(u32, u32)> = seen.iter().flat_map(edges).collect();
        let horizon = seen.iter().flat_map(edges);
        faces.extend(
            horizon
                .filter(|&(a, b)| !inner.contains(&(b, a)))
                .map(|(a, b)| [a, b, i as u32]),
        );
    }
    faces
}

/// A number in `[0, 1)`. SplitMix64 (Steele et al. 2014).
fn uniform(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 * (-53.0_f64).exp2()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By brute force: no site is closer to a corner than the sites of the
    /// three cells that meet there, and the cells cover the sphere once.
    #[test]
    fn corners_are_closest_to_their_own_sites() {
        for (count, rounds) in [(4, 0), (13, 0), (150, 0), (150, 3)] {
            let sites = match count {
                // Random sites might lie in one hemisphere.
                4 => [
                    [1.0, 1.0, 1.1],
                    [1.0, -1.0, -1.0],
                    [-1.0, 1.2, -1.0],
                    [-1.0, -1.0, 1.0],
                ]
                .map(|p: [f64; 3]| Vec3::from(p).normalized())
                .to_vec(),
                _ => spread_directions(count, rounds),
            };
            let Voronoi { corners, cells } = voronoi(&sites);
            assert_eq!(corners.len(), 2 * count - 4);
            let mut solid_angle = 0.0;
            for (site, cell) in sites.iter().zip(&cells) {
                assert!(cell.len() >= 3);
                for (i, &corner) in cell.iter().enumerate() {
                    let corner = corners[corner as usize];
                    let nearest = sites.iter().map(|s| s.dot(corner)).fold(-1.0, f64::max);
                    assert!(site.dot(corner) > nearest - 1e-12);
                    // Van Oosterom and Strackee 1983, around the site.
                    let next = corners[cell[(i + 1) % cell.len()] as usize];
                    let triple = site.dot(corner.cross(next));
                    assert!(triple > 0.0, "counter-clockwise");
                    let denominator = 1.0 + site.dot(corner) + corner.dot(next) + next.dot(*site);
                    solid_angle += 2.0 * triple.atan2(denominator);
                }
            }
            let sphere = 4.0 * std::f64::consts::PI;
            assert!((solid_angle / sphere - 1.0).abs() < 1e-12, "{solid_angle}");
        }
    }

    /// Moving to the middles spreads: the closest pair gets farther apart.
    #[test]
    fn relaxed_directions_keep_their_distance() {
        let closest = |sites: &[Vec3]| {
            let mut cos = -1.0_f64;
            for (i, a) in sites.iter().enumerate() {
                cos = sites[..i].iter().map(|b| a.dot(*b)).fold(cos, f64::max);
            }
            cos.acos()
        };
        let (random, relaxed) = (spread_directions(150, 0), spread_directions(150, 3));
        assert!(closest(&random) < 0.05 && closest(&relaxed) > 0.1);
    }
}
