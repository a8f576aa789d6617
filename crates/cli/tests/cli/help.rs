use crate::{Capwalk, assert_has};

#[test]
fn help_lists_commands_and_exit_statuses() {
    let finished = Capwalk::new("help").run("--help");
    assert_eq!(finished.status, 0);
    assert_has(
        &finished.stdout,
        &[
            "render",
            "gradient",
            "backward",
            "check",
            "info",
            "compare",
            "scenes",
            "demo",
            "Exit status",
            "stopped by Ctrl-C",
        ],
    );
}

#[test]
fn every_command_has_help() {
    let capwalk = Capwalk::new("help_commands");
    for command in [
        "render", "gradient", "backward", "check", "info", "compare", "scenes", "demo",
    ] {
        let finished = capwalk.run(&format!("{command} --help"));
        assert_eq!(finished.status, 0, "{command}");
        assert_has(&finished.stdout, &["Usage: capwalk", "--json"]);
    }
}

/// Scripts take status 2 for "inconclusive", so wrong usage must be 3.
#[test]
fn wrong_usage_is_bad_input() {
    let capwalk = Capwalk::new("usage");
    for arguments in [
        "",
        "frobnicate",
        "render",
        "render leaf --spp 0",
        "gradient leaf",
    ] {
        assert_eq!(capwalk.run(arguments).status, 3, "\"{arguments}\"");
    }
    let message = capwalk.error("check leaf -p leaf.translate.x --step -1");
    assert_has(&message, &["--step", "above 0"]);
}

/// Whoever knows the command finds its program.
#[test]
fn figures_name_their_program() {
    let message = Capwalk::new("figures").error("figures fig03 --quality smoke");
    let command = "cargo run --release -p capwalk-paper -- figures fig03 --quality smoke";
    assert_has(&message, &[command]);
}

#[test]
fn info_lists_parameters() {
    let capwalk = Capwalk::new("info");
    let grouped = capwalk.run("info ball").stdout;
    let lines = [
        "  ball.translate.x|y|z rotate.x|y|z scale ",
        "moves, turns and scales ball",
        "  lamp.emitter.radiance.value[.r|g|b] ",
        " radiance of lamp (radiance)",
        "  sensor.translate.x|y|z rotate.x|y|z ",
        "  ball.positions ",
        "  ball.translate ",
        "other names of the same: --all",
    ];
    assert_has(&grouped, &lines);
    assert!(!grouped.contains("ball.translate.y") && !grouped.contains("vertex_positions"));
    let text = capwalk.run("info ball --all").stdout;
    assert_has(
        &text,
        &[
            "triangles",
            "ball.translate.x",
            "lamp.emitter.radiance.value",
            "sensor.rotate.z",
        ],
    );
    let json = capwalk.json("info ball --json --size 30x20");
    assert_eq!(json["size"], serde_json::json!([30, 20]));
    let parameters = json["parameters"].as_array().expect("a list");
    let moves = |name: &str| {
        let found = parameters.iter().find(|p| p["name"] == name).expect(name);
        found["moves_discontinuities"].as_bool()
    };
    let arrays = json["arrays"].as_array().expect("a list");
    let array = |name: &str| arrays.iter().find(|a| a["name"] == name).expect(name);
    assert_eq!(array("ball.positions")["kind"], "Positions");
    assert_eq!(array("ball.positions")["shape"][1], 3);
    assert_eq!(array("ball.positions")["moves_discontinuities"], true);
    assert_eq!(array("lamp.emitter.radiance.value")["differentiable"], true);
    assert_has(&text, &["arrays", "ball.positions", "vertices of ball"]);
    assert_eq!(moves("ball.translate.x"), Some(true));
    assert_eq!(moves("lamp.emitter.radiance.value"), Some(false));
}
