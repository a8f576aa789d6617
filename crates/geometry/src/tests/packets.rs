//! Packets of rays against brute force.

use capwalk_math::Vec3;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use super::meshes;
use crate::simd::Instructions;
use crate::{BUNDLE, Bundle, Mesh, PacketTree, Ray, RayTree, icosphere, oracle};

/// Numbers that are spread evenly between 0 and 1, by a number of their own.
fn spread(i: u64) -> f64 {
    (i as f64 * 0.618_033_988_749_894_9).fract()
}

/// The rays of a packet.
struct Rays {
    origin: [[f64; BUNDLE]; 3],
    direction: [[f64; BUNDLE]; 3],
    range: [[f64; BUNDLE]; 2],
    mask: u32,
}

impl Rays {
    const NONE: Self = Self {
        origin: [[0.0; BUNDLE]; 3],
        direction: [[0.0; BUNDLE]; 3],
        range: [[0.0; BUNDLE]; 2],
        mask: 0,
    };

    fn set(&mut self, ray: usize, origin: Vec3, direction: Vec3, most: f64) {
        for axis in 0..3 {
            self.origin[axis][ray] = origin.to_array()[axis];
            self.direction[axis][ray] = direction.to_array()[axis];
        }
        self.range[1][ray] = most;
        self.mask |= 1 << ray;
    }

    fn packet(&self) -> Bundle<'_> {
        Bundle {
            origin: &self.origin,
            direction: &self.direction,
            range: self.range.each_ref(),
            mask: self.mask,
        }
    }
}

/// Rays between points in and around a mesh, some of which start on it, and some of which end.
fn packets(mesh: &Mesh, seed: u64) -> Vec<Rays> {
    let (low, high) = mesh.bounds();
    let size = high - low;
    let point = |i: u64| {
        let at = [3, 5, 7].map(|k| 1.6 * spread(k * (i + 17 * seed)) - 0.3);
        low + Vec3::new(size.x * at[0], size.y * at[1], size.z * at[2])
    };
    let on_face = |i: u64| {
        let face = (spread(11 * (i + seed)) * mesh.faces.len() as f64) as usize;
        let [a, b, c] = mesh.corners(face);
        let [u, v] = [
            0.1 + 0.4 * spread(13 * i + seed),
            0.1 + 0.4 * spread(19 * i + seed),
        ];
        a + (b - a) * u + (c - a) * v
    };
    let of_packet = |number: u64| {
        let mut rays = Rays::NONE;
        for ray in 0..BUNDLE {
            let i = BUNDLE as u64 * number + ray as u64;
            let from = if i.is_multiple_of(3) {
                on_face(i)
            } else {
                point(2 * i)
            };
            let to = if i.is_multiple_of(5) {
                on_face(i + 1)
            } else {
                point(2 * i + 1)
            };
            let offset = to - from;
            let distance = offset.length();
            // Some lanes are not asked for.
            if !i.is_multiple_of(7) && distance > 0.0 {
                let most = if i.is_multiple_of(2) {
                    distance
                } else {
                    f64::INFINITY
                };
                rays.set(ray, from, offset / distance, most);
            }
        }
        rays
    };
    (0..24).map(of_packet).collect()
}

/// Half of the largest extent of [`balls`], no power of two.
const HALF: f64 = 1.2;

/// Two balls above a floor.
fn balls() -> Mesh {
    let mut mesh = meshes::sheet(2, |_, _| 0.0);
    for (x, radius) in [(-0.4, 0.3), (0.5, 0.2)] {
        let mut ball = meshes::ball(6, |_| radius);
        let place = |p: &mut Vec3| *p += Vec3::new(x, 0.2 * x, 0.45);
        ball.positions.iter_mut().for_each(place);
        mesh.append(&ball);
    }
    mesh.positions.iter_mut().for_each(|p| *p = *p * HALF);
    mesh
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 96,
        rng_seed: RngSeed::Fixed(7),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    /// The tree finds what asking each triangle finds, whatever the other rays of a packet and the
    /// instructions.
    #[test]
    fn packets_are_those_of_brute_force((mesh, _) in meshes::mesh(), seed in 0..1000_u64) {
        let rays = RayTree::build(&mesh);
        let tree = PacketTree::new(&rays, &mesh);
        let slower = Instructions::slower().into_iter().map(|it| tree.clone().with(it));
        let others: Vec<_> = slower.chain(tree.deep_and_flat(&rays, &mesh)).collect();
        for rays in packets(&mesh, seed) {
            packets_do_not_depend_on(&tree, &others, &rays.packet());
        }
    }
}

