"""Remeshing of surfaces that an optimisation moves."""

from __future__ import annotations

import os
import sys
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray

import capwalk as cw

Array = NDArray[np.float64]

gpytoolbox: Any = pytest.importorskip("gpytoolbox")


def square(count: int) -> tuple[Array, NDArray[Any]]:
    """A flat mesh of count x count vertices from -1 to 1, with an open border."""
    vertices, faces = gpytoolbox.regular_square_mesh(count)
    return np.column_stack([vertices, np.zeros(len(vertices))]), np.asarray(faces, np.int64)


def sphere(level: int) -> tuple[Array, NDArray[Any]]:
    vertices, faces = gpytoolbox.icosphere(level)
    return np.asarray(vertices), np.asarray(faces, np.int64)


def edge_lengths(positions: Array, faces: NDArray[Any]) -> Array:
    corners = positions[faces]
    lengths: Array = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    return lengths.ravel()


def shapes_of(positions: Array, faces: NDArray[Any]) -> Array:
    """4 √3 area / (sum of squares of the sides): 1 for an equilateral triangle, 0 for one without area."""
    a, b, c = np.moveaxis(positions[faces], 1, 0)
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    sides = np.square(edge_lengths(positions, faces)).reshape(-1, 3).sum(axis=1)
    shapes: Array = 4 * np.sqrt(3) * area / sides
    return shapes


@pytest.mark.parametrize("edge_length", [0.1, 0.25, 0.7])
def test_linear_functions_on_flat_meshes_are_exact(edge_length: float) -> None:
    x, faces = square(9)
    # Old triangles of uneven size.
    x[:, :2] += 0.3 * np.sin(2.0 * x[:, 1::-1]) * (1 - x[:, :1] ** 2) * (1 - x[:, 1:2] ** 2)
    y, new_faces, transfer = cw.remesh(x, faces, edge_length)
    assert len(y) != len(x)
    matrix = np.random.default_rng(1).normal(size=(3, 5))
    np.testing.assert_allclose(transfer(x @ matrix + 2.0), y @ matrix + 2.0, atol=1e-12)
    np.testing.assert_allclose(transfer(x[:, 0]), y[:, 0], atol=1e-12)
    assert transfer(np.ones((len(x), 2, 2))).shape == (len(y), 2, 2)


@pytest.mark.parametrize("edge_length", [0.15, 0.6])
def test_rows_of_weights_are_barycentric(edge_length: float) -> None:
    x, faces = sphere(2)
    y, _, transfer = cw.remesh(x, faces, edge_length)
    assert transfer.weights.shape == transfer.vertices.shape == (len(y), 3)
    assert (transfer.weights >= 0).all()
    np.testing.assert_allclose(transfer.weights.sum(axis=1), 1, rtol=1e-14)
    # Each at the corners of an old face, and at the place of its new vertex.
    corners = {tuple(sorted(face)) for face in faces.tolist()}
    assert {tuple(sorted(face)) for face in transfer.vertices.tolist()} <= corners
    np.testing.assert_allclose(transfer(x), y, atol=1e-12)


def test_edges_get_the_length() -> None:
    x, faces = sphere(2)
    # One half of it stretched, as an optimisation would.
    x[:, 2] *= np.where(x[:, 2] > 0, 4, 1)
    y, new_faces, _ = cw.remesh(x, faces, 0.2)
    assert new_faces.dtype == np.uint32
    assert np.percentile(shapes_of(x, faces), 5) < 0.6 < 0.85 < np.percentile(shapes_of(y, new_faces), 5)
    lengths = edge_lengths(y, new_faces)
    assert ((lengths > 0.8 * 0.2) & (lengths < 0.2 * 4 / 3)).mean() > 0.9


@pytest.mark.parametrize("edge_length", [0.1, 0.8])
def test_borders_are_kept(edge_length: float) -> None:
    x, faces = square(6)
    y, new_faces, _ = cw.remesh(x, faces, edge_length)

    def border(positions: Array, triangles: NDArray[Any]) -> set[tuple[tuple[float, ...], ...]]:
        edges = np.sort(np.stack([triangles, np.roll(triangles, 1, axis=1)], 2).reshape(-1, 2), axis=1)
        found, count = np.unique(edges, axis=0, return_counts=True)
        ends = positions[found[count == 1]] + 0.0
        return {tuple(sorted(tuple(end) for end in edge)) for edge in ends.tolist()}

    assert len(border(x, faces)) == 20
    assert border(y, new_faces) == border(x, faces)


