//! What a tracer of pixels holds, and which random numbers it takes for what.

use std::sync::Arc;

use capwalk_boundary::{
    Accel, Boundaries, Draw, EdgeSampler, Field, Gathers, Motion, MovingBoundaries, Numbers,
    Viewpoint,
};
use capwalk_geometry::{EdgeSelection, EdgeSubset, Halt, Halted, uncounted};
use capwalk_math::{Real, Vec3};
use capwalk_scene::EmitterId;
use capwalk_walk::WalkSettings;

use crate::chain_survey::may_have_chains;
use crate::emitter_sampler::EmitterSampler;
use crate::motion_facts::MotionFacts;
use crate::options::Watch;
use crate::pixel::Supports;
use crate::plan::Plan;
use crate::prepared::PreparedScene;
use crate::sampled_edges::moves;
use crate::scene_eval::{SceneEval, Warped};

/// The numbers of gathered edges start here, behind all others: those of the
/// camera, then of each vertex.
pub const EDGE_NUMBERS: u32 = 1 << 30;
/// The numbers of edges before the environment start here, behind them: those of each vertex.
pub const ENVIRONMENT_EDGE_NUMBERS: u32 = 1 << 31;
/// The numbers of edges before area emitters that are too many to gather start here.
pub const WINDOW_EDGE_NUMBERS: u32 = 5 << 29;
/// The numbers of edges before other surfaces start here.
pub const INDIRECT_EDGE_NUMBERS: u32 = 3 << 30;
/// The numbers of edges that mirrors show start here.
pub const IMAGE_EDGE_NUMBERS: u32 = 7 << 29;
/// Which mirrors these are: a number for each vertex.
pub const IMAGE_NUMBERS: u32 = 15 << 28;

/// The most planes of mirrors behind which edges before other surfaces are gathered: at each vertex
/// those of one are sampled.
const MOST_SAMPLED_PLANES: usize = 16;

/// How directions are warped.
#[derive(Clone, Copy, Debug)]
pub struct Walks {
    /// On the film.
    pub camera: WalkSettings,
    /// Around surface points.
    pub surface: WalkSettings,
}

/// The fields of a scene that moves, and the walks that sample them.
#[derive(Clone, Copy)]
pub struct Moving<'a> {
    /// The fields.
    pub field: Field<'a>,
    /// The walks.
    pub walks: Walks,
}

/// The walks around surface points for directions towards other surfaces, for devices that walk
/// themselves.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceWalks {
    /// How they walk.
    pub settings: WalkSettings,
    /// The first random number at the vertex that the camera sees.
    pub first_number: u32,
    /// How many there are from one vertex to the next.
    pub numbers_per_vertex: u32,
    /// The most specular events behind which edges count there; at later vertices fewer if paths
    /// are short ([`Plan::events_behind`]).
    pub events: u32,
}

/// Samples pixels of a scene.
pub struct Tracer<'a> {
    /// The scene.
    pub accel: &'a Accel,
    /// How its emitters are sampled.
    pub emitters: &'a [EmitterSampler],
    /// The supports of its pixels.
    pub supports: Supports,
    /// Which paths are sampled.
    pub plan: Plan,
    /// Along which of their segments edges are gathered.
    pub gathers: Gathers,
    /// How directions move; not needed for the primal image.
    pub moving: Option<Moving<'a>>,
    /// True if silhouettes that are seen by way of curved mirrors or glass are in fields along the chains of
    /// specular events there.
    pub has_chains: bool,
    /// What is known of the motion.
    pub facts: Arc<MotionFacts>,
}

impl<'a> Tracer<'a> {
    /// A tracer of the primal image alone.
    pub fn primal(prepared: &'a PreparedScene) -> Self {
        let scene = prepared.scene();
        Self {
            accel: prepared.accel(),
            emitters: prepared.emitters(),
            supports: Supports::new(&scene.film),
            plan: Plan::new(scene),
            gathers: Gathers::NONE,
            moving: None,
            has_chains: false,
            facts: Arc::default(),
        }
    }

