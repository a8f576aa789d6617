"""Images that JAX differentiates."""

from __future__ import annotations

import doctest
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import capwalk as cw
import numpy as np
import pytest

jax = pytest.importorskip("jax")
jnp = jax.numpy

import capwalk.jax  # noqa: E402

# To compare bits.
jax.config.update("jax_enable_x64", True)

LEAF = "leaf.positions"
FLOOR = "floor.bsdf.reflectance.value"
NAMES = (LEAF, FLOOR)
SEED = 5
# The seed that derivatives have by default.
SEED_GRAD = 2**64 - 1 - SEED
ADJOINT = np.random.default_rng(1).normal(size=(9, 12, 3))


@pytest.fixture
def leaf() -> cw.Scene:
    """A leaf, the shadow that it casts, and 12 x 9 pixels."""
    scene = cw.load_file("leaf")
    scene.resize(12, 9)
    return scene


def values(scene: cw.Scene) -> tuple[jax.Array, jax.Array]:
    return jnp.asarray(cw.traverse(scene)[LEAF]), jnp.asarray(cw.traverse(scene)[FLOOR])


def rendered(scene: cw.Scene, *values: jax.Array, **options: Any) -> jax.Array:
    options = {"spp": 4, "seed": SEED, **options}
    return capwalk.jax.render(scene, dict(zip(NAMES, values)), **options)


def same(one: Any, other: Any) -> bool:
    leaves = zip(jax.tree.leaves(one), jax.tree.leaves(other), strict=True)
    return all(np.array_equal(a, b) for a, b in leaves)


@pytest.mark.parametrize("jit", [lambda f: f, jax.jit])
def test_modes_are_those_of_the_library(leaf: cw.Scene, jit: Any) -> None:
    def image(*values: jax.Array) -> jax.Array:
        return rendered(leaf, *values)

    def loss(*values: jax.Array) -> jax.Array:
        return (image(*values) * ADJOINT).sum()

    point = values(leaf)
    found = jit(image)(*point)
    assert found.shape == (9, 12, 3) and found.dtype == jnp.float64
    assert same(found, cw.render(leaf, spp=4, seed=SEED).value)
    expected = cw.backward(leaf, ADJOINT, NAMES, spp=4, seed=SEED_GRAD)
    assert same(jit(jax.grad(loss, (0, 1)))(*point), tuple(expected[name] for name in NAMES))
    # Only what is asked for: with another method for it, other bits.
    (colour,) = cw.backward(leaf, ADJOINT, [FLOOR], spp=4, seed=SEED_GRAD).values()
    assert same(jit(jax.grad(loss, 1))(*point), colour)
    derivative = cw.gradient(leaf, "leaf.translate.x", spp=4, seed=SEED_GRAD).gradient
    velocity = jnp.zeros((3, 3)).at[:, 0].set(1)

    def pushed(positions: jax.Array, velocity: jax.Array) -> jax.Array:
        return jax.jvp(lambda p: image(p, point[1]), (positions,), (velocity,))

    assert same(jit(pushed)(point[0], velocity), (found, derivative))
    assert not jit(pushed)(point[0], 0 * velocity)[1].any()
    _, linear = jax.linearize(lambda p: image(p, point[1]), point[0])
    assert same(linear(velocity), derivative)


def test_forward_is_reverse(leaf: cw.Scene) -> None:
    """And both are linear, so that either can be transposed."""
    point = values(leaf)
    velocities = tuple(np.random.default_rng(2).normal(size=value.shape) for value in point)

    def image(*values: jax.Array) -> jax.Array:
        # With the cutoff given; a pilot may find another one for each.
        return rendered(leaf, *values, method="walk", max_angle=10.0)

    @jax.jit
    def both(velocities: Any) -> Any:
        _, push = jax.linearize(image, *point)
        pull = jax.linear_transpose(lambda vs: push(*vs), velocities)
        again = jax.linear_transpose(pull, ADJOINT)
        return push(*velocities), pull(ADJOINT)[0], again((velocities,))[0]

    derivative, gradients, again = both(velocities)
    reverse = sum((g * v).sum() for g, v in zip(gradients, velocities))
    assert np.isclose((ADJOINT * derivative).sum(), reverse, rtol=1e-9)
    assert same(again, derivative)


