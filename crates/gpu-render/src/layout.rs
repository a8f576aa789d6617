//! What the CPU writes and the kernels read: kinds, which word of a record is what, and limits of both. Declared
//! once, here; the kernels include it as `layout.slang`, which `cargo xtask kernels` writes.

use capwalk_boundary::{Field, GOLDEN, Gathers, MANY_CORNERS, MAX_EVENTS, MIXERS, PARALLEL};
use capwalk_gpu::slang_constants;
use capwalk_math::frame::POINTS_DOWN;
use capwalk_math::rgb::LUMINANCE;
use capwalk_render::constants::*;
use capwalk_scene::lobe as lobes;

slang_constants! {
    fn whole_numbers: usize, "static const uint {} = {}u;\n";

    /// Words of the header: numbers of the plan, then where the arrays of records start; and where in `primitives` the camera's
    /// numbers start, which follow the triangles, and those of the tests, behind them.
    header {
        MAX_DEPTH = 0, RR_DEPTH = 1, EMITTER_SAMPLES = 2, BSDF_SAMPLES = 3, SEES_EMITTERS = 4, ALIKE = 5,
        EMITTERS = 6, FIRST_VERTEX = 7, ENVIRONMENT = 8,
        TRIANGLES_AT = 9, SHAPES_AT = 10, EMITTERS_AT = 11, TRIANGLE_OF_FACE_AT = 12, CAMERA_AT = 13,
        CAMERA_NUMBERS_AT = 14, NUMBERS_AT = 15, HEADER = 16,
    }

    /// Of a triangle, in the order of the tree's leaves: its shape, and face and vertices there.
    triangle {
        TRIANGLE_RECORD = 5,
    }

    /// Words of a shape: where its normals and texture coordinates are, the materials of its front and its back (`NONE` if it
    /// reflects nothing), its emitter, where the tangents of its faces are, if its material turns with them, and whether it is a
    /// flat mirror.
    shape {
        NORMALS = 0, UVS = 1, FRONT = 2, BACK = 3, EMITTER = 4, TANGENTS = 5, IS_MIRROR = 6, SHAPE_RECORD = 7,
    }

    /// Numbers of the tests, the distance around a point of a surface in which nothing counts, and the part of the way to an
    /// emitter that does.
    tests {
        EDGE_ON = 0, LARGEST = 1, SELF_DISTANCE = 2, SHORT_OF_TARGET = 3, TESTS = 4,
    }

    /// Kinds of textures.
    texture_kind {
        CONSTANT = 0, BITMAP = 1, CHECKERBOARD = 2, PER_VERTEX = 3, PER_FACE = 4,
    }

    /// Words of a texture: its kind comes first, its texels are last.
    texture {
        CHANNELS = 1, WIDTH = 2, HEIGHT = 3, IS_BILINEAR = 4, WRAP = 5, TO_UV = 6, NUMBER = 18, TEXELS = 19,
    }

    /// What continues a bitmap.
    wrap {
        REPEAT = 0, MIRROR = 1, CLAMP = 2,
    }

    /// Words of the camera: columns and pixels of the image, the filter and two numbers of it, whether there is a lens, and of
    /// each column, then of each row, where its table is.
    camera {
        IMAGE_COLUMNS = 0, IMAGE_PIXELS = 1, FILTER = 2, FILTER_NUMBERS = 3, HAS_LENS = 5, SIDES = 6,
    }

    /// Numbers of a column's or a row's table: where it starts, from its pixels' centre; the width of a bin; that over the
    /// filter's integral; then of all bins the probabilities of those below, and their own.
    side_table {
        BIN_WIDTH = 1, OVER_INTEGRAL = 2, BELOW = 3, BINS = capwalk_render::constants::BINS,
    }

    /// Words of the samples that paths begin with: the seed, and pixel and number of the first one.
    sample {
        SEED = 0, FIRST_PIXEL = 2, FIRST_NUMBER = 3, SAMPLE_WORDS = 4,
    }

    /// Kinds of filters.
    filter {
        BOX_FILTER = 0, TENT_FILTER = 1, GAUSSIAN_FILTER = 2, MITCHELL_FILTER = 3, LANCZOS_FILTER = 4,
    }

    /// Numbers of the camera in `Real`: five vectors of directions and five of starts; the film point of the view axis, from the
    /// first pixel's centre; depths of the clip planes, from that of the starts; and that depth. Behind them are tables.
    camera_numbers {
        DIRECTIONS = 0, STARTS = 15, AXIS_POINT = 30, CLIP = 32, START_DEPTH = 34, SIDE_TABLES = 35,
    }

    /// Words of an emitter: what it is, the texture of its radiance, or its map, its brightness, its first face, where its
    /// rectangle (or `NONE`) and the nodes of its tree are, the order of its triangles in the leaves and the place of each in that
    /// order, and a ball around it.
    emitter {
        EMITTER_KIND = 0, RADIANCE = 1, BRIGHTNESS = 2, FIRST_FACE = 3, RECTANGLE = 4,
        NODES = 5, ORDER = 6, RANK = 7, CENTRE = 8, RADIUS = 11, EMITTER_RECORD = 12,
    }

    /// An area emitter, light from everywhere, or a map of it.
    emitter_kind {
        AREA_EMITTER = 0, CONSTANT_EMITTER = 1, ENVIRONMENT_MAP = 2,
    }

    /// Words of a node of an emitter's tree: the first of its places in the order and the one after the last, its halves or
    /// `NONE`, a ball, its areas, and a cone of its normals.
    emitter_node {
        NODE = 17,
    }

    /// Words of an environment map: texels per row and rows; the rows of the rotation from the map's directions to the world's;
    /// the records of the textures of its texels and of a factor on them; where the table is (`NONE` if the map is black): the sums
    /// of the cells' chances up to each row, then within each row, and the density per solid angle at each texel.
    environment_map {
        MAP_WIDTH = 0, MAP_HEIGHT = 1, WORLD_FROM_MAP = 2, MAP_TEXELS = 11, MAP_SCALE = 12,
        ROW_SUMS = 13, CELL_SUMS = 14, DENSITIES = 15, ENVIRONMENT_RECORD = 16,
    }

    /// What a side of a surface does to light.
    lobe_kind {
        DIFFUSE = 0, CONDUCTOR = 1, ROUGH_CONDUCTOR = 2, PLASTIC = 3, ROUGH_PLASTIC = 4,
    }

    /// Words of a lobe: its kind comes first; the distribution of its facets, whether light takes the colour of the base each
    /// time it gets there, what passes its rough coat, how many textures there may be, and these.
    lobe {
        DISTRIBUTION = 1, IS_NONLINEAR = 2, COAT = 3, SLOTS = 4, FIRST_SLOT = 5,
    }

    /// Of a rough coat: what passes, for so many cosines from 0 to 1, and the fraction of diffuse light from inside that does not.
    coat {
        COSINES = lobes::NODES, INTERNAL_REFLECTANCE = COSINES, COAT_NUMBERS = INTERNAL_REFLECTANCE + 1,
    }

    /// Textures of a lobe (`NONE` for one that is not there): the colours of base and mirror, the refractive indices (of a metal
    /// its real and imaginary part, of a coat that inside and outside), and the roughnesses.
    slot {
        DIFFUSE_REFLECTANCE = 0, SPECULAR_REFLECTANCE = 1, INDEX = 2, SECOND_INDEX = 3, ALPHA_U = 4, ALPHA_V = 5,
    }

    /// Distributions of facets.
    distribution {
        BECKMANN = 0, GGX = 1,
    }

    /// Words behind the list of paths: where the motion of the triangles is, or in reverse mode what is asked for of the shapes'
    /// vertices (`NONE` if nothing moves); whether boundaries move; in reverse mode how many units of a sum are one; where the edges
    /// are that paths cross; whether sampling may not know how fast these move, as in reverse mode; where the changes of the
    /// camera's vectors are, or in reverse mode the derivatives of the loss with respect to the pixels; whether directions to
    /// surfaces move along a field; then of each texture where its own numbers are (`NONE` if none is asked for).
    change {
        MOTION_AT = 0, BOUNDARIES_MOVE = 1, UNITS = 2, EDGES_AT = 3, IS_BLIND = 4,
        CAMERA_CHANGE_AT = 5, ADJOINT_AT = 5, WALKS = 6, TEXTURE_CHANGES = 7,
    }

    /// Words before the sums: how many derivatives were too large for a sum and how many not finite, in how many threads loops
    /// were cut short, and in how many parts the edges before emitters are to be taken, if not in one.
    fault {
        TOO_LARGE = 0, NOT_FINITE = 1, THREADS_CUT_SHORT = 2, PARTS = 3, SUMS = 4,
    }

    /// Of a sum of derivatives.
    sum {
        SUM_WORDS = 4,
    }

    /// Numbers of the motion of a triangle: how its corners move, their given normals, and the tangent of its face.
    motion {
        CORNER_NORMALS = 9, FACE_TANGENT = 18, MOTION = 21,
    }

    /// Words of a hit: the number of its face, or `NONE`; weights of the face's second and third corner, each in two numbers of
    /// single precision, the direction of the ray with what is left of it beside single precision, and the key of the path's
    /// random numbers.
    hit {
        HIT_FACE = 0, HIT_WEIGHTS = 1, HIT_DIRECTION = 5, HIT_DIRECTION_REST = 8, HIT_KEY = 11, HIT_WORDS = 13,
    }

    /// Words of a path: of an image, behind the list; with derivatives also that of its light, and what walks tell.
    path {
        SIDE_WEIGHT = 20, SIDE_POINT = SIDE_WEIGHT + 3, LIGHT_CHANGE = 4, WALKED = 29, FORWARD_PATH = WALKED + 4,
    }

    /// Words of a path in reverse mode: what is behind the vertex that is taken back, the light that arrives from there and the
    /// derivatives with respect to the ray; those with respect to the camera's ray by way of what emits there, and how far away
    /// that is; and what is kept of each vertex, of which the derivatives with respect to the ray that led to it.
    reverse_path {
        BEYOND = 17, CAMERA_BACK = BEYOND + 3, CAMERA_RAY = 26, KEPT = 33, KEPT_WORDS = 29,
        KEPT_PLACE = 3, KEPT_DIRECT = 11, KEPT_WO = 17, KEPT_BY_RAY = 20,
    }

    /// Words of the header of edges: where the trees of silhouettes and of all edges are (`NONE` if not needed), then those of
    /// the edges among them that move, which of the two has the edges before area emitters, and where the windows of emitters
    /// are; of walks the first random number at the vertex that the camera sees, how many each vertex has, and in how many mirrors
    /// edges count; of how many leaves before an emitter a launch looks at the edges, and how many points it takes there at most; and
    /// of the tree that walks search (`SilhouetteBuffers`) where its nodes, the starts of its leaves, and for each of its edges the
    /// place among all edges are.
    edges {
        SILHOUETTES = 0, ALL_EDGES = 1, OF_MOVING = 2, BEFORE_EMITTERS = 4, WINDOWS = 5,
        FIRST_WALK = 6, WALK_NUMBERS = 7, MIRRORS = 8, MOST_LEAVES = 9, MOST_POINTS = 10,
        SEARCHED_NODES = 11, SEARCHED_LEAVES = 12, SEARCHED_EDGES = 13, EDGES_HEADER = 14,
    }

    /// Numbers of edges behind those of the tests: within this fraction of all coordinates a point is in a plane; of how far the
    /// world's origin is away, local units; what of an edge is outside of a window by less than this, over its distance, is inside;
    /// the angle between an edge and the rays beside it; the tangents of half the largest angle of a cap, and of twice as much;
    /// and the frame of the tree that walks search: its centre, and its units per local unit.
    edge_tests {
        ON_PLANE = 0, AWAY = 1, IN_PLANE = 2, BESIDE = 3, CAP = 4, TWICE_CAP = 5, SEARCHED_CENTRE = 6, SEARCHED_SCALE = 9,
    }

    /// Words of a node: its second half (the first one is the next node), or `NONE` in a leaf, the node after all that are below
    /// it, the first edge and the one after the last, a ball around them, the cone of normals, the distance of planes of faces from
    /// the centre, length, reach, the least radius, the motion, and shares of length by direction.
    edge_node {
        EDGE_NODE = 45, CENTRE_OF_NODE = 4, RADIUS_OF_NODE = 7, NORMAL_AXIS = 8, NORMAL_SINE = 11, NORMAL_COSINE = 12,
        PLANE_HEIGHT = 13, LENGTH = 14, REACH = 15, LEAST_RADIUS = 16, VELOCITY = 17, SPREAD = 20, SHARES = 21,
    }

    /// Words of an edge: factors of its sampling weight, velocities of its ends (in reverse mode the first two of these words are
    /// where the sums of its ends start, `NONE` if they are not asked for), where the list of those that may lie on it starts and
    /// ends, how fast it moves where sampling does not know, and its number in the scene. Its numbers are the ends, normals of its
    /// faces, and their lengths.
    edge {
        EDGE_RECORD = 12, VELOCITIES = 2, OVERLAPS = 8, LIKELY_SPEED = 10, NUMBER_IN_SCENE = 11, EDGE_NUMBERS = 14,
    }

    /// Words of a tree of edges: where its nodes and edges are, and where the numbers of its edges are.
    tree {
        TREE_NODES = 0, TREE_EDGES = 1, TREE_NUMBERS = 2,
    }

    /// Subtrees that are sampled at the vertex that the camera sees, and at later ones, which matter less; and the bits of the
    /// depth of a launch, behind which is its part.
    launch {
        FIRST_SUBTREES = subtree_count(0, false) as usize, LATER_SUBTREES = subtree_count(1, false) as usize, DEPTH_BITS = 16,
    }

    /// Random numbers of the film point and of the point of the lens, those of a point on an emitter, and of a direction from a
    /// material, and of edges, which start at a multiple of this for what each is before.
    random {
        FILM = capwalk_render::constants::FILM as usize, LENS = capwalk_render::constants::LENS as usize,
        EMITTER_NUMBERS = capwalk_render::constants::EMITTER_NUMBERS as usize,
        BSDF_NUMBERS = capwalk_render::constants::BSDF_NUMBERS as usize,
        PURPOSE_NUMBERS = EDGE_NUMBERS as usize,
    }

    /// The increment and the factors of the random numbers, each in two words, the lower one first.
    split_mix {
        INCREMENT = GOLDEN as u32 as usize, INCREMENT_HIGH = (GOLDEN >> 32) as usize,
        FIRST_FACTOR = MIXERS[0] as u32 as usize, FIRST_FACTOR_HIGH = (MIXERS[0] >> 32) as usize,
        SECOND_FACTOR = MIXERS[1] as u32 as usize, SECOND_FACTOR_HIGH = (MIXERS[1] >> 32) as usize,
    }

    /// Corners of a window at most; more emitters are chosen alike; and one of so many directions to an environment map is drawn
    /// uniformly.
    many {
        WINDOW_CORNERS = MANY_CORNERS, MANY = MANY_EMITTERS, SKY_PARTS = (1.0 / UNIFORM_SKY) as usize,
    }

    /// Most mirrors between a vertex and an edge.
    limit {
        MOST_MIRRORS = MAX_EVENTS as usize,
    }
}

