//! What must be the same when a run is resumed.

use capwalk_diff::{Method, WalkSettings};
use capwalk_inverse::Problem;
use capwalk_inverse::variable::VariableSpec;
use capwalk_scene::fingerprint as number;

/// What decides which numbers come out, by names that a message can show. Guards do
/// not: they only stop.
pub fn fingerprint(
    problem: &Problem,
    specs: &[VariableSpec],
    (method, walk): (Method, WalkSettings),
) -> Vec<(String, String)> {
    let mut parts = vec![(
        "version of capwalk".to_owned(),
        env!("CARGO_PKG_VERSION").into(),
    )];
    let mut note = |name: String, what: String| parts.push((name, what));
    note("scene".into(), digest(number(&problem.scene)));
    note("seed".into(), problem.seed.to_string());
    note("spp".into(), problem.spp.to_string());
    note("spp_grad".into(), problem.spp_grad.to_string());
    note("[samples]".into(), format!("{:?}", problem.by_noise));
    let optimizer = format!("lr {}, {:?}", problem.lr, problem.adam);
    note("[optimizer]".into(), optimizer);
    note("[schedule]".into(), format!("{:?}", problem.schedule));
    if problem.schedule.needs_the_end() {
        let iterations = problem.limits.iterations.to_string();
        note("iterations (the schedule needs them)".into(), iterations);
    }
    note("[loss]".into(), format!("{:?}", problem.loss));
    // As it was asked for: what is chosen for it follows from the rest.
    note("[method]".into(), format!("{method:?}, {walk:?}"));
    let names: Vec<&str> = specs.iter().map(|spec| spec.name.as_str()).collect();
    note("names of parameters".into(), shown(names.join(", ")));
    for spec in specs {
        let name = format!("parameter {}", spec.name);
        note(name, shown(format!("{spec:?}")));
    }
    note("number of views".into(), problem.views.len().to_string());
    for (i, view) in problem.views.iter().enumerate() {
        let seen = (&view.sensor, &view.target, &view.mask, view.weight);
        note(format!("view {}", i + 1), digest(number(&seen)));
    }
    parts
}

/// The longest text that is kept as it is, bytes: a message can show it. Each text takes the memory
/// of the longest.
const LONGEST_TEXT: usize = 500;

/// The text, or a number that stands for it.
fn shown(text: String) -> String {
    match text.len() > LONGEST_TEXT {
        true => digest(number(&text)),
        false => text,
    }
}

/// [What stands for a thing](number) as text.
fn digest(fingerprint: u64) -> String {
    format!("{fingerprint:016x}")
}
