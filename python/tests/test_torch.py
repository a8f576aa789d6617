"""Images that PyTorch differentiates."""

from __future__ import annotations

import doctest
import gc
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import capwalk as cw
import numpy as np
import pytest
from conftest import SCENE

torch = pytest.importorskip("torch")

import capwalk.torch  # noqa: E402

LEAF = "leaf.positions"
FLOOR = "floor.bsdf.reflectance.value"
SEED = 5
# The seed that derivatives have by default.
SEED_GRAD = 2**64 - 1 - SEED


@pytest.fixture
def leaf() -> cw.Scene:
    """A leaf, the shadow that it casts, and 12 x 9 pixels."""
    scene = cw.load_file("leaf")
    scene.resize(12, 9)
    return scene


def tensors(scene: cw.Scene, *names: str, dtype: object = torch.float64) -> dict[str, torch.Tensor]:
    return {name: torch.tensor(cw.traverse(scene)[name], dtype=dtype) for name in names}


def adjoint(dtype: object = torch.float64) -> torch.Tensor:
    return torch.tensor(np.random.default_rng(1).normal(size=(9, 12, 3)), dtype=dtype)


def test_reverse_mode_is_backward(leaf: cw.Scene) -> None:
    params = tensors(leaf, LEAF, FLOOR, "lamp.emitter.radiance.value")
    for name in (LEAF, FLOOR):
        params[name].requires_grad_()
    image = capwalk.torch.render(leaf, params, spp=4, seed=SEED)
    assert image.shape == (9, 12, 3) and image.dtype == torch.float64
    assert np.array_equal(image.detach(), cw.render(leaf, spp=4, seed=SEED))
    (image * adjoint()).sum().backward()
    expected = cw.backward(leaf, adjoint(), [LEAF, FLOOR], spp=4, seed=SEED_GRAD)
    for name in (LEAF, FLOOR):
        assert np.array_equal(params[name].grad, expected[name]), name
    assert params["lamp.emitter.radiance.value"].grad is None
    # Only what is asked for: walks for what moves take other film points, which gives other bits.
    soft = cw.load_string(SCENE.replace('<rfilter type="box"/>', '<rfilter type="gaussian"/>'))
    params = tensors(soft, "box.positions", FLOOR)
    params[FLOOR].requires_grad_()
    image = capwalk.torch.render(soft, params, spp=4, seed=SEED, method="walk")
    weights = np.random.default_rng(1).normal(size=image.shape)
    (found,) = torch.autograd.grad((image * torch.tensor(weights)).sum(), params[FLOOR])
    one, both = (
        cw.backward(soft, weights, names, spp=4, seed=SEED_GRAD, method="walk")
        for names in ([FLOOR], ["box.positions", FLOOR])
    )
    assert np.array_equal(found, one[FLOOR]) and not np.array_equal(found, both[FLOOR])


def test_translations_are_those_of_all_vertices(leaf: cw.Scene) -> None:
    shift = torch.tensor([0.1, -0.2, 0.3], dtype=torch.float64, requires_grad=True)
    corners = tensors(leaf, LEAF)[LEAF]
    # With the cutoff given; a pilot may find another one for each.
    options = {"method": "walk", "max_angle": 10.0, "spp": 2, "seed": SEED}
    found = []
    for params in ({"leaf.translate": shift}, {LEAF: corners + shift}):
        image = capwalk.torch.render(leaf, params, **options)
        (gradient,) = torch.autograd.grad((image * adjoint()).sum(), shift)
        assert gradient.any()
        found.append((image.detach(), gradient))
    for one, other in zip(*found):
        assert torch.allclose(one, other, rtol=1e-6, atol=1e-9)


def test_forward_mode_is_gradient(leaf: cw.Scene) -> None:
    params = tensors(leaf, LEAF, FLOOR)
    velocity = torch.zeros(3, 3, dtype=torch.float64)
    velocity[:, 0] = 1

    def image(positions: torch.Tensor) -> torch.Tensor:
        return capwalk.torch.render(leaf, {**params, LEAF: positions}, spp=4, seed=SEED)

    expected = cw.gradient(leaf, "leaf.translate.x", spp=4, seed=SEED_GRAD)
    value, derivative = torch.func.jvp(image, (params[LEAF],), (velocity,))
    assert np.array_equal(value, cw.render(leaf, spp=4, seed=SEED))
    assert np.array_equal(derivative, expected)
    with torch.autograd.forward_ad.dual_level():
        # Also where reverse mode records.
        params[LEAF].requires_grad_()
        dual = image(torch.autograd.forward_ad.make_dual(params[LEAF], velocity))
        derivative = torch.autograd.forward_ad.unpack_dual(dual).tangent
        assert np.array_equal(derivative.detach(), expected)
    _, derivative = torch.func.jvp(image, (params[LEAF].detach(),), (0 * velocity,))
    assert not derivative.any()