    /// A tracer of derivatives, too, with the given walk around surfaces. The facts are of the
    /// motion by which it is asked for derivatives.
    pub fn moving(
        prepared: &'a PreparedScene,
        field: Field<'a>,
        surface: WalkSettings,
        facts: &Arc<MotionFacts>,
    ) -> Self {
        let camera = WalkSettings {
            max_radius: surface.max_radius.min(camera_angle(prepared.accel())),
            ..surface
        };
        let walks = Walks { camera, surface };
        let tracer = Self {
            has_chains: field.method.traits().is_spherical
                && facts.turns_light()
                && may_have_chains(prepared.accel()),
            moving: Some(Moving { field, walks }),
            facts: Arc::clone(facts),
            ..Self::primal(prepared)
        };
        Self {
            gathers: field.method.traits().gathers.within(tracer.can_gather()),
            ..tracer
        }
    }

    /// This tracer with another plan, which reaches no farther; where edges are gathered stays.
    pub fn with_plan(self, plan: Plan) -> Self {
        Self { plan, ..self }
    }

    /// The most specular events behind which edges are boundaries.
    pub(crate) fn events_behind(&self, segments: u32) -> u32 {
        match self.accel.has_flat_events() {
            true => self.plan.events_behind(segments),
            false => 0,
        }
    }

    /// True if paths lead from surfaces over flat mirrors or through panes.
    pub fn shows_surfaces_mirrors(&self) -> bool {
        self.plan.reaches(3) && self.events_behind(1) > 0
    }

    /// True if directions towards an emitter do not move, and edges in front of it are gathered.
    pub(crate) fn gathers(&self, emitter: EmitterId) -> bool {
        let scene = &self.accel.scene;
        match scene.environment() == Some(emitter) {
            true => self.gathers.environment,
            false => self.gathers.emitters && scene.emitter(emitter).shape().is_some(),
        }
    }

    /// The segments along which edges could be gathered in this scene.
    pub fn can_gather(&self) -> Gathers {
        let has_few_mirrors = || {
            let planes = self.accel.mirror_planes();
            planes.is_some_and(|planes| planes.count() <= MOST_SAMPLED_PLANES)
        };
        Gathers {
            // With perspective rays, and no more flat mirrors than images can be made by.
            camera: !self.accel.view.is_parallel()
                && (self.events_behind(0) == 0 || self.accel.mirror_planes().is_some()),
            emitters: self.plan.lights_surfaces() && self.has_area_emitters(),
            environment: self.plan.lights_surfaces() && self.has_environment(),
            indirect: self.plan.reaches(3) && (self.events_behind(1) == 0 || has_few_mirrors()),
            ..Gathers::ALL
        }
    }

    /// True if directions from surfaces move along fields where edges are gathered along
    /// these segments.
    pub fn walks_around_surfaces(&self, gathers: Gathers) -> bool {
        self.plan.lights_surfaces()
            && (self.has_area_emitters() && !gathers.emitters
                || self.has_environment() && !gathers.environment
                || self.plan.reaches(3) && !gathers.indirect)
    }

    /// The walks towards surfaces, if directions to them move along fields.
    pub fn surface_walks(&self) -> Option<SurfaceWalks> {
        let settings = self.moving.as_ref()?.walks.surface;
        let first = |depth| self.emitter_edge_number(depth) + 1 + settings.dimensions();
        let walks = self.plan.reaches(3) && !self.gathers.indirect;
        walks.then(|| SurfaceWalks {
            settings,
            first_number: first(0),
            numbers_per_vertex: first(1) - first(0),
            events: self.events_behind(1),
        })
    }

    /// Builds the edge samplers that samples will ask for, unless the watch stops it: within the
    /// first sample nothing would.
    pub fn build_edge_samplers(&self, watch: &dyn Watch) -> Result<(), Halted> {
        let Some(Moving { field, .. }) = &self.moving else {
            return Ok(());
        };
        let should_stop = || watch.should_stop();
        let halt = Halt::when(&should_stop);
        let environment = self.gathers.environment && self.has_environment();
        let wanted = [
            (
                EdgeSelection::Silhouettes,
                environment && self.plan.lights_surfaces(),
            ),
            (
                EdgeSelection::All,
                self.gathers.indirect && self.plan.reaches(3),
            ),
        ];
        for (selection, _) in wanted.into_iter().filter(|(_, is_wanted)| *is_wanted) {
            (field.boundaries).build_edge_sampler(self.accel, selection, &halt)?;
        }
        Ok(())
    }