def test_pose_and_colour_agree_with_differences(leaf: cw.Scene) -> None:
    """A pose that is composed in JAX. Errors are those of means over seeds."""
    positions = jnp.asarray(cw.traverse(leaf)[LEAF])
    centre = positions.mean(0)

    @jax.jit
    def loss(state: jax.Array, seed: jax.Array) -> jax.Array:
        angle, shift, red = state
        s, c = jnp.sin(angle), jnp.cos(angle)
        turn = jnp.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
        pose = (positions - centre) @ turn.T + centre + jnp.array([0, -shift, shift])
        colour = jnp.array([0.4, 0.3, 0.2]).at[0].set(red)
        options = {"method": "edges", "spp_grad": 32, "spp": 128, "seed": seed}
        return (ADJOINT * rendered(leaf, pose, colour, **options)).sum()

    start, step = jnp.array([0.4, 0.1, 0.5]), 0.02
    gradient = jax.jit(jax.grad(loss))
    found = np.array([gradient(start, seed) for seed in range(8)])

    def difference(move: np.ndarray, seed: int) -> float:
        return (loss(start + move, 2 * seed) - loss(start - move, 2 * seed + 1)) / (2 * step)

    moves, seeds = step * np.eye(3), range(50, 58)
    expected = np.array([[difference(move, seed) for move in moves] for seed in seeds])
    means, errors = zip(*((x.mean(0), x.std(0, ddof=1) / np.sqrt(8)) for x in (found, expected)))
    z = (means[0] - means[1]) / np.hypot(*errors)
    assert np.abs(z).max() < 5, (means, errors)
    # Enough to tell.
    assert (np.abs(means[0]) > 5 * errors[0]).all(), (means, errors)


def test_an_optimisation_converges(leaf: cw.Scene) -> None:
    """Where the leaf is and the colour below it, by steps of Adam; compiled once."""
    target = cw.render(leaf, spp=256, seed=999).value
    positions, colour = values(leaf)
    traced = []

    def loss(state: jax.Array, seed: jax.Array) -> jax.Array:
        traced.append(seed)
        shift = state[:3] * jnp.array([0.2, 0, 0.2])
        floor = jax.nn.sigmoid(state[3:])
        image = rendered(leaf, positions + shift, floor, spp=16, seed=seed, method="edges")
        return ((image - target) ** 2).mean()

    @jax.jit
    def step(state: jax.Array, m: jax.Array, v: jax.Array, i: jax.Array) -> Any:
        gradient = jax.grad(loss)(state, i)
        m, v = 0.9 * m + 0.1 * gradient, 0.999 * v + 0.001 * gradient**2
        m_hat, v_hat = m / (1 - 0.9 ** (i + 1.0)), v / (1 - 0.999 ** (i + 1.0))
        return state - 0.15 * m_hat / (jnp.sqrt(v_hat) + 1e-8), m, v

    state = jnp.array([1.0, 0, -0.75, 0, 0, 0])
    m = v = jnp.zeros(6)
    for i in range(25):
        state, m, v = step(state, m, v, i)
    assert len(traced) == 1
    assert jnp.abs(jax.nn.sigmoid(state[3:]) - colour).max() < 0.05
    assert jnp.abs(0.2 * state[:3]).max() < 0.05