slang_constants! {
    fn numbers: f64, "static const float {} = {:e};\n";

    /// Shares of the channels in the luminance.
    luminance {
        RED_SHARE = LUMINANCE.r, GREEN_SHARE = LUMINANCE.g, BLUE_SHARE = LUMINANCE.b,
    }

    /// The frame around a normal turns over where its z passes this.
    frame {
        DOWNWARDS = POINTS_DOWN,
    }

    /// The sine of the height over the horizon from which on all of a boundary's motion counts, and the part of their length that
    /// edges seen end-on seem to have at most.
    field {
        LOW = Field::LOW, END_ON = Field::END_ON,
    }

    /// Largest probability that a path survives roulette, and the smallest one for derivatives: a path that carries no light may
    /// carry a derivative, such as that of a black material's reflectance.
    roulette {
        MOST_SURVIVAL = RR_MAX, LEAST_SURVIVAL_MOVING = RR_MIN,
    }

    /// Share of the choices that do not depend on how bright emitters are; and the largest solid angle of an emitter of which
    /// points alone are sampled at diffuse surfaces.
    emitter_choice {
        UNIFORM = UNIFORM_EMITTERS, NARROW = capwalk_render::constants::NARROW,
    }

    /// From how far away rectangles are sampled as such, how steep densities on them are at most, and the least squared cosine
    /// at the surface that these follow.
    far_rectangle {
        FAR = capwalk_render::constants::FAR, MOST_TILT = capwalk_render::constants::MOST_TILT,
        LEAST_COSINE2 = capwalk_render::constants::LEAST_COSINE2,
    }

    /// Where the error function is one to the last digit of double precision, the smallest roughness, and the least weight of base
    /// and coat: what is black is sampled a little.
    facets {
        SHADOWLESS = lobes::SHADOWLESS, MIN_ALPHA = lobes::MIN_ALPHA, LEAST_WEIGHT = lobes::LEAST_WEIGHT,
    }

    /// Length of the longest piece of an edge that has one sampling weight, at diffuse surfaces and others, radians; the most
    /// pieces of an edge; and the share of the mean that is added to what a piece contributes at its middle.
    piece {
        DIFFUSE_PIECE = capwalk_render::constants::DIFFUSE_PIECE, PIECE = capwalk_render::constants::PIECE,
        MOST_PIECES = capwalk_render::constants::MOST_PIECES, LEAST_SHARE = capwalk_render::constants::LEAST_WEIGHT,
    }

    /// Points before an emitter, times the root of the number of pieces, at least: where there are many, they differ more. 1 over
    /// the golden ratio: its multiples are spread evenly between whole numbers. Lines with a larger cosine are parallel.
    points {
        POINTS_BEFORE_EMITTERS = Gathers::POINTS as f64, LEAST_ROOT = ROOTS[0], EVENLY = SPREAD, PARALLEL_COSINE = 1.0 - PARALLEL,
    }

    /// How far, per mirror and over the distance, a path to a point may miss it and still arrive: neighbouring faces of a mirror
    /// may differ by as much.
    mirror {
        SAME_MIRROR = capwalk_boundary::SAME_MIRROR,
    }

    /// No derivative is larger, in units of a sum: then 2^24 of them have a sum.
    sum_limit {
        LARGEST_DERIVATIVE = (1_u128 << 86) as f64,
    }
}