/// A floor with spheres, one of which lies on it, one of which is stretched, and one in another.
fn spheres() -> Mesh {
    let mut mesh = meshes::sheet(2, |_, _| 0.0);
    let places = [
        (7, Vec3::splat(0.3), Vec3::new(-0.4, -0.1, 0.3)),
        (6, Vec3::new(0.3, 0.1, 0.2), Vec3::new(0.5, 0.2, 0.5)),
        (5, Vec3::splat(0.1), Vec3::new(-0.35, 0.0, 0.25)),
    ];
    for (frequency, radii, centre) in places {
        let mut sphere = icosphere(frequency);
        let place =
            |p: &mut Vec3| *p = Vec3::new(p.x * radii.x, p.y * radii.y, p.z * radii.z) + centre;
        sphere.positions.iter_mut().for_each(place);
        mesh.append(&sphere);
    }
    mesh.positions.iter_mut().for_each(|p| *p = *p * HALF);
    mesh
}

/// Whatever the other rays, the instructions, and the order in which things are asked.
fn packets_do_not_depend_on(tree: &PacketTree, others: &[PacketTree], packet: &Bundle<'_>) {
    let (faces, hidden) = (tree.first_hits(packet), tree.occluded(packet));
    for other in others {
        assert_eq!(faces, other.first_hits(packet));
        assert_eq!(hidden, other.occluded(packet));
    }
    for (ray, &face) in faces.iter().enumerate() {
        let bit = 1 << ray;
        let mask = packet.mask & bit;
        let alone = Bundle { mask, ..*packet };
        for tree in [tree, &others[ray % others.len()]] {
            assert_eq!(tree.first_hits(&alone)[ray], face);
            assert_eq!(tree.occluded(&alone), hidden & bit);
        }
    }
}

/// Spheres are found by rays that are no longer than a point, by rays from far away along an axis, and
/// beside rays that mean nothing.
#[test]
fn packets_meet_spheres_by_all_rays() {
    let mesh = spheres();
    let rays = RayTree::build(&mesh);
    let (low, high) = mesh.bounds();
    let mut hits = 0;
    for tree in PacketTree::new(&rays, &mesh).deep_and_flat(&rays, &mesh) {
        for i in 0..2000 {
            let [x, y, z] = [2, 3, 5].map(|k| 2.0 * spread(k * i) - 1.0);
            let (size, middle) = (high - low, (low + high) * 0.5);
            let target = middle + Vec3::new(size.x * x, size.y * y, size.z * z) * 0.5;
            let away = [3.0, 1e3, 1e9][i as usize % 3];
            let direction = match i % 2 {
                0 => Vec3::new(0.0, 0.0, -1.0),
                _ => Vec3::new(1.0, 0.0, 0.0),
            };
            let ray = Ray::new(target - direction * away, direction);
            let Some(hit) = rays.first_hit(&ray) else {
                continue;
            };
            if rays.single_faces().contains(&hit.face) {
                continue;
            }
            let mut packet = Rays::NONE;
            for (lane, range) in [[hit.t, hit.t], [0.0, hit.t], [0.0, f64::INFINITY]]
                .into_iter()
                .enumerate()
            {
                packet.set(lane, ray.origin, ray.direction, range[1]);
                packet.range[0][lane] = range[0];
            }
            for (lane, [t_min, t_max]) in [
                [f64::INFINITY; 2],
                [f64::NEG_INFINITY; 2],
                [0.0, f64::NAN],
                [f64::NAN, 1.0],
            ]
            .into_iter()
            .enumerate()
            {
                packet.set(lane + 3, target, ray.direction, t_max);
                packet.range[0][lane + 3] = t_min;
            }
            let none = u32::MAX;
            let faces = tree.first_hits(&packet.packet());
            assert_eq!(faces[..3], [hit.face; 3], "{ray:?}");
            assert_eq!(faces[3..7], [none; 4], "{ray:?}");
            assert_eq!(tree.occluded(&packet.packet()), 0b111, "{ray:?}");
            hits += 1;
        }
    }
    assert!(hits > 400, "{hits}");
    // At the side of the tree.
    let mesh = icosphere(55);
    let tree = PacketTree::new(&RayTree::build(&mesh), &mesh);
    let mut packet = Rays::NONE;
    let ray = Ray::new(Vec3::new(0.9995, 0.0003, -1e9), Vec3::new(0.0, 0.0, 1.0));
    packet.set(0, ray.origin, ray.direction, f64::INFINITY);
    let hit = oracle::first_hit(&mesh, &ray).expect("the sphere");
    assert_eq!(tree.first_hits(&packet.packet())[0], hit.face);
}