def test_vmap_over_parameters_and_seeds(leaf: cw.Scene) -> None:
    """One after the other, in any order with grad and jit: the same bits as without."""
    positions, colour = values(leaf)
    batch, seeds = jnp.stack([positions, positions + 0.1]), jnp.array([SEED, 2**40])

    def image(positions: jax.Array, seed: jax.Array) -> jax.Array:
        return rendered(leaf, positions, colour, seed=seed, method="edges")

    def loss(positions: jax.Array, seed: jax.Array) -> jax.Array:
        return (image(positions, seed) * ADJOINT).sum()

    def total(batch: jax.Array, seeds: jax.Array) -> jax.Array:
        return jax.vmap(loss)(batch, seeds).sum()

    pairs = list(zip(batch, (SEED, 2**40)))
    alone = jnp.stack([image(*pair) for pair in pairs])
    assert same(alone[1], cw_image(leaf, batch[1], 2**40))
    gradients = jnp.stack([jax.grad(loss)(*pair) for pair in pairs])
    for jit in (lambda f: f, jax.jit):
        assert same(jit(jax.vmap(image))(batch, seeds), alone)
        assert same(jit(jax.vmap(jax.grad(loss)))(batch, seeds), gradients)
        assert same(jit(jax.grad(total))(batch, seeds), gradients)
    assert same(jax.vmap(image, (None, 0))(positions, seeds)[0], alone[0])

    # Views of a camera.
    places = jnp.stack([cw.traverse(leaf)["sensor.to_world"]] * 2).at[1, 0, 3].add(0.3)

    def view(place: jax.Array) -> jax.Array:
        return capwalk.jax.render(leaf, {"sensor.to_world": place}, spp=1)

    assert same(jax.jit(jax.vmap(view))(places), jnp.stack([view(place) for place in places]))

    # Batches of tangents and of adjoints.
    def means(colour: jax.Array) -> jax.Array:
        return rendered(leaf, positions, colour, spp=1).mean((0, 1))

    assert np.allclose(jax.jacfwd(means)(colour), jax.jacrev(means)(colour), rtol=1e-9, atol=1e-12)


def cw_image(scene: cw.Scene, positions: jax.Array, seed: int) -> np.ndarray:
    copy = scene.copy()
    cw.traverse(copy).update({LEAF: np.asarray(positions)})
    return cw.render(copy, spp=4, seed=seed).value


def test_types_and_shapes(leaf: cw.Scene) -> None:
    """Each gradient is like its array; the image is of the widest type."""
    positions, colour = values(leaf)

    def loss(params: dict[str, jax.Array]) -> jax.Array:
        return capwalk.jax.render(leaf, params, spp=2, seed=SEED).sum()

    fov = jnp.float32(cw.traverse(leaf)["sensor.x_fov"][0])
    params = {LEAF: positions.astype(jnp.float32), FLOOR: colour, "sensor.x_fov": fov}
    for like in (params, {name: value.reshape(-1) for name, value in params.items()}):
        assert loss(like).dtype == jnp.float64
        for found in (jax.grad(loss)(like), jax.jit(jax.grad(loss))(like)):
            for name, value in like.items():
                assert found[name].shape == value.shape and found[name].dtype == value.dtype
                assert found[name].any()
    single = capwalk.jax.render(leaf, {LEAF: params[LEAF]}, spp=2, seed=SEED)
    assert single.dtype == jnp.float32
    # Arrays of NumPy, too.
    image = capwalk.jax.render(leaf, {FLOOR: np.asarray(colour)}, spp=1)
    assert same(image, cw.render(leaf, spp=1).value)


def test_single_precision(leaf: cw.Scene) -> None:
    """What JAX has by default."""
    colours = {FLOOR: cw.traverse(leaf)[FLOOR]}

    def loss(params: dict[str, jax.Array], seed: jax.Array) -> jax.Array:
        return capwalk.jax.render(leaf, params, spp=1, seed=seed).sum()

    jax.config.update("jax_enable_x64", False)
    try:
        assert capwalk.jax.render(leaf, {}, spp=1).dtype == jnp.float32
        image = capwalk.jax.render(leaf, colours, spp=1, seed=2**40)
        assert image.dtype == jnp.float32
        assert np.allclose(image, cw.render(leaf, spp=1, seed=2**40), rtol=1e-6)
        gradient = jax.block_until_ready(jax.jit(jax.grad(loss))(colours, SEED)[FLOOR])
        assert gradient.dtype == jnp.float32
    finally:
        jax.config.update("jax_enable_x64", True)
    assert np.allclose(gradient, jax.grad(loss)(colours, SEED)[FLOOR], rtol=1e-5)