def test_seams_and_poles_become_one_surface() -> None:
    """Of a sphere with two vertices at each place of a seam, many at a pole, faces without area there,
    and a vertex without faces."""
    rows, columns = 9, 13
    v, u = (i.ravel() for i in np.mgrid[:rows, :columns])
    theta, phi = np.pi * v / (rows - 1), 2 * np.pi * (u % (columns - 1)) / (columns - 1)
    ring = np.where((v == 0) | (v == rows - 1), 0, np.sin(theta))
    x = np.column_stack([ring * np.cos(phi), ring * np.sin(phi), np.cos(theta)])
    a = np.flatnonzero((v < rows - 1) & (u < columns - 1))
    b, c, d = a + columns, a + columns + 1, a + 1
    faces = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    x = np.vstack([x, [5.0, 5.0, 5.0]])
    y, new_faces, transfer = cw.remesh(x, faces, 0.3)
    ends = np.sort(np.stack([new_faces, np.roll(new_faces, 1, axis=1)], 2).reshape(-1, 2), axis=1)
    assert (np.unique(ends, axis=0, return_counts=True)[1] == 2).all()
    np.testing.assert_allclose(transfer(x), y, atol=1e-12)
    # One row for each node of large steps does as well; λ = 0 has the positions of the nodes.
    nodes = cw.LargeSteps(x, faces, 0.0).to_differential(x)
    assert len(nodes) == (rows - 2) * (columns - 1) + 3 < len(x)
    np.testing.assert_allclose(transfer(nodes), y, atol=1e-12)
    with pytest.raises(cw.ArgumentError, match=rf"\(5,\); expected {len(x)} rows, or {len(nodes)} for"):
        transfer(np.ones(5))


def test_adam_goes_on_with_interpolated_means() -> None:
    x, faces = sphere(1)
    gradient = np.random.default_rng(2).normal(size=x.shape)
    adam, values = cw.Adam(lr=0.01), {"x": x}
    adam.transfer("x", lambda means: means[:1])  # No step yet, so nothing to transfer.
    adam.step(values, {"x": gradient})
    y, _, transfer = cw.remesh(values["x"], faces, 0.3)
    adam.transfer("x", transfer)
    adam.step({"x": y}, {"x": np.zeros_like(y)})
    count, first, second = adam._means["x"]
    assert count == 2
    np.testing.assert_allclose(first, 0.9 * transfer(0.1 * gradient), rtol=1e-12, atol=1e-15)
    np.testing.assert_allclose(second, 0.999 * transfer(0.001 * gradient**2), rtol=1e-12)


def test_adam_says_what_is_missing_after_remeshing() -> None:
    adam, values = cw.Adam(lr=0.01), {"x": np.ones((4, 3))}
    adam.step(values, {"x": np.ones((4, 3))})
    with pytest.raises(cw.ArgumentError, match="after remeshing, call transfer"):
        adam.step({"x": np.ones((5, 3))}, {"x": np.ones((5, 3))})


TETRAHEDRON = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])
CLOSED = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]


@pytest.mark.parametrize(
    ("positions", "faces", "options", "message"),
    [
        (TETRAHEDRON, CLOSED, {"edge_length": 0.0}, "edge_length is 0.0; expected"),
        (TETRAHEDRON, CLOSED, {"edge_length": np.nan}, "edge_length is nan; expected"),
        (TETRAHEDRON, CLOSED, {"edge_length": 1e-6}, r"about 5.5e\+12 faces; expected at most 1e\+08"),
        (TETRAHEDRON, CLOSED, {"iterations": 0}, "iterations is 0; expected"),
        (TETRAHEDRON + np.inf, CLOSED, {}, "positions has infinite numbers or NaN"),
        (TETRAHEDRON[:, :2], CLOSED, {}, "positions has the shape .5, 2.; expected rows of three"),
        (TETRAHEDRON, [[0, 1, 5]], {}, "faces name vertices beyond the 5"),
        (TETRAHEDRON, [[0, 1, 1]], {}, "no face with three different corners"),
        (TETRAHEDRON, np.zeros((0, 3), int), {}, "no face with three different corners"),
        (TETRAHEDRON, [*CLOSED, [0, 1, 4]], {}, r"3 faces meet at the edge between vertices 0 at \(0, 0, 0\) and 1"),
        (TETRAHEDRON, [[0, 1, 2], [0, 1, 3]], {}, "both faces at the edge between vertices 0 .* and 1"),
        (TETRAHEDRON, [[0, 1, 2], [0, 3, 4]], {}, r"2 sheets meet only at vertex 0 at \(0, 0, 0\)"),
    ],
)  # fmt: skip
def test_wrong_arguments(
    positions: ArrayLike, faces: ArrayLike, options: dict[str, Any], message: str
) -> None:
    with pytest.raises(cw.ArgumentError, match=message):
        cw.remesh(positions, faces, **({"edge_length": 0.5} | options))


def test_vertices_that_the_library_did_not_set_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    for unset in (1e300, np.nan, 0.0):

        def remeshed(old: Array, faces: Any, *_: Any, unset: float = unset) -> Any:
            return np.vstack([old[:-1], [[unset] * 3]]), faces

        monkeypatch.setattr(gpytoolbox, "remesh_botsch", remeshed)
        with pytest.raises(cw.ArgumentError, match="no mesh on this surface with the edge_length 0.5"):
            cw.remesh(*sphere(1), 0.5)