/// In a scene of shapes that are not small, packets find what single rays do, but for rays that pass
/// an edge, start or end so near that single precision does not resolve it, which is in proportion to
/// the scene; and spheres as they are found by single rays, also from far away.
#[test]
fn packets_find_what_rays_do() {
    let margin = 10.0 * HALF / f64::from(1 << 20);
    // Rays that begin farther away, and are shorter at both ends.
    let bundles = |mesh: &Mesh, seeds: u64, away: f64, less: f64| {
        let all = (0..seeds).flat_map(|seed| packets(mesh, seed));
        let changed = all.map(move |mut rays| {
            for ray in 0..BUNDLE {
                for axis in 0..3 {
                    rays.origin[axis][ray] -= away * rays.direction[axis][ray];
                }
                rays.range[0][ray] = away + less;
                rays.range[1][ray] += away - less;
            }
            rays
        });
        changed.collect::<Vec<_>>()
    };
    // Single rays meet spheres where they start on them, too.
    for (mesh, count, seeds, away, less) in [
        (balls(), 0, 400, 0.0, 0.0),
        (spheres(), 3, 60, 0.0, margin),
        (spheres(), 3, 30, 1e9, margin),
    ] {
        let rays = RayTree::build(&mesh);
        assert_eq!(rays.sphere_count(), count);
        let tree = PacketTree::new(&rays, &mesh);
        assert!((tree.in_plane() * f64::from(1 << 20) / HALF - 1.0).abs() < 1e-12);
        let slower = Instructions::slower()
            .into_iter()
            .map(|it| tree.clone().with(it));
        let others: Vec<_> = slower.chain(tree.deep_and_flat(&rays, &mesh)).collect();
        let (mut asked, mut differ) = (0, 0);
        for (i, rays) in bundles(&mesh, seeds, away, less).iter().enumerate() {
            let packet = rays.packet();
            if i % 16 == 0 {
                packets_do_not_depend_on(&tree, &others, &packet);
            }
            let (faces, hidden) = (tree.first_hits(&packet), tree.occluded(&packet));
            for lane in (0..BUNDLE).filter(|&lane| packet.mask >> lane & 1 == 1) {
                let of =
                    |vectors: &[[f64; BUNDLE]; 3]| Vec3::from([0, 1, 2].map(|k| vectors[k][lane]));
                let ray = Ray {
                    t_min: packet.range[0][lane] + margin - less,
                    t_max: packet.range[1][lane] - margin + less,
                    ..Ray::new(of(packet.origin), of(packet.direction))
                };
                let expected = oracle::first_hit(&mesh, &ray).map(|hit| hit.face);
                asked += 1;
                let found = Some(faces[lane]).filter(|&face| face != u32::MAX);
                let is_hidden = hidden >> lane & 1 == 1;
                // The packet's ray goes on beyond its end by what lies in a plane.
                let same = found == expected || (expected.is_none() && !is_hidden);
                differ += usize::from(!same || is_hidden != expected.is_some());
            }
        }
        println!("{differ} of {asked} differ");
        assert!(
            asked > 300 * seeds as usize && differ * 2000 < asked,
            "{differ} of {asked}"
        );
    }
}