def test_forward_is_reverse(leaf: cw.Scene) -> None:
    """And both are linear, so that either can be differentiated as such."""
    params = tensors(leaf, LEAF, FLOOR)
    velocities = tuple(torch.randn_like(value) for value in params.values())

    def image(*values: torch.Tensor) -> torch.Tensor:
        pairs = zip(params, values)
        # With the cutoff given; a pilot may find another one for each.
        options = {"method": "walk", "max_angle": 10.0, "spp": 2, "seed": SEED}
        return capwalk.torch.render(leaf, dict(pairs), **options)

    values = tuple(params.values())
    _, derivative = torch.func.jvp(image, values, velocities)
    _, pull = torch.func.vjp(image, *values)
    gradients = pull(adjoint())
    forward = (adjoint() * derivative).sum()
    reverse = sum((g * v).sum() for g, v in zip(gradients, velocities))
    assert torch.isclose(forward, reverse, rtol=1e-9)

    def pulled(image: torch.Tensor) -> torch.Tensor:
        return sum((g * v).sum() for g, v in zip(pull(image), velocities))

    def pushed(*velocities: torch.Tensor) -> torch.Tensor:
        return (adjoint() * torch.func.jvp(image, values, velocities)[1]).sum()

    assert torch.equal(torch.func.grad(pulled)(adjoint()), derivative)
    assert torch.equal(torch.func.jvp(pull, (adjoint(),), (2 * adjoint(),))[1][0], 2 * gradients[0])
    for one, other in zip(torch.func.grad(pushed, (0, 1))(*velocities), gradients):
        assert torch.equal(one, other)


def test_pose_and_colour_agree_with_differences(leaf: cw.Scene) -> None:
    """A pose that is composed in torch. Errors are those of means over seeds."""
    positions, weights = torch.tensor(cw.traverse(leaf)[LEAF]), adjoint()
    centre = positions.mean(0)

    def loss(
        angle: torch.Tensor, shift: torch.Tensor, colour: torch.Tensor, seed: int
    ) -> torch.Tensor:
        s, c, zero, one = angle.sin(), angle.cos(), 0 * angle, 0 * angle + 1
        turn = torch.stack([c, zero, s, zero, one, zero, -s, zero, c]).reshape(3, 3)
        pose = (positions - centre) @ turn.T + centre + shift
        params = {LEAF: pose, FLOOR: colour}
        options = {"method": "edges", "spp_grad": 32, "spp": 128, "seed": seed}
        return (weights * capwalk.torch.render(leaf, params, **options)).sum()

    start = [
        torch.tensor(0.4, dtype=torch.float64, requires_grad=True),
        torch.tensor([0.1, -0.1, 0.2], dtype=torch.float64, requires_grad=True),
        torch.tensor([0.5, 0.4, 0.3], dtype=torch.float64, requires_grad=True),
    ]

    def flat(parts: list[torch.Tensor]) -> np.ndarray:
        return torch.cat([part.reshape(-1) for part in parts]).detach().numpy()

    gradients = [flat(torch.autograd.grad(loss(*start, seed), start)) for seed in range(8)]

    def difference(number: int, seed: int) -> float:
        step, losses = 0.02, []
        for side in (0, 1):
            moved = torch.from_numpy(flat(start))
            moved[number] += (1 - 2 * side) * step
            parts = moved[0], moved[1:4], moved[4:]
            with torch.no_grad():
                losses.append(float(loss(*parts, 100 + 2 * seed + side)))
        return (losses[0] - losses[1]) / (2 * step)

    for number in range(7):
        found = [gradient[number] for gradient in gradients]
        expected = [difference(number, seed) for seed in range(8)]
        errors = [np.std(x, ddof=1) / np.sqrt(8) for x in (found, expected)]
        z = (np.mean(found) - np.mean(expected)) / np.hypot(*errors)
        assert abs(z) < 5, (number, np.mean(found), np.mean(expected), errors)
        # Enough to tell.
        assert abs(np.mean(found)) > 5 * errors[0], number


