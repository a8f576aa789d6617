//! What a prepared scene saves, as `cargo bench -p capwalk --bench prepared` prints it: an
//! optimisation step on a mesh of 60,500 triangles with everything built anew and with
//! what is there refitted, and the set-up of a scene of 20,000 shapes.
//!
//! A step is an update and a derivative image of 64 × 48 pixels by 8 samples, on one
//! thread. Times are medians over several steps.

use std::fmt::Write;
use std::time::Instant;

use capwalk::scene::primitive::icosphere;
use capwalk::scene::{Scene, ShadingNormals, Tangent};
use capwalk::{GradientOptions, Loader, Prepared, RenderOptions, Unwatched, load, with_threads};

/// Edges of the ball are cut into so many: `20 n²` triangles.
const FREQUENCY: u32 = 55;
const SPP: u32 = 8;
/// Odd, so that there is a median.
const ROUNDS: u32 = 9;
const SHAPES: usize = 20_000;

fn main() {
    with_threads(1, || {
        steps();
        many_shapes();
    });
}

/// What a step does.
type Step = fn(&Bench, Prepared, Scene) -> Prepared;

const STEPS: [(&str, &str, Step); 4] = [
    ("the ball moves, all built anew", "ball.translate.x", anew),
    ("the ball moves, refitted", "ball.translate.x", updated),
    ("a colour changes, all built anew", COLOUR, anew),
    ("a colour changes, nothing built", COLOUR, updated),
];
const COLOUR: &str = "floor.bsdf.reflectance.value";

struct Bench {
    tangent: Tangent,
    options: GradientOptions,
}

impl Bench {
    fn gradient(&self, prepared: &Prepared) {
        let gradient = prepared.gradient(&self.tangent, &self.options, &Unwatched);
        std::hint::black_box(gradient.expect("covered"));
    }
}

fn anew(bench: &Bench, _: Prepared, scene: Scene) -> Prepared {
    let prepared = Prepared::new(scene).expect("a valid scene");
    bench.gradient(&prepared);
    prepared
}

fn updated(bench: &Bench, mut prepared: Prepared, scene: Scene) -> Prepared {
    prepared.update_scene(scene).expect("a valid scene");
    bench.gradient(&prepared);
    prepared
}

fn steps() {
    let loaded = Loader::new("ball").size([64, 48]).load();
    let mut scene = loaded.expect("a built-in scene").scene;
    for shape in scene.shapes_mut().filter(|shape| shape.id == "ball") {
        // In the place of the built-in ball, which is coarser.
        let (low, high) = shape.mesh.bounds();
        let (centre, radius) = ((low + high) * 0.5, 0.5 * (high - low).x);
        shape.mesh = icosphere(FREQUENCY);
        for p in &mut shape.mesh.positions {
            *p = centre + *p * radius;
        }
        shape.normals = ShadingNormals::Face;
    }
    println!("| step | milliseconds |\n|---|---|");
    for (what, name, step) in STEPS {
        let prepared = Prepared::new(scene.clone()).expect("a valid scene");
        let bench = Bench {
            tangent: prepared.registry().tangent(&scene, name).expect(name),
            options: GradientOptions::new(RenderOptions::new(SPP, 1)),
        };
        bench.gradient(&prepared);
        let mut times = Vec::new();
        let mut prepared = Some(prepared);
        for round in 1..=ROUNDS {
            let next = scene.moved(&bench.tangent, 1e-3 * f64::from(round));
            let started = Instant::now();
            prepared = prepared.map(|prepared| step(&bench, prepared, next));
            times.push(started.elapsed());
        }
        times.sort();
        println!(
            "| {what} | {:.0} |",
            1e3 * times[times.len() / 2].as_secs_f64()
        );
    }
}

/// Writes a scene of many rectangles to a file, loads it, and differentiates one sample.
fn many_shapes() {
    let mut text = String::from(
        "<scene version=\"3.0.0\"><integrator type=\"path\"><integer name=\"max_depth\" \
         value=\"2\"/></integrator><sensor type=\"perspective\"><film type=\"hdrfilm\">\
         <integer name=\"width\" value=\"16\"/><integer name=\"height\" value=\"12\"/></film>\
         <transform name=\"to_world\"><lookat origin=\"0,30,40\" target=\"0,0,0\" up=\"0,1,0\"/>\
         </transform></sensor><emitter type=\"constant\"/>\n",
    );
    for i in 0..SHAPES {
        let [x, z] = [i % 141, i / 141].map(|k| 0.3 * k as f64 - 21.0);
        writeln!(
            text,
            "<shape type=\"rectangle\" id=\"s{i}\"><transform name=\"to_world\"><scale \
             value=\"0.1\"/><translate x=\"{x:.2}\" z=\"{z:.2}\"/></transform><bsdf \
             type=\"diffuse\"><rgb name=\"reflectance\" value=\"0.5,0.4,0.3\"/></bsdf></shape>"
        )
        .expect("strings take everything");
    }
    let file = std::env::temp_dir().join(format!("capwalk-bench-{}.xml", std::process::id()));
    std::fs::write(&file, text + "</scene>").expect("a folder for temporary files");

    println!("\n| {SHAPES} shapes | milliseconds |\n|---|---|");
    let mut started = Instant::now();
    let mut lap = |what: &str| {
        println!("| {what} | {:.0} |", 1e3 * started.elapsed().as_secs_f64());
        started = Instant::now();
    };
    let scene = load(&file).expect("a valid scene").scene;
    lap("load");
    let prepared = Prepared::new(scene).expect("a valid scene");
    let tangent = prepared
        .registry()
        .tangent(prepared.scene(), "s7.translate.y");
    let tangent = tangent.expect("a parameter");
    lap("prepare, and the names of all parameters");
    let options = GradientOptions::new(RenderOptions::new(1, 1));
    let gradient = prepared.gradient(&tangent, &options, &Unwatched);
    std::hint::black_box(gradient.expect("covered"));
    lap("trees, and a derivative of 192 samples");
    std::fs::remove_file(file).ok();
}
