//! The phenomena: every folder of `tests/scenes` has a scene and the parameters
//! by which its image is differentiated. Each derivative equals finite
//! differences, with edges gathered as well as walked to; forward mode agrees with reverse
//! mode; or it is refused with the reason.
//! `cargo test -p capwalk-cli --test phenomena <folder>` runs one.

mod both_modes;
mod differences;
mod folder;
mod gathered;
mod methods;
mod reference;
#[path = "../../../../tests/references/store.rs"]
mod store;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use folder::{Demand, Folder};

/// A test for each folder, and the list of them.
macro_rules! phenomena {
    ($($name:ident)*) => {
        $(#[test] fn $name() { run(stringify!($name)) })*
        const LISTED: &[&str] = &[$(stringify!($name)),*];
    };
}

phenomena! {
    albedo
    brushed_metal_without_texture_coordinates
    camera_moves_before_a_mirror_ball
    camera_moves_past_hard_shadows
    camera_moves_with_shadows
    camera_moves_without_shadows
    camera_over_a_texture
    caustic_below_a_lens
    checkerboard_under_a_moving_cube
    coarse_mirror_turns
    coarse_smooth_ball_turns
    colours_of_a_wall_slide
    colours_of_faces
    colours_of_vertices
    curve_moves
    cylinder_moves
    depth_of_a_turning_cube
    discontinuous_texture
    emitter_cut_by_a_blade
    emitter_moves
    emitter_moves_in_view
    emitter_of_many_edges_moves
    emitter_of_texels_moves
    emitter_on_black
    emitter_seen_by_reflection_moves
    emitter_turns_before_a_concave_mirror
    emitters_that_touch
    environment_light_moving_occluder
    environment_texel
    glass_ball_moves
    glossy_floor_reflects_a_moving_ball
    hard_shadow
    hard_shadow_in_a_mirror
    hard_shadow_in_a_mirror_ball
    hard_shadow_in_a_mirror_before_orthographic_sensor
    hard_shadow_of_a_point_light
    hard_shadow_on_a_moving_receiver
    image_of_a_projector
    index_of_refraction
    indirect_shadow
    instance_moves
    interpenetrating_meshes
    interreflection
    light_moves_before_a_curved_mirror
    mask_of_texels
    mask_silhouette
    mask_textured_leaf
    mesh_with_seams
    mirror_ball_moves
    normal_map_texel
    object_moves_before_orthographic_sensor
    object_moves_behind_a_glass_ball
    object_moves_between_two_mirrors
    object_moves_in_a_coarse_mirror
    object_moves_in_a_coated_ball
    object_moves_in_a_concave_mirror
    object_moves_in_a_curved_mirror
    object_moves_in_a_faceted_mirror
    object_moves_in_a_flat_and_a_curved_mirror
    object_moves_in_a_mirror_ball
    object_moves_in_a_planar_mirror
    object_moves_in_two_mirror_balls
    object_moves_inside_a_glass_ball
    object_moves_inside_a_glass_shell
    occluder_and_receiver_move_together
    open_mesh_moves
    orthographic_sensor_before_a_mirror_ball
    orthographic_sensor_turns
    point_light_moves
    principled_ball_moves
    radiance
    reflector_moves
    rough_balls_move
    rough_glass_ball_moves
    rough_plastic_ball_moves
    roughness
    screen_before_the_near_plane
    seam_of_tangents
    seam_of_texture_coordinates
    self_shadowing_right_angle
    shadow_in_a_perfect_mirror
    shadow_in_a_rough_mirror
    shadow_of_a_growing_occluder
    shadow_of_a_moving_occluder
    shadow_of_a_rotating_occluder
    shadow_on_the_back_of_a_screen
    shadow_receiver_moves
    shadow_through_a_glass_plate
    shadow_through_a_pane
    silhouette_with_a_box_filter
    silhouette_with_negative_lobes
    silhouette_with_negative_lobes_cut_off
    silhouette_with_the_border_sampled
    smooth_sphere_under_constant_light
    sphere_emitter_grows
    spot_light_moves
    sun_along_faces
    sun_turns
    surface_cut_by_the_near_plane
    texture_moves_in_a_mirror_ball
    texture_texel
    textured_emitter_moves
    textured_plane_moves
    thin_lens_before_a_mirror_ball
    two_occluders_cross
    vertex_of_a_closed_mesh
    vertex_of_a_glass_ball
    vertex_of_an_open_mesh
    wall_lit_past_a_hard_shadow
    weight_of_a_blend
}

#[test]
fn every_folder_is_listed() {
    let folders: Vec<String> = folder::all()
        .into_iter()
        .map(|folder| folder.name)
        .collect();
    assert_eq!(
        LISTED, folders,
        "`phenomena!` in this file, and the folders of tests/scenes"
    );
}

/// The list of the readme has each folder with the sentence of its scene.
#[test]
fn the_readme_has_every_sentence() {
    let readme = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/scenes/README.md");
    let readme = std::fs::read_to_string(readme).expect("a readme");
    let mut rows: Vec<&str> = readme
        .lines()
        .filter(|line| line.starts_with("| ["))
        .collect();
    rows.sort_unstable();
    let row = |folder: Folder| {
        let name = &folder.name;
        format!("| [{name}]({name}/scene.xml) | {} |", folder.sentence())
    };
    let expected: Vec<String> = folder::all().into_iter().map(row).collect();
    assert_eq!(rows, expected);
}

/// Does what the folder demands.
fn run(name: &str) {
    let started = Instant::now();
    let folder = Folder::new(name);
    let out = empty_folder(name);
    for check in folder.checks() {
        let parameter = &check.parameter;
        match &check.demand {
            Demand::Agree(differences) => {
                let reference = reference::reference(&folder, parameter, differences);
                if store::are_made() {
                    continue;
                }
                differences::agree(&folder, parameter, differences, &reference);
                gathered::agree(&folder, parameter, differences.edges, &reference);
                both_modes::agree(&folder, parameter, &out);
            }
            Demand::Refuse(words) => refuse(&folder, parameter, words, &out),
        }
    }
    println!("{name}: {:.1} s", started.elapsed().as_secs_f64());
}

/// `capwalk check` says of a silhouette and of a shadow that they are right, by differences of its
/// own.
#[test]
fn the_command_agrees() {
    for (name, parameter) in [
        ("silhouette_with_a_box_filter", "ball.translate.x"),
        ("shadow_of_a_moving_occluder", "thing.translate.x"),
    ] {
        let folder = Folder::new(name);
        let checks = folder.checks();
        let mut checks = checks.iter();
        assert!(checks.any(|check| check.parameter == parameter), "{name}");
        let file = folder.scene_file();
        let done = capwalk(&["check", &file, "-p", parameter, "--step", "0.003", "--json"]);
        assert_eq!(done.status, 0, "{name}: {}{}", done.output, done.errors);
        assert!(
            done.output.contains("\"step\": 0.003"),
            "{name}: {}",
            done.output
        );
    }
}

/// Demands that both modes refuse, and both methods, in a message that has the words.
fn refuse(folder: &Folder, parameter: &str, words: &[String], out: &Path) {
    let file = folder.scene_file();
    let target = out
        .join("target.exr")
        .to_str()
        .expect("plain letters")
        .to_owned();
    let image = capwalk(&["render", &file, "--spp", "1", "-o", &target]);
    let loss = ["--loss", "l2", "--target", &target];
    let gradient = ["gradient", &file, "-p", parameter];
    let mut commands = vec![
        gradient.to_vec(),
        [&gradient[..], &["--method", "edges"]].concat(),
    ];
    // What cannot be rendered has no target.
    if image.status == 0 {
        commands.push([&["backward", &file, "-p", parameter], &loss[..]].concat());
    }
    for command in commands {
        let done = capwalk(&command);
        assert_eq!(done.status, 3, "{command:?}: {}", done.output);
        for word in words {
            assert!(done.errors.contains(word), "{command:?}: {}", done.errors);
        }
    }
}

/// What a finished command left.
struct Finished {
    status: i32,
    output: String,
    errors: String,
}

/// Runs the built command.
fn capwalk(arguments: &[&str]) -> Finished {
    let mut command = Command::new(env!("CARGO_BIN_EXE_capwalk"));
    // A picture of a check is written where it runs.
    command.current_dir(env!("CARGO_TARGET_TMPDIR"));
    let done = command.args(arguments).output().expect("it starts");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
    Finished {
        status: done.status.code().unwrap_or(-1),
        output: text(done.stdout),
        errors: text(done.stderr),
    }
}

/// A folder for what commands write.
fn empty_folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("phenomena")
        .join(name);
    if folder.exists() {
        std::fs::remove_dir_all(&folder).expect("it is ours");
    }
    std::fs::create_dir_all(&folder).expect("the build folder is writable");
    folder
}