def test_an_optimisation_converges(leaf: cw.Scene) -> None:
    """Where the leaf is and the colour below it, in the usual loop."""
    target = torch.tensor(cw.render(leaf, spp=256, seed=999).value)
    positions, colour = cw.traverse(leaf)[LEAF], cw.traverse(leaf)[FLOOR]
    shift = torch.tensor([0.2, 0.0, -0.15], dtype=torch.float64, requires_grad=True)
    logit = torch.zeros(3, dtype=torch.float64, requires_grad=True)
    sideways = torch.tensor([1.0, 0.0, 1.0], dtype=torch.float64)
    adam = torch.optim.Adam([{"params": [shift], "lr": 0.03}, {"params": [logit], "lr": 0.15}])
    for step in range(25):
        params = {LEAF: torch.tensor(positions) + shift * sideways, FLOOR: logit.sigmoid()}
        image = capwalk.torch.render(leaf, params, spp=16, seed=step, method="edges")
        adam.zero_grad()
        (image - target).square().mean().backward()
        adam.step()
    assert np.abs(logit.sigmoid().detach().numpy() - colour).max() < 0.05
    assert shift.detach().abs().max() < 0.05


def test_types_and_shapes(leaf: cw.Scene) -> None:
    """Each gradient is like its tensor; the image is of the widest type."""
    exact = tensors(leaf, LEAF, FLOOR)
    transposed = exact[LEAF].T.contiguous().T
    assert not transposed.is_contiguous()
    fov = torch.tensor(cw.traverse(leaf)["sensor.x_fov"][0], dtype=torch.float32)
    params = {LEAF: transposed.float(), FLOOR: exact[FLOOR].flip(0).flip(0), "sensor.x_fov": fov}
    for value in params.values():
        value.requires_grad_()
    image = capwalk.torch.render(leaf, params, spp=2, seed=SEED)
    assert image.dtype == torch.float64
    image.sum().backward()
    for value in params.values():
        assert value.grad.shape == value.shape and value.grad.dtype == value.dtype
    flat = {name: value.detach().reshape(-1).requires_grad_() for name, value in params.items()}
    other = capwalk.torch.render(leaf, flat, spp=2, seed=SEED)
    assert torch.equal(other, image)
    other.sum().backward()
    for name, value in flat.items():
        assert torch.equal(value.grad, params[name].grad.reshape(-1)), name
    single = capwalk.torch.render(leaf, tensors(leaf, LEAF, dtype=torch.float32), spp=1)
    assert single.dtype == torch.float32
    assert capwalk.torch.render(leaf, {}, spp=1).dtype == torch.get_default_dtype()


def test_every_backward_is_of_its_forward(leaf: cw.Scene) -> None:
    """Whatever was rendered or changed in between; and the scene is left as it is."""
    start = cw.traverse(leaf)[FLOOR]
    colours = [torch.tensor(start * s, requires_grad=True) for s in (0.5, 1.0)]
    images = [
        capwalk.torch.render(leaf, {FLOOR: colour}, spp=2, seed=SEED) for colour in colours
    ]
    assert np.array_equal(cw.traverse(leaf)[FLOOR], start)
    before = leaf.copy()
    moved = cw.traverse(leaf)[LEAF] + [0.2, 0.0, 0.0]
    cw.traverse(leaf).update({LEAF: moved})
    expected = cw.render(leaf, spp=2, seed=SEED)
    later = capwalk.torch.render(leaf, {FLOOR: colours[1]}, spp=2, seed=SEED)
    assert np.array_equal(later.detach(), expected)
    # Also in place.
    changing = torch.tensor(0.5 * start)
    assert not np.array_equal(capwalk.torch.render(leaf, {FLOOR: changing}, spp=2), expected)
    changing *= 2
    half = {FLOOR: 0.5 * changing}
    for params in ({FLOOR: changing}, half, {LEAF: torch.tensor(moved)}):
        image = capwalk.torch.render(leaf, params, spp=2, seed=SEED)
        assert np.array_equal(image, expected) == (params is not half)
    leaf.resize(7, 5)
    for image, colour in zip(images, colours):
        (image * adjoint()).sum().backward()
        cw.traverse(before).update({FLOOR: colour.detach().numpy()})
        expected = cw.backward(before, adjoint(), [FLOOR], spp=2, seed=SEED_GRAD)
        assert np.array_equal(colour.grad, expected[FLOOR])
    assert capwalk.torch.render(leaf, {FLOOR: colours[0]}, spp=1).shape == (5, 7, 3)
    assert np.array_equal(cw.traverse(leaf)[LEAF], moved)


