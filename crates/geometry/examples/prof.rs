#[path = "../benches/meshes/mod.rs"]
mod meshes;
use capwalk_geometry::*;
use std::hint::black_box;
fn main() {
    let mesh = if std::env::args().nth(1).unwrap() == "sphere" {
        meshes::bumpy_sphere(112)
    } else {
        meshes::lattice([11, 11, 10])
    };
    let mut random = meshes::Random::new(7);
    let views: Vec<_> = (0..4096)
        .map(|_| {
            let eye = random.direction() * (1.2 + 1.8 * random.unit());
            let target = random.direction() * (1.1 * random.unit().cbrt());
            (eye, (target - eye).normalized())
        })
        .collect();
    let edges = topology::edges(&mesh);
    let st = SilhouetteTree::build(&mesh, &edges);
    for _ in 0..100 {
        for &(eye, axis) in &views {
            black_box(st.closest(&ConeQuery {
                eye,
                axis,
                max_angle: 4.0,
                edges: EdgeSelection::Silhouettes,
                groups: 255,
                in_front_of: None,
            }));
        }
    }
}