@pytest.mark.parametrize("jit", [lambda f: f, jax.jit])
def test_views_in_one_call(jit: Any) -> None:
    """The bits of one call for each, of which the gradients are added up."""
    from capwalk.parallel import view_seed
    from test_views import two_of_one_size

    two = two_of_one_size()
    names = ("box.positions", "left.x_fov")
    start = [jnp.asarray(cw.traverse(two)[name]) for name in names]
    weights = np.random.default_rng(1).normal(size=(2, 18, 24, 3))

    def render(values: list[jax.Array], **options: Any) -> jax.Array:
        return capwalk.jax.render(two, dict(zip(names, values)), spp=2, **options)

    seeds = [{"seed": view_seed(SEED, i), "seed_grad": view_seed(SEED_GRAD, i)} for i in (0, 1)]
    images, pull = jax.vjp(jit(lambda values: render(values, views=["left", 0], seed=SEED)), start)
    apart = [
        jax.vjp(lambda values: render(values, sensor=sensor, **own), start)
        for sensor, own in zip(("left", 0), seeds)
    ]
    assert same(images, jnp.stack([image for image, _ in apart]))
    first, second = (pull(adjoint)[0] for adjoint, (_, pull) in zip(weights, apart))
    (found,) = pull(jnp.asarray(weights))
    assert found[0].any() and found[1].any()
    assert same(found, [one + other for one, other in zip(first, second)])


def test_the_scene_counts_as_it_was(leaf: cw.Scene) -> None:
    """At the call, or when a function was traced; and it is left as it is."""
    positions, colour = values(leaf)
    before = leaf.copy()

    def image(colour: jax.Array) -> jax.Array:
        return capwalk.jax.render(leaf, {FLOOR: colour}, spp=2, seed=SEED)

    compiled = jax.jit(image)
    first, pull = jax.vjp(image, 0.5 * colour)
    assert same(compiled(0.5 * colour), first)
    assert same(cw.traverse(leaf)[FLOOR], colour)
    cw.traverse(leaf).update({LEAF: np.asarray(positions + 0.3)})
    assert same(image(colour), cw.render(leaf, spp=2, seed=SEED).value)
    assert same(compiled(0.5 * colour), first)
    leaf.resize(7, 5)
    assert image(colour).shape == (5, 7, 3)
    cw.traverse(before).update({FLOOR: np.asarray(0.5 * colour)})
    (expected,) = cw.backward(before, ADJOINT, [FLOOR], spp=2, seed=SEED_GRAD).values()
    assert same(pull(ADJOINT), (expected,))
    # A function keeps the scene.
    del leaf
    assert same(compiled(0.5 * colour), first)


def test_threads_and_large_arrays() -> None:
    """Callbacks wait for no copies that only their own threads could make."""
    ball = cw.load_file("ball")
    ball.resize(4, 3)
    start = jnp.asarray(cw.traverse(ball)["ball.positions"])

    @jax.jit
    def image(positions: jax.Array, seed: jax.Array) -> jax.Array:
        return capwalk.jax.render(ball, {"ball.positions": positions}, spp=2, seed=seed)

    def several(number: int) -> jax.Array:
        # Made while the images of others are rendered.
        images = [image(start * (1 + 1e-3 * number), seed) for seed in range(3)]
        return jax.block_until_ready(sum(images))

    alone = [several(number) for number in range(4)]
    pool = ThreadPoolExecutor(4)
    together = [pool.submit(several, number) for number in range(4)]
    for one, future in zip(alone, together):
        assert same(one, future.result(60))
    pool.shutdown()