    /// A sampler of edges, and the motions of its nodes.
    pub(crate) fn sampled_edges<R: Real, W: SceneEval<R>>(
        &self,
        boundaries: &'a Boundaries,
        eval: &W,
        selection: EdgeSelection,
    ) -> (&'a EdgeSampler, &[Motion]) {
        let sampler = boundaries.edge_sampler(self.accel, selection);
        let motions = || sampler.motions(|point| eval.motion_of_point(point));
        (
            sampler,
            self.facts.edge_motions[selection as usize].get_or_init(motions),
        )
    }

    /// All edges but those that certainly do not move.
    pub(crate) fn moving_edges<R: Real, W: SceneEval<R>>(
        &self,
        boundaries: &Boundaries,
        eval: &W,
    ) -> &EdgeSubset {
        let subset = || boundaries.subset(|edge| moves(eval, boundaries, edge));
        let known = &self.facts.moving_edges;
        known.get_or_init(|| uncounted(subset))
    }

    /// False if certainly no flat mirror moves.
    fn mirrors_move<R: Real, W: SceneEval<R>>(&self, eval: &W) -> bool {
        let moves = |face: &[u32; 3]| face.iter().any(|&i| !eval.motion_of_point(i).is_still());
        let any_moves = || {
            let faces = self.accel.mesh.faces.iter().zip(&self.accel.shape_of_face);
            let mut mirrors = faces.filter(|(_, shape)| self.accel.is_flat_mirror(**shape));
            mirrors.any(|(face, _)| moves(face))
        };
        *self.facts.mirrors_move.get_or_init(any_moves)
    }

    /// A direction from a surface point that moves along the field there.
    pub(crate) fn warp<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        viewpoint: &Viewpoint<R>,
        q: Vec3,
        (walk, numbers): (&WalkSettings, Numbers),
    ) -> Warped<R> {
        match self.is_out_of_reach(eval, viewpoint, q, walk) {
            true => Warped::still(q),
            false => eval.warp(viewpoint, q, walk, numbers),
        }
    }

    /// [`Self::warp`] without the divergence.
    pub(crate) fn warp_value<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        viewpoint: &Viewpoint<R>,
        q: Vec3,
        (walk, numbers): (&WalkSettings, Numbers),
    ) -> Vec3<R> {
        match self.is_out_of_reach(eval, viewpoint, q, walk) {
            true => Vec3::constant(q),
            false => eval.warp_value(viewpoint, q, walk, numbers),
        }
    }

    /// True if the direction `q` certainly stays, for the viewpoint does and all edges to which walks come from
    /// there: in a room where one thing moves, most are far from it. One question among few edges spares several
    /// among all.
    fn is_out_of_reach<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        viewpoint: &Viewpoint<R>,
        q: Vec3,
        walk: &WalkSettings,
    ) -> bool {
        let Some(Moving { field, .. }) = &self.moving else {
            return false;
        };
        if !W::MOVES || !viewpoint.is_constant() || eval.is_still(viewpoint) {
            return false;
        }
        let moving = MovingBoundaries {
            edges: self.moving_edges(field.boundaries, eval),
            mirrors: self.mirrors_move(eval),
        };
        !field.reaches(viewpoint, q, walk, moving)
    }

    /// How much the motion differs within each plane of flat mirrors.
    pub(crate) fn mirror_spreads<R: Real, W: SceneEval<R>>(&self, eval: &W) -> &[f64] {
        self.facts.mirror_spreads.get_or_init(|| {
            let motion = |vertex| eval.motion_of_point(vertex);
            let planes = self.accel.mirror_planes();
            planes.map_or(Vec::new(), |planes| {
                planes.spreads(&self.accel.mesh, motion)
            })
        })
    }

    fn has_environment(&self) -> bool {
        self.accel.scene.environment().is_some()
    }

    fn has_area_emitters(&self) -> bool {
        let mut emitters = self.accel.scene.emitters.iter();
        emitters.any(|emitter| emitter.shape().is_some())
    }

    /// Two numbers for a place on the border of a pixel; behind them those of
    /// three walks: at a film point, opposite to it, at the border.
    pub(crate) fn film_numbers(&self) -> u32 {
        self.plan.first_walk()
    }

    /// The numbers of the `k`-th walk on the film.
    pub(crate) fn film_walk<'d>(&self, k: u32, draw: Draw<'d>) -> (&WalkSettings, Numbers<'d>) {
        let walk = &self.walks().camera;
        let dimension = self.film_numbers() + 2 + k * walk.dimensions();
        (walk, Numbers { draw, dimension })
    }

    /// The number for a place on the emitters' edges; behind it those of walks:
    /// there, towards the next surface, and for each light sample.
    pub(crate) fn emitter_edge_number(&self, depth: u32) -> u32 {
        let walks = self.walks();
        let film = self.film_numbers() + 2 + 3 * walks.camera.dimensions();
        let sampling = self.plan.sampling;
        let samples = sampling.emitter_samples + sampling.bsdf_samples;
        film + depth * (1 + (2 + samples) * walks.surface.dimensions())
    }

    /// The numbers of the `k`-th walk around a vertex.
    pub(crate) fn vertex_walk<'d>(
        &self,
        depth: u32,
        k: u32,
        draw: Draw<'d>,
    ) -> (&WalkSettings, Numbers<'d>) {
        let Some(Moving { walks, .. }) = &self.moving else {
            // The primal image has no walks.
            return (&NO_WALK, Numbers { draw, dimension: 0 });
        };
        let walk = &walks.surface;
        let dimension = self.emitter_edge_number(depth) + 1 + k * walk.dimensions();
        (walk, Numbers { draw, dimension })
    }

    fn walks(&self) -> &Walks {
        let moving = self.moving.as_ref();
        &moving.expect("only scenes that move are walked in").walks
    }
}