def test_without_the_library_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "gpytoolbox", None)
    with pytest.raises(ImportError, match=r"pip install 'capwalk\[remesh\]'"):
        cw.remesh(TETRAHEDRON, CLOSED, 0.5)


VIEWS: dict[str, list[float]] = {"front": [0, 0, 6], "side": [6, 0, 0.1], "back": [0, 1, -6]}

SIZE, STEPS, REMESHED = 16, 30, range(5, 30, 5)
"""Of the images, of each optimisation, and of these those that begin with remeshing."""


def seen(positions: Array, faces: NDArray[Any]) -> cw.Scene:
    """A blob under a lamp and a sky, from three sides."""
    transform = cw.Transform
    lamp = transform().look_at([3, 4, 6], [0, 0, 0], [0, 1, 0])
    area = {"type": "area", "radiance": 25}
    shape = {"positions": positions, "faces": faces, "bsdf": {"type": "diffuse"}}
    scene: dict[str, object] = {
        "type": "scene",
        "integrator": {"type": "direct"},
        "sky": {"type": "constant", "radiance": 0.3},
        "lamp": {"type": "rectangle", "to_world": lamp, "emitter": area},
        "blob": {"type": "mesh", **shape},
    }
    for name, origin in VIEWS.items():
        to_world = transform().look_at(origin, [0, 0, 0], [0, 1, 0])
        scene[name] = {"type": "perspective", "fov": 32, "to_world": to_world}
    loaded = cw.load_dict(scene)
    loaded.resize(SIZE, SIZE)
    return loaded


def test_a_blob_is_found_with_a_smaller_loss_if_the_state_is_transferred() -> None:
    """From three images, a sphere becomes a body with three lobes. Paired over seeds, the loss is smaller
    with the transfer than with a new Adam after each remeshing, than with means at the wrong vertices
    (where CAPWALK_THOROUGH is set), and than without remeshing, where triangles degenerate. The edges have
    the length of those at the start, so that no way has more unknowns."""
    x, faces = sphere(4)
    lobes = 1 + 0.35 * np.cos(3 * np.arctan2(x[:, 1], x[:, 0])) * (1 - x[:, 2] ** 2)
    truth, name = seen(x * lobes[:, None], faces), "blob.positions"
    targets = [cw.render(truth, spp=128, seed=1, sensor=view).value for view in VIEWS]

    def found(seed: int, way: str) -> tuple[float, float]:
        """The loss, and the shape of the thinnest triangles, in the end."""
        values, adam = {name: sphere(2)[0]}, cw.Adam(lr=0.03)
        faces = sphere(2)[1]
        scene = seen(values[name], faces)
        for step in range(STEPS):
            if way != "none" and step in REMESHED:
                values[name], faces, transfer = cw.remesh(values[name], faces, 0.32)
                scene = seen(values[name], faces)
                if way == "transfer":
                    adam.transfer(name, transfer)
                elif way == "wrong vertices":
                    adam.transfer(name, lambda means, f=transfer: f(means)[::-1])  # type: ignore[misc]
                else:
                    adam = cw.Adam(lr=0.03)
            total = np.zeros_like(values[name])
            for i, (view, target) in enumerate(zip(VIEWS, targets, strict=True)):
                first = 2 + 2 * (3 * (STEPS * seed + step) + i)
                image = cw.render(scene, spp=2, seed=first, sensor=view).value
                adjoint = 2 * (image - target) / image.size
                grads = cw.backward(scene, adjoint, [name], spp=2, seed=first + 1, sensor=view)
                total += grads[name]
            adam.step(values, {name: total})
            cw.traverse(scene).update(values)
        images = [cw.render(scene, spp=32, seed=0, sensor=view).value for view in VIEWS]
        loss = np.square(np.stack(images) - targets).mean()
        return float(loss), float(np.percentile(shapes_of(values[name], faces), 5))

    # Seeds: what a new state loses is 1.8 standard deviations of one of them. The state of wrong vertices
    # is not much worse, which takes a minute to see.
    ways = {"none": 3, "new Adam": 8, "transfer": 8}
    if "CAPWALK_THOROUGH" in os.environ:
        ways.update({"wrong vertices": 14, "transfer": 14})
    results = {way: np.array([found(seed, way) for seed in range(seeds)]) for way, seeds in ways.items()}
    for way in ways.keys() - {"transfer"}:
        gains = results[way][:, 0] - results["transfer"][: ways[way], 0]
        assert gains.mean() > 3 * gains.std(ddof=1) / np.sqrt(len(gains)), results
    assert (results["none"][:, 1] < 0.5).all() and (results["transfer"][:, 1] > 0.7).all(), results
