//! Commands that ask for too much or for each other's files: each ends soon, without a panic, and
//! leaves what it reads as it was.
//!
//! `cargo xtask soak` tries many more: `CAPWALK_SOAK_SECONDS` says for how long,
//! `CAPWALK_SOAK_SEED` where to begin.

use std::time::{Duration, Instant};

use crate::Capwalk;

/// Commands of a test run.
const COMMANDS: u64 = 12;

/// How long a command may take. Each renders a few pixels, if it does anything.
const LONGEST: Duration = Duration::from_secs(30);

/// Numbers that are too large, or nearly.
const NUMBERS: [&str; 9] = [
    "0",
    "2",
    "4096",
    "65536",
    "2000000000",
    "4294967295",
    "1e30",
    "1e300",
    "-1e200",
];

/// Counts that multiply the work of a sample, of a pixel, or of the image.
const COUNTS: [&str; 7] = [
    "direct emitter_samples",
    "direct bsdf_samples",
    "direct shading_samples",
    "path rr_depth",
    "path max_depth",
    "sensor near_clip",
    "film width",
];

/// What can be set.
const PARAMETERS: [&str; 7] = [
    "box.translate.x",
    "box.rotate.y",
    "box.scale",
    "box.positions[3,1]",
    "sensor.rotate.x",
    "sensor.translate.z",
    "1e200*box.translate.y",
];

/// Files of the folder, all of which are read by one command or the other.
const FILES: [&str; 4] = ["texture.png", "image.npz", "image.exr", "motion.npz"];

/// Knuth's MMIX generator.
struct Random(u64);

impl Random {
    fn of<'a>(&mut self, choices: &[&'a str]) -> &'a str {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        choices[(self.0 >> 33) as usize % choices.len()]
    }
}

/// A box with a texture and one number that somebody else chose.
fn scene(count: &str, number: &str) -> String {
    let (object, name) = count.split_once(' ').expect("two words");
    let kind = if number.contains('e') {
        "float"
    } else {
        "integer"
    };
    let property = |of: &str| match of == object {
        true => format!("<{kind} name=\"{name}\" value=\"{number}\"/>"),
        false => String::new(),
    };
    let integrator = if object == "direct" { "direct" } else { "path" };
    format!(
        "<scene version=\"3.0.0\"><integrator type=\"{integrator}\">{}</integrator>\
         <sensor type=\"perspective\">{}<transform name=\"to_world\"><translate z=\"-6\"/></transform>\
         <film type=\"hdrfilm\">{}</film></sensor><emitter type=\"constant\"/>\
         <shape type=\"cube\" id=\"box\"><bsdf type=\"diffuse\"><texture name=\"reflectance\" \
         type=\"bitmap\"><string name=\"filename\" value=\"texture.png\"/></texture></bsdf></shape>\
         </scene>",
        property(integrator),
        property("sensor"),
        property("film"),
    )
}

/// A command, made by these random numbers.
fn command(random: &mut Random) -> String {
    let set = format!("--set {}={}", random.of(&PARAMETERS), random.of(&NUMBERS));
    let set = random.of(&["", &set]).to_owned();
    let output = random.of(&[FILES[0], FILES[1], FILES[2], FILES[3], "new.npz"]);
    let parameter = random.of(&PARAMETERS);
    let sampling = format!("--size 4x3 --spp 1 --time-limit 2s {set}");
    match random.of(&["render", "gradient", "check", "backward", "compare", "info"]) {
        "render" => format!("render scene.xml {sampling} -o {output}"),
        "gradient" => format!("gradient scene.xml --motion box=motion.npz {sampling} -o {output}"),
        "check" => format!("check scene.xml -p {parameter} {sampling} -o {output}"),
        "backward" => {
            let image = random.of(&["image.npz", "image.exr"]);
            let layer = random.of(&["value", "stderr", "none"]);
            let adjoint = format!("--adjoint {image} --layer {layer} -p {parameter}");
            format!("backward scene.xml {adjoint} {sampling} -o {output}")
        }
        "compare" => format!("compare image.npz image.exr -o {output}"),
        _ => format!("info scene.xml --size 4x3 {set}"),
    }
}

#[test]
fn hostile_commands() {
    let capwalk = Capwalk::new("hostile");
    capwalk.run("render leaf --size 4x3 --spp 2 -o texture.png,image.npz,image.exr");
    let velocities = "0 0 1e10\n".repeat(8);
    capwalk.write("motion.npz", &velocities);
    let variable = |name: &str| std::env::var(name).ok()?.parse().ok();
    let first: u64 = variable("CAPWALK_SOAK_SEED").map_or(0, |seed: u64| seed << 32);
    let seconds = variable("CAPWALK_SOAK_SECONDS").map(Duration::from_secs);
    let (started, mut number) = (Instant::now(), first);
    let is_over = |number: u64| match seconds {
        Some(seconds) => started.elapsed() >= seconds,
        None => number - first >= COMMANDS,
    };
    while !is_over(number) {
        let mut random = Random(number.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        capwalk.write("scene.xml", &scene(random.of(&COUNTS), random.of(&NUMBERS)));
        let command = command(&mut random);
        let inputs = [
            "texture.png",
            "image.npz",
            "image.exr",
            "motion.npz",
            "scene.xml",
        ];
        let before = inputs.map(|file| capwalk.bytes(file));
        let began = Instant::now();
        let finished = capwalk.run(&command);
        let took = began.elapsed();
        println!("{number}: {command}: {} in {took:?}", finished.status);
        assert!(took < LONGEST, "{command} takes {took:?}");
        let stderr = &finished.stderr;
        // A panic ends with 101, an abort has no status.
        assert!((0..=6).contains(&finished.status), "{command}: {stderr}");
        assert!(!stderr.contains("panicked"), "{command}: {stderr}");
        // What a command reads is as it was; others may be replaced by it.
        for (file, before) in inputs.iter().zip(&before) {
            let is_read = command.contains(&format!("-o {file}")) && is_input(&command, file);
            let is_kept = !command.contains(&format!("-o {file}")) || is_read;
            assert!(
                !is_kept || capwalk.bytes(file) == *before,
                "{command}: {file}"
            );
            std::fs::write(capwalk.path(file), before).expect("writable");
        }
        number += 1;
    }
    println!("{} hostile commands", number - first);
}

/// True if a command reads the file.
fn is_input(command: &str, file: &str) -> bool {
    let before = command.split(" -o ").next().unwrap_or(command);
    before.contains(file) || (before.contains("scene.xml") && file == "texture.png")
}