def test_exceptions(leaf: cw.Scene) -> None:
    """Their types are kept where nothing is compiled; their texts always are."""
    positions, colour = values(leaf)

    def image(colour: jax.Array) -> jax.Array:
        return capwalk.jax.render(leaf, {FLOOR: colour}, spp=1)

    with pytest.raises(cw.ParameterError, match="would be NaN"):
        image(colour * np.nan)
    with pytest.raises(cw.ParameterError, match="would be NaN"):
        jax.vmap(jax.grad(lambda c: image(c).sum()))(jnp.full((2, 3), np.nan))
    with pytest.raises(Exception, match=f'"{FLOOR}" would be NaN'):
        jax.block_until_ready(jax.jit(image)(colour * np.nan))
    # The next is not worse for it.
    assert same(jax.jit(image)(colour), image(colour))

    def refused(colour: jax.Array) -> jax.Array:
        return rendered(leaf, positions, colour, method="walk", max_angle=-1.0).sum()

    with pytest.raises(cw.Refused, match="largest angle"):
        jax.grad(refused)(colour)

    def stop(done: int, total: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        capwalk.jax.render(leaf, {FLOOR: colour}, spp=1, progress=stop)


def test_no_second_derivatives(leaf: cw.Scene) -> None:
    _, colour = values(leaf)

    def loss(colour: jax.Array) -> jax.Array:
        return (capwalk.jax.render(leaf, {FLOOR: colour}, spp=1) ** 2).sum()

    twice = (jax.hessian(loss), jax.jit(jax.jacrev(jax.grad(loss))), jax.jacfwd(jax.jacfwd(loss)))
    for second in twice:
        with pytest.raises(cw.Refused, match=f"again, here with respect to {FLOOR}"):
            second(colour)


WRONG: list[tuple[dict[str, Any], dict[str, Any], type[Exception], str]] = [
    ({FLOOR: "red"}, {}, TypeError, f"{FLOOR} is a str; expected an array"),
    ({FLOOR: np.array([1, 0, 0])}, {}, cw.ArgumentError, "int64; expected float32"),
    ({FLOOR: np.ones(3, np.float16)}, {}, cw.ArgumentError, "float16"),
    ({FLOOR: np.ones(2)}, {}, cw.ArgumentError, r"shape \(3,\); found \(2,\)"),
    ({LEAF: np.ones((1, 9))}, {}, cw.ArgumentError, r"shape \(3, 3\); found \(1, 9\)"),
    ({"leaf.position": np.ones(3)}, {}, cw.ParameterError, "did you mean `leaf.positions`"),
    ({"leaf.translate.x": 0.5}, {}, cw.ParameterError, '"leaf.to_world" and "leaf.positions"'),
    (
        {LEAF: np.ones((3, 3)), "leaf.to_world": np.eye(4)},
        {},
        cw.ArgumentError,
        "leaf.to_world and leaf.positions both place leaf",
    ),
    ({}, {"seed": 3, "seed_grad": 3}, cw.ArgumentError, "both 3; .* biased"),
    ({}, {"seed": -1}, cw.ArgumentError, "seed is -1"),
    ({}, {"seed": 0.5}, TypeError, "seed is 0.5; expected an integer"),
    ({}, {"spp_grad": 0}, cw.ArgumentError, "spp_grad is 0"),
]


@pytest.mark.parametrize("case", range(len(WRONG)))
def test_wrong_input(leaf: cw.Scene, case: int) -> None:
    params, options, kind, message = WRONG[case]
    for jit in (lambda f: f, jax.jit):
        with pytest.raises(kind, match=message):
            jit(lambda: capwalk.jax.render(leaf, params, **options))()


def test_seeds_that_are_traced(leaf: cw.Scene) -> None:
    @jax.jit
    def image(seed: jax.Array, seed_grad: jax.Array) -> jax.Array:
        return capwalk.jax.render(leaf, {}, spp=1, seed=seed, seed_grad=seed_grad)

    for seed in (3, 2**40, jnp.uint32(2**32 - 1), jnp.int32(7)):
        assert same(image(seed, 1), cw.render(leaf, spp=1, seed=int(seed)).value)
    with pytest.raises(Exception, match="seed and seed_grad are both 1; .* biased"):
        jax.block_until_ready(image(1, 1))
    with pytest.raises(TypeError, match=r"seed is an array float64\[\]; expected one integer"):
        image(1.5, 1)


def test_the_example() -> None:
    assert doctest.testmod(capwalk.jax).failed == 0