/// Angular cutoff of the camera's field, in pixels: farther than this from every boundary,
/// film points do not move. A larger cutoff moves pixels without need and makes their
/// derivatives noisy; one below a pixel gives a steep field. Two pixels measured best on
/// the built-in scenes.
const CAMERA_PIXELS: f64 = 2.0;

/// [`CAMERA_PIXELS`] as an angle, radians, in the middle of the film.
fn camera_angle(accel: &Accel) -> f64 {
    (CAMERA_PIXELS * accel.view.pixel_size()).atan()
}

const NO_WALK: WalkSettings = WalkSettings {
    steps: 0,
    max_radius: 0.0,
    estimator: capwalk_walk::Estimator::Anchored,
    antithetic: false,
};

#[cfg(test)]
mod tests {
    use capwalk_boundary::Method;
    use capwalk_math::{Affine, Rgb, Vec3};
    use capwalk_scene::lobe::Conductor;
    use capwalk_scene::primitive::rectangle;
    use capwalk_scene::{BsdfId, Integrator, Material, Shape, Texture, builtin};

    use super::*;

    /// Edges that surfaces see in many flat mirrors are not sampled: there it walks, but not before
    /// the camera.
    #[test]
    fn light_by_way_of_many_mirrors_is_walked() {
        let many = 1 + MOST_SAMPLED_PLANES;
        for (mirrors, max_depth) in [(0, 4), (1, 4), (many, 4), (many, 2)] {
            let mut scene = builtin::scene("leaf").expect("built in");
            scene.settings.integrator = Integrator::Path {
                max_depth: Some(max_depth),
                rr_depth: 5,
                hide_emitters: false,
            };
            if mirrors > 0 {
                let colour = |id: &str, grey: f64| Texture::colour(id, Rgb::splat(grey));
                let k = scene.add_texture(colour("k", 1.0));
                let eta = scene.add_texture(colour("eta", 0.0));
                let metal = Conductor {
                    eta,
                    k,
                    specular_reflectance: k,
                };
                scene.materials.push(Material {
                    id: "metal".into(),
                    bsdf: metal.into(),
                });
                let id = BsdfId(scene.materials.len() as u32 - 1);
                for i in 0..mirrors {
                    let place = Affine::translate(Vec3::new(0.0, 0.0, -3.0 - i as f64));
                    let (mesh, normals) = rectangle(place);
                    scene.add_shape(Shape::new(format!("mirror{i}"), mesh, normals, id));
                }
            }
            let prepared = PreparedScene::new(scene);
            let field = Field::new(prepared.accel(), prepared.boundaries(), Method::EDGES);
            let tracer = Tracer::moving(&prepared, field, NO_WALK, &Arc::default());
            let expected = mirrors < many && max_depth > 2;
            assert_eq!(tracer.gathers.indirect, expected);
            assert!(tracer.gathers.camera);
        }
    }
}