def test_a_rotation_vector_turns_the_sensor(leaf: cw.Scene) -> None:
    """From where it is: derivatives with respect to the vector are not those by turning on. The matrix
    that it makes has no noise; its differences are compared."""
    from capwalk._functional import _rotation_jacobian

    rotation, velocity, step = np.array([0.07, -0.2, 0.1]), np.array([0.3, 0.5, -0.2]), 1e-6
    for at in (10 * rotation, rotation, 1e-5 * rotation, 0 * rotation):
        matrices = []
        for side in (step, -step, 0):
            turned = leaf.copy()
            cw.traverse(turned).update({"sensor.rotate": at + side * velocity})
            matrices.append(cw.traverse(turned)["sensor.to_world"][:3, :3])
        spin = (matrices[0] - matrices[1]) / (2 * step) @ matrices[2].T
        found = np.array([spin[2, 1], spin[0, 2], spin[1, 0]])
        assert np.allclose(_rotation_jacobian(at) @ velocity, found, atol=1e-8)

    options = {"method": "walk", "max_angle": 10.0, "spp": 2}
    turned = leaf.copy()
    cw.traverse(turned).update({"sensor.rotate": rotation})
    expected = cw.backward(turned, adjoint(), ["sensor.rotate"], seed=SEED_GRAD, **options)
    expected = _rotation_jacobian(rotation).T @ expected["sensor.rotate"]

    def image(rotation: torch.Tensor) -> torch.Tensor:
        return capwalk.torch.render(leaf, {"sensor.rotate": rotation}, seed=SEED, **options)

    value, pull = torch.func.vjp(image, torch.tensor(rotation))
    (gradient,) = pull(adjoint())
    assert np.allclose(gradient, expected, rtol=1e-12)
    _, derivative = torch.func.jvp(image, (torch.tensor(rotation),), (torch.tensor(velocity),))
    assert np.isclose((adjoint() * derivative).sum(), expected @ velocity, rtol=1e-9)


def test_normals_are_made_unit(tmp_path: Path) -> None:
    """The derivative with respect to a normal twice as long is half of that by the unit one."""
    corners = ["-1 -1 0", "1 -1 0", "0 1 0"]
    lines = [*(f"v {c}" for c in corners), *["vn 0 0 1"] * 3, "f 1//1 2//2 3//3"]
    (tmp_path / "shape.obj").write_text("\n".join(lines))
    scene = cw.load_string(
        """<scene version="3.0.0"><integrator type="direct"/><sensor type="perspective">
        <transform name="to_world"><lookat origin="0, 0, 4" target="0, 0, 0" up="0, 1, 0"/>
        </transform><film type="hdrfilm"><integer name="width" value="4"/>
        <integer name="height" value="3"/></film></sensor>
        <shape type="obj" id="shape"><string name="filename" value="shape.obj"/></shape>
        <emitter type="point"><point name="position" x="1" y="2" z="3"/></emitter></scene>""",
        tmp_path,
    )
    gradients = []
    for factor in (1, 2):
        normals = torch.tensor(factor * cw.traverse(scene)["shape.normals"], requires_grad=True)
        capwalk.torch.render(scene, {"shape.normals": normals}, spp=4).sum().backward()
        gradients.append(factor * normals.grad)
    assert gradients[0].any() and torch.equal(*gradients)


def test_vmap(leaf: cw.Scene) -> None:
    """One after the other: the same bits as without."""
    colours = torch.rand(2, 3, dtype=torch.float64)
    positions = torch.tensor(cw.traverse(leaf)[LEAF])

    def loss(colour: torch.Tensor, positions: torch.Tensor) -> torch.Tensor:
        params = {FLOOR: colour, LEAF: positions}
        return (capwalk.torch.render(leaf, params, spp=2, seed=SEED) * adjoint()).sum()

    func = torch.func
    both = func.grad(loss, (0, 1))
    for colour, *found in zip(colours, *func.vmap(both, (0, None))(colours, positions)):
        for one, other in zip(both(colour, positions), found):
            assert torch.equal(one, other)
    gradients = func.vmap(func.grad(loss), (0, None))(colours, positions)
    total = func.grad(lambda colours: func.vmap(loss, (0, None))(colours, positions).sum())
    assert torch.equal(total(colours), gradients)
    jacobian = func.jacfwd(loss)(colours[0], positions)
    assert torch.allclose(jacobian, gradients[0], rtol=1e-9)


