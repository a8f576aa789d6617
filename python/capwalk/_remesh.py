"""Triangles of even size on a surface that an optimisation has moved."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._numbers import Array, numbers
from ._steps import triangles_of, vertices_of
from .errors import ArgumentError

Integers = NDArray[np.int64]

MOST_FACES = 1e8
"""As many faces as a mesh may get; the library counts in 32 bits."""

OFF = 1e-6
"""How far from the old surface new vertices may be, in parts of its extent."""


class Transfer:
    """Interpolates arrays per vertex of a mesh at the vertices of the mesh that :func:`remesh` made of
    it: linearly, at the point of the old surface that is closest to each new vertex."""

    vertices: Integers
    """(N, 3), for each new vertex the corners of the old face with its closest point."""
    weights: Array
    """(N, 3), the barycentric coordinates of this point: at least 0, with the sum 1."""

    def __init__(self, vertices: Integers, weights: Array, nodes: Integers) -> None:
        self.vertices, self.weights = vertices, weights
        self._nodes, self._count = nodes, int(nodes.max()) + 1

    def __call__(self, values: ArrayLike) -> Array:
        """(N, ...), for the N vertices of the new mesh.

        :param values: (V, ...), for the V vertices of the old mesh, or one row for each node of
            :class:`LargeSteps`, whose nodes are the vertices at different positions.
        :raises ArgumentError: another number of rows.
        """
        array = numbers("the array", values)
        rows = array.shape[0] if array.ndim else 0
        if rows == len(self._nodes):
            vertices = self.vertices
        elif rows == self._count:
            vertices = self._nodes[self.vertices]
        else:
            text = f"the array has the shape {array.shape}; expected {len(self._nodes)} rows"
            merged = f", or {self._count} for vertices at different positions"
            raise ArgumentError(text + (merged if self._count < len(self._nodes) else ""))
        interpolated: Array = np.einsum("nk,nk...->n...", self.weights, array[vertices])
        return interpolated


def remesh(
    positions: ArrayLike, faces: ArrayLike, edge_length: float, *, iterations: int = 10
) -> tuple[Array, NDArray[np.uint32], Transfer]:
    """Meshes a surface anew, with edges of about one length (Botsch and Kobbelt 2004): for an
    optimisation whose triangles get too large or too thin as the surface moves. Needs gpytoolbox, whose
    ``remesh_botsch`` does it: ``pip install 'capwalk[remesh]'``.

    The new vertices lie on the old surface. Vertices at the same position become one, so seams of
    texture coordinates are lost. The border of an open mesh is kept: all of its vertices stay where they
    are, and none are added. Sharp edges are not kept.

    In a loop of :class:`Adam` over ``values["u"]``, the variable of :class:`LargeSteps`::

        x, faces, transfer = cw.remesh(x, faces, 0.2)
        adam.transfer("u", transfer)
        large = cw.LargeSteps(x, faces)
        values["u"] = large.to_differential(x)

    Without large steps the variable is ``x`` itself. The scene gets the new mesh by
    :func:`load_dict`.

    :param positions: (V, 3), world units.
    :param faces: (F, 3), numbers of vertices. At each edge at most two faces meet, wound the same way.
    :param edge_length: of the new edges, world units. Most are between 4/5 and 4/3 of it.
    :param iterations: rounds of splits, collapses and flips of edges and of smoothing within the surface.
    :return: the new positions, the new faces, and a :class:`Transfer` for arrays of the old vertices.
    :raises ImportError: gpytoolbox is not installed.
    :raises ArgumentError: the mesh is not manifold, or a wrong argument.
    """
    vertices = vertices_of("positions", positions)
    triangles = triangles_of(faces, len(vertices))
    if not (np.isfinite(edge_length) and edge_length > 0.0):
        raise ArgumentError(f"edge_length is {edge_length}; expected a finite number above 0")
    if iterations < 1:
        raise ArgumentError(f"iterations is {iterations}; expected at least 1")
    # Adding 0 makes -0 and 0 the same, here as in LargeSteps.
    _, first, same = np.unique(vertices + 0.0, axis=0, return_index=True, return_inverse=True)
    first_of = first[same.ravel()]
    merged = first_of[triangles]
    # At the pole of a sphere faces have no area.
    merged = merged[(merged != np.roll(merged, 1, axis=1)).all(axis=1)]
    if len(merged) == 0:
        raise ArgumentError("the mesh has no face with three different corners")
    _check_manifold(merged, vertices)
    corners = vertices[merged]
    sides = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = 0.5 * np.linalg.norm(sides, axis=1).sum()
    expected = area / (np.sqrt(0.1875) * edge_length**2)
    if not expected < MOST_FACES:
        text = f"with the edge_length {edge_length} there would be about {expected:.1e} faces"
        raise ArgumentError(f"{text}; expected at most {MOST_FACES:.0e}")
    try:
        import gpytoolbox  # type: ignore[import-not-found, import-untyped, unused-ignore]
    except ImportError as error:
        raise ImportError("remesh needs gpytoolbox: pip install 'capwalk[remesh]'") from error
    used, compact = np.unique(merged, return_inverse=True)
    old, compact = vertices[used], compact.reshape(-1, 3).astype(np.int32)
    library: Any = gpytoolbox
    new, new_faces = library.remesh_botsch(old, compact, int(iterations), float(edge_length), True)
    squared, closest, weights = library.squared_distance(
        new, old, F=compact, use_cpp=True, use_aabb=True
    )
    # Where too little is left, version 0.3.8 may return vertices that were never set.
    if not (np.sqrt(squared) <= OFF * np.ptp(old, axis=0).max()).all():
        text = f"gpytoolbox finds no mesh on this surface with the edge_length {edge_length}"
        raise ArgumentError(f"{text}; try a smaller one")
    weights = np.clip(weights, 0.0, 1.0)
    weights /= weights.sum(axis=1, keepdims=True)
    # Nodes have the order of their first vertices.
    nodes = np.unique(first_of, return_inverse=True)[1].ravel()
    transfer = Transfer(used[compact[closest]], weights, nodes)
    return new, new_faces.astype(np.uint32), transfer


def _check_manifold(faces: Integers, vertices: Array) -> None:
    """Raises an error that names an edge or a vertex where the surface is not manifold."""
    sides = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
    edges, edge_of, count = np.unique(
        np.sort(sides, axis=1), axis=0, return_inverse=True, return_counts=True
    )
    edge_of = edge_of.ravel()
    if count.max() > 2:
        i = int(count.argmax())
        text = f"{count[i]} faces meet at the edge {_edge(edges[i], vertices)}"
        raise ArgumentError(f"the mesh is not manifold: {text}; expected at most 2")
    _, found, times = np.unique(sides, axis=0, return_index=True, return_counts=True)
    if times.max() > 1:
        edge = _edge(sides[found[times.argmax()]], vertices)
        text = f"both faces at the edge {edge} have it in the same direction"
        raise ArgumentError(f"the mesh is not oriented: {text}; turn one of them over")
    # Corners at a vertex are joined if their faces share an edge there; all of them have to be.
    corner = np.arange(3 * len(faces))
    after = corner - corner % 3 + (corner + 1) % 3
    inner = np.flatnonzero(count[edge_of] == 2)
    one, two = inner[np.argsort(edge_of[inner], kind="stable")].reshape(-1, 2).T
    pairs = np.concatenate([np.stack([one, after[two]], 1), np.stack([after[one], two], 1)])
    label = corner.copy()
    while True:
        lowest = label.copy()
        np.minimum.at(lowest, pairs[:, 0], label[pairs[:, 1]])
        np.minimum.at(lowest, pairs[:, 1], label[pairs[:, 0]])
        if (lowest == label).all():
            break
        label = lowest[lowest]
    fans = np.flatnonzero(label == corner)
    owners, times = np.unique(faces.ravel()[fans], return_counts=True)
    if times.max() > 1:
        vertex = owners[times.argmax()]
        text = f"{times.max()} sheets meet only at vertex {vertex} at {_point(vertices[vertex])}"
        raise ArgumentError(f"the mesh is not manifold: {text}")


def _edge(ends: Integers, vertices: Array) -> str:
    one, two = (f"{vertex} at {_point(vertices[vertex])}" for vertex in ends)
    return f"between vertices {one} and {two}"


def _point(position: Array) -> str:
    return f"({position[0]:.4g}, {position[1]:.4g}, {position[2]:.4g})"
