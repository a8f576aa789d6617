"""How a derivative was estimated."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Method:
    """The method of a derivative, with the settings that a pilot found. A scene keeps it for later
    calls with the same sensor, names and about as many samples. Passed as ``method`` it also
    replaces the pilot for copies of the scene and in other processes. It can be pickled for the
    same version of capwalk.

    >>> import capwalk as cw
    >>> scene = cw.load_file("leaf")
    >>> scene.resize(16, 12)
    >>> first = cw.gradient(scene, "leaf.translate.x", spp=8)
    >>> second = cw.gradient(scene, "leaf.translate.x", spp=8, seed=1, method=first.method)
    >>> first.method.name in ("walk", "edges") and first.method == second.method
    True
    """

    name: str
    """``"walk"`` or ``"edges"``."""
    settings: bytes = field(repr=False)
    """What the walk or the gathering is done with."""