def test_views(leaf: cw.Scene) -> None:
    """Another sensor, and what is seen besides light."""
    from test_views import LEFT, SCENE

    two = cw.load_string(SCENE.replace("</scene>", LEFT))
    box = torch.tensor(cw.traverse(two)["box.positions"], requires_grad=True)
    for sensor, aov, size in (("left", None, (10, 20, 3)), (0, "mask", (18, 24, 3))):
        options = {"sensor": sensor, "aov": aov, "spp": 2}
        image = capwalk.torch.render(two, {"box.positions": box}, seed=SEED, **options)
        assert np.array_equal(image.detach(), cw.render(two, seed=SEED, **options))
        (found,) = torch.autograd.grad(image.sum(), box)
        expected = cw.backward(two, np.ones(size), ["box.positions"], seed=SEED_GRAD, **options)
        assert np.array_equal(found, expected["box.positions"]) and found.any()


def test_views_in_one_call() -> None:
    """The bits of one call for each, of which the gradients are added up, with one set of trees."""
    from capwalk._functional import _KEPT
    from capwalk.parallel import view_seed
    from test_views import two_of_one_size

    two = two_of_one_size()
    names = ["box.positions", FLOOR, "left.to_world", "left.x_fov", "sensor_0.translate"]
    values = tuple(tensors(two, *names).values())
    weights = torch.tensor(np.random.default_rng(1).normal(size=(3, 18, 24, 3)))
    views = ["left", 0, 1]

    def together(*values: torch.Tensor) -> torch.Tensor:
        params = dict(zip(names, values))
        return capwalk.torch.render(two, params, views=views, spp=2, spp_grad=3, seed=SEED)

    def apart(i: int, *values: torch.Tensor) -> torch.Tensor:
        params = dict(zip(names, values))
        own = {"seed": view_seed(SEED, i), "seed_grad": view_seed(SEED_GRAD, i)}
        return capwalk.torch.render(two, params, sensor=views[i], spp=2, spp_grad=3, **own)

    func = torch.func
    images, pull = func.vjp(together, *values)
    assert [len(copies) for copies in _KEPT[two].spare.values()] == [1]
    separate = [func.vjp(lambda *v, i=i: apart(i, *v), *values) for i in range(3)]
    assert torch.equal(images, torch.stack([image for image, _ in separate]))
    for i, sensor in enumerate(views):
        own = cw.render(two, sensor=sensor, spp=2, seed=view_seed(SEED, i))
        assert np.array_equal(images[i], own.value)
    first, second, third = (pull(weights[i]) for i, (_, pull) in enumerate(separate))
    for name, found, a, b, c in zip(names, pull(weights), first, second, third):
        assert found.any() and torch.equal(found, (a + b) + c), name
    assert second[2].any() == second[3].any() == first[4].any() == False  # noqa: E712
    _, moved = func.jvp(together, values, values)
    expected = [func.jvp(lambda *v, i=i: apart(i, *v), values, values)[1] for i in range(3)]
    assert torch.equal(moved, torch.stack(expected))
    assert [len(copies) for copies in _KEPT[two].spare.values()] == [1]


def test_wrong_views() -> None:
    from test_views import LEFT, SCENE

    two = cw.load_string(SCENE.replace("</scene>", LEFT))
    for options, error in (
        ({"views": [0, 1]}, r"several sizes \(sensor_0 24 x 18, left 20 x 10\); expected one"),
        ({"views": []}, "views is empty"),
        ({"views": ["left", "right"]}, 'no sensor "right"'),
        ({"views": ["left"], "sensor": 0}, "both sensor and views"),
    ):
        with pytest.raises(cw.ArgumentError, match=error):
            capwalk.torch.render(two, {}, spp=1, **options)
    with pytest.raises(TypeError, match=r"views is the string 'left'; expected a list"):
        capwalk.torch.render(two, {}, views="left", spp=1)
    assert capwalk.torch.render(two, {}, views=["left"], spp=1).shape == (1, 10, 20, 3)


