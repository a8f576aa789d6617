"""The objects of a Mitsuba scene: what each one holds, and what it is called."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import mitsuba as mi


@dataclass(frozen=True)
class Parts:
    """What an object shows to ``mitsuba.traverse``."""

    values: dict[str, Any]
    """Numbers and arrays by name, with their place in Dr.Jit's graph."""
    objects: dict[str, Any]
    """Objects inside it by name. Unlike in ``mitsuba.traverse``, shared ones are in all places."""


def parts(owner: Any) -> Parts:
    """What an object holds now."""
    collector = _collector(mi.variant())()
    owner.traverse(collector)
    values = {
        name: value if kind is None else mi.get_property(value, kind, owner)
        for name, (value, kind) in collector.values.items()
    }
    return Parts(values, collector.objects)


def paths(scene: Any) -> dict[Any, str]:
    """The names of all objects in a scene, as ``mitsuba.traverse`` calls them."""
    found: dict[Any, str] = {}
    taken: set[str] = set()

    def visit(owner: Any, prefix: str) -> None:
        for name, child in parts(owner).objects.items():
            if child is None or child in found:
                continue
            path = unique = f"{prefix}{name}"
            count = 1
            while unique in taken:
                unique = f"{path}_{count}"
                count += 1
            taken.add(unique)
            found[child] = unique
            visit(child, f"{unique}.")

    visit(scene, "")
    return found


@cache
def _collector(variant: str) -> Any:
    """The class whose methods an object of this variant calls."""

    class Collector(mi.TraversalCallback):  # type: ignore[misc, unused-ignore]
        def __init__(self) -> None:
            super().__init__()
            self.values: dict[str, tuple[Any, Any]] = {}
            self.objects: dict[str, Any] = {}

        def put(self, name: str, value: Any, flags: int, kind: Any = None) -> None:
            if isinstance(value, mi.Object):
                self.objects[name] = value
            else:
                self.values[name] = (value, kind)

    return Collector