/// The kind of lobe that a material's plugin is to the kernels; `None` if they have no such lobe.
pub fn kind_of_plugin(plugin: &str) -> Option<usize> {
    use lobe_kind::*;
    Some(match plugin {
        "diffuse" => DIFFUSE,
        "conductor" => CONDUCTOR,
        "roughconductor" => ROUGH_CONDUCTOR,
        "plastic" => PLASTIC,
        "roughplastic" => ROUGH_PLASTIC,
        _ => return None,
    })
}

/// The places in a lobe of a material's texture of this name.
pub fn places_of_name(name: &str) -> &'static [usize] {
    use slot::*;
    match name {
        "reflectance" | "diffuse_reflectance" => &[DIFFUSE_REFLECTANCE],
        "specular_reflectance" => &[SPECULAR_REFLECTANCE],
        "eta" | "int_ior" => &[INDEX],
        "k" | "ext_ior" => &[SECOND_INDEX],
        "alpha" => &[ALPHA_U, ALPHA_V],
        "alpha_u" => &[ALPHA_U],
        "alpha_v" => &[ALPHA_V],
        other => unreachable!("no lobe of the kernels has {other}"),
    }
}

/// `layout.slang`.
pub fn slang() -> String {
    format!(
        "// `layout.rs` of `capwalk-gpu-render` as Slang.\n{}{}",
        whole_numbers(),
        numbers()
    )
}

/// A record of so many words, each of which must be given once, by its place.
pub fn record<const N: usize>(words: &[(usize, u32)]) -> [u32; N] {
    let mut record = [None; N];
    for &(place, word) in words {
        let before = record[place].replace(word);
        assert!(before.is_none(), "word {place} is given twice");
    }
    record.map(|word| word.expect("each word is given"))
}