def test_threads(leaf: cw.Scene) -> None:
    other = cw.load_file("leaf")
    other.resize(5, 4)
    scenes = [leaf, other]

    def gradient(number: int) -> torch.Tensor:
        colour = torch.full((3,), 0.1 * number + 0.1, dtype=torch.float64, requires_grad=True)
        image = capwalk.torch.render(scenes[number % 2], {FLOOR: colour}, spp=4, seed=number)
        image.square().sum().backward()
        return colour.grad

    alone = [gradient(number) for number in range(6)]
    with ThreadPoolExecutor(3) as pool:
        together = list(pool.map(gradient, range(6)))
    assert all(torch.equal(one, two) for one, two in zip(alone, together))


def test_a_callback_may_render(leaf: cw.Scene) -> None:
    colour = torch.tensor(cw.traverse(leaf)[FLOOR])
    shapes = []

    def tell(done: int, total: int) -> None:
        shapes.append(capwalk.torch.render(leaf, {FLOOR: colour}, spp=1).shape)

    capwalk.torch.render(leaf, {FLOOR: colour}, spp=4, progress=tell)
    assert (9, 12, 3) in shapes


def test_exceptions_pass(leaf: cw.Scene) -> None:
    """Also through the engine of autograd, from the work."""
    colour = torch.tensor(cw.traverse(leaf)[FLOOR], requires_grad=True)

    def stop(done: int, total: int) -> None:
        if threading.current_thread() is threading.main_thread() and total != 9 * 12:
            raise KeyboardInterrupt

    image = capwalk.torch.render(leaf, {FLOOR: colour}, spp=1, spp_grad=2, progress=stop)
    with pytest.raises(KeyboardInterrupt):
        image.sum().backward()
    image = capwalk.torch.render(leaf, {FLOOR: colour}, spp=1, method="walk", max_angle=-1.0)
    with pytest.raises(cw.Refused, match="largest angle"):
        image.sum().backward()
    with pytest.raises(cw.ArgumentError, match="adjoint"):
        (capwalk.torch.render(leaf, {FLOOR: colour}, spp=1) * np.nan).sum().backward()


def test_no_second_derivatives(leaf: cw.Scene) -> None:
    colour = torch.tensor(cw.traverse(leaf)[FLOOR], requires_grad=True)

    def loss(colour: torch.Tensor) -> torch.Tensor:
        return capwalk.torch.render(leaf, {FLOOR: colour}, spp=2).square().sum()

    (once,) = torch.autograd.grad(loss(colour), colour, create_graph=True)
    with pytest.raises(cw.Refused, match=f"not differentiated again, here with respect to {FLOOR}"):
        once.sum().backward()
    for second in (torch.func.hessian(loss), torch.func.jacrev(torch.func.grad(loss))):
        with pytest.raises(cw.Refused, match="again"):
            second(colour.detach())


def test_what_is_kept(leaf: cw.Scene) -> None:
    """One copy, as long as there is the scene."""
    from capwalk._functional import _KEPT

    gc.collect()
    count = len(_KEPT)
    colour = torch.tensor(cw.traverse(leaf)[FLOOR], requires_grad=True)
    for _ in range(3):
        capwalk.torch.render(leaf, {FLOOR: colour}, spp=1).sum().backward()
    assert len(_KEPT) == count + 1
    assert [len(copies) for copies in _KEPT[leaf].spare.values()] == [1]
    other = leaf.copy()
    image = capwalk.torch.render(other, {FLOOR: colour}, spp=1)
    del other
    gc.collect()
    assert len(_KEPT) == count + 1
    # The image still knows what it is of.
    image.sum().backward()


ONES = torch.ones(3)
WRONG: list[tuple[dict[str, object], dict[str, object], type[Exception], str]] = [
    ({FLOOR: np.ones(3)}, {}, TypeError, f"{FLOOR} is a ndarray; expected a tensor"),
    ({FLOOR: 0.5}, {}, TypeError, "expected a tensor"),
    ({FLOOR: torch.ones(3, dtype=torch.int64)}, {}, cw.ArgumentError, "torch.int64.*float32"),
    ({FLOOR: torch.ones(3, dtype=torch.float16)}, {}, cw.ArgumentError, "torch.float16"),
    ({FLOOR: ONES.to_sparse()}, {}, cw.ArgumentError, "sparse.*expected a dense"),
    ({FLOOR: ONES.to("meta")}, {}, cw.ArgumentError, "on the device meta"),
    ({FLOOR: torch.ones(2)}, {}, cw.ArgumentError, r"shape \(3,\); found \(2,\)"),
    ({LEAF: torch.ones(1, 9)}, {}, cw.ArgumentError, r"shape \(3, 3\); found \(1, 9\)"),
    ({FLOOR: ONES * np.nan}, {}, cw.ParameterError, f"number 0 of .{FLOOR}. would be NaN"),
    ({FLOOR: -ONES}, {}, cw.Error, "floor"),
    ({"leaf.position": ONES}, {}, cw.ParameterError, "did you mean `leaf.positions`"),
    ({"leaf.translate.x": ONES}, {}, cw.ParameterError, '"leaf.to_world" and "leaf.positions"'),
    ({"sensor.rotate.x": ONES}, {}, cw.ParameterError, '"sensor.rotate" and "sensor.to_world"'),
    ({f"{LEAF}[0,0]": ONES}, {}, cw.ParameterError, "name an array"),
    (
        {LEAF: torch.ones(3, 3), "leaf.to_world": torch.eye(4)},
        {},
        cw.ArgumentError,
        "leaf.to_world and leaf.positions both place leaf",
    ),
    (
        {LEAF: torch.ones(3, 3), "leaf.translate": ONES},
        {},
        cw.ArgumentError,
        "leaf.translate and leaf.positions both place leaf",
    ),
    ({}, {"seed": 3, "seed_grad": 3}, cw.ArgumentError, "both 3; .* biased"),
    ({}, {"seed": -1}, cw.ArgumentError, "seed is -1"),
    ({}, {"seed_grad": 2**64}, cw.ArgumentError, "seed_grad is"),
    ({}, {"spp": 0}, cw.ArgumentError, "spp is 0"),
    ({}, {"spp_grad": 0}, cw.ArgumentError, "spp_grad is 0"),
]


@pytest.mark.parametrize("case", range(len(WRONG)))
def test_wrong_input(leaf: cw.Scene, case: int) -> None:
    params, options, kind, message = WRONG[case]
    with pytest.raises(kind, match=message):
        capwalk.torch.render(leaf, params, **options)
    # The next is not worse for it.
    capwalk.torch.render(leaf, tensors(leaf, FLOOR), spp=1)


@pytest.mark.skipif(not torch.cuda.is_available(), reason="there is no GPU")
def test_devices(leaf: cw.Scene) -> None:
    """Tensors are moved, and what comes of them is moved back."""
    on_cpu = tensors(leaf, LEAF, FLOOR)
    on_gpu = {name: value.cuda().requires_grad_() for name, value in on_cpu.items()}
    image = capwalk.torch.render(leaf, on_gpu, spp=2, seed=SEED)
    assert image.is_cuda
    assert np.array_equal(image.detach().cpu(), cw.render(leaf, spp=2, seed=SEED))
    image.sum().backward()
    assert all(value.grad.is_cuda for value in on_gpu.values())
    mixed = {LEAF: on_gpu[LEAF], FLOOR: on_gpu[FLOOR].cpu()}
    with pytest.raises(cw.ArgumentError, match="several devices"):
        capwalk.torch.render(leaf, mixed)


def test_the_example() -> None:
    assert doctest.testmod(capwalk.torch).failed == 0


def noisy(x: torch.Tensor, loss: object, sigma: float) -> object:
    """A function of samples and a seed: a loss whose gradient has an error of `sigma` for one sample."""

    def loss_of(spp: int, seed: int) -> torch.Tensor:
        noise = torch.randn(len(x), generator=torch.Generator().manual_seed(seed), dtype=x.dtype)
        return loss(x) + sigma / spp**0.5 * (noise * x).sum()

    return loss_of


def scheduled(loss: object, start: float, sigma: float, steps: int, **options: object) -> object:
    """A scheduler after some steps of gradient descent, and its counts."""
    x = torch.tensor([start], dtype=torch.float64, requires_grad=True)
    optimizer = torch.optim.SGD([x], lr=0.1)
    scheduler, counts = capwalk.torch.SampleScheduler(optimizer, **options), []
    for _ in range(steps):
        scheduler.step(noisy(x, loss, sigma))
        counts.append(scheduler.spp)
        if scheduler.no_descent:
            break
    return scheduler, counts, x.item()


@pytest.mark.parametrize("batches", [2, 4])
@pytest.mark.parametrize("sigma", [30.0, 60.0])
def test_samples_are_those_of_the_theory(batches: int, sigma: float) -> None:
    """Along a slope of 1, steps of the rate r are r times a gradient with the variance v = sigma**2 / n.
    Descents are r, with the variance r**2 v (1 + v). The mean of 20 has the relative error `theta` if
    v (1 + v) is 20 theta**2."""
    scheduler, counts, _ = scheduled(
        torch.sum, 0.0, sigma, 2000, spp=64, theta=0.5, most=2**16, batches=batches
    )
    assert scheduler.no_descent is None
    variance = ((1 + 4 * 20 * 0.5**2) ** 0.5 - 1) / 2
    # Between what is enough and twice that.
    assert 0.5 < np.median(counts[200:]) / (2**0.5 * sigma**2 / variance) < 2
    assert all(count % batches == 0 for count in counts)


def test_schedulers_stop_at_the_optimum() -> None:
    """Few samples far away, the most at the end, and then there is no descent."""
    scheduler, counts, x = scheduled(lambda x: 0.5 * x.square().sum(), 5.0, 1.0, 1000, spp=8, most=256)
    assert max(counts[:60]) <= 8 and counts[-1] == 256
    found = scheduler.no_descent
    assert found.steps == 40 and found.mean <= found.error
    assert len(counts) < 500 and abs(x) < 0.1


def test_schedulers_take_the_mean_of_their_batches() -> None:
    """Each with a seed of its own; and a descent by the step before, at its full rate."""
    x = torch.tensor([2.0, 1.0], requires_grad=True)
    optimizer = torch.optim.SGD([x], lr=0.5)
    rates = torch.optim.lr_scheduler.LambdaLR(optimizer, lambda step: 0.5**step)
    scheduler = capwalk.torch.SampleScheduler(optimizer, spp=12, batches=3, seed=7)
    seeds = []

    def loss_of(spp: int, seed: int) -> torch.Tensor:
        seeds.append((spp, seed))
        return seed * x[0]

    assert scheduler.step(loss_of) == pytest.approx(2 * 8)
    assert seeds == [(4, 7), (4, 8), (4, 9)] and np.isnan(scheduler.descent)
    assert x.tolist() == [2.0 - 0.5 * 8, 1.0]
    rates.step()
    scheduler.step(loss_of)
    # 11 times the step of 4.
    assert scheduler.descent == pytest.approx(44) and x[0].item() == pytest.approx(-2 - 0.25 * 11)
    assert scheduler.descent_stderr == pytest.approx(4 / 3**0.5)
    scheduler.step(loss_of)
    assert scheduler.descent == pytest.approx(14 * 5.5)
    before = x.detach().clone()
    with pytest.raises(cw.ArgumentError, match="NaN"):
        scheduler.step(lambda spp, seed: x.sum() * float("nan"))
    assert torch.equal(x, before)


def test_a_shift_is_found_with_samples_that_follow_the_noise(leaf: cw.Scene) -> None:
    """Until there is no descent any more; in the same steps whenever it is run."""
    target = torch.from_numpy(cw.render(leaf, spp=1024, seed=2**40).value)
    [positions] = tensors(leaf, LEAF).values()

    def run() -> object:
        shift = torch.tensor([0.2, 0.0, 0.0], dtype=torch.float64, requires_grad=True)

        def loss_of(spp: int, seed: int) -> torch.Tensor:
            image = capwalk.torch.render(leaf, {LEAF: positions + shift}, spp=spp, seed=seed)
            return (image - target).square().mean()

        scheduler = capwalk.torch.SampleScheduler(torch.optim.Adam([shift], lr=0.02), spp=4, most=32)
        counts = []
        while scheduler.no_descent is None and len(counts) < 300:
            scheduler.step(loss_of)
            counts.append(scheduler.spp)
        return shift.detach(), counts

    shift, counts = run()
    assert counts[:20] == [4] * 20 and max(counts) == 32 and len(counts) < 300
    assert shift.norm() < 0.04
    again, counts_again = run()
    assert counts == counts_again and torch.equal(shift, again)


def test_schedulers_refuse_wrong_numbers() -> None:
    optimizer = torch.optim.SGD([torch.zeros(1, requires_grad=True)], lr=0.1)
    for options, message in [
        ({"spp": 3}, "spp is 3"),
        ({"spp": 8, "most": 7}, "most is 7"),
        ({"spp": 8, "batches": 1}, "batches is 1"),
        ({"spp": 8, "theta": 0.0}, "theta is 0"),
        ({"spp": 8, "seed": -1}, "seed is -1"),
    ]:
        with pytest.raises(cw.ArgumentError, match=message):
            capwalk.torch.SampleScheduler(optimizer, **options)
