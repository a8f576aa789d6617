"""capwalk inside Mitsuba 3: an integrator ``"capwalk"`` for unchanged scripts.

>>> import mitsuba as mi, capwalk.mitsuba
>>> mi.set_variant("scalar_rgb")
>>> scene = mi.load_dict(mi.cornell_box())
>>> integrator = mi.load_dict({"type": "capwalk", "max_depth": 3})
>>> image = mi.render(scene, integrator=integrator, spp=1)
>>> image.shape
(256, 256, 3)

In the variants ``llvm_ad_rgb`` and ``cuda_ad_rgb``, ``drjit.backward`` and ``drjit.forward``
differentiate such an image without bias, geometry included, so that it can replace
``prb_projective``. The work is done on the CPU.

The integrator's options: ``max_depth`` (6), ``rr_depth`` (5) and ``hide_emitters`` (false) as for
Mitsuba's differentiable integrators; ``integrator``, ``"path"`` (the default) or ``"direct"``;
``method`` and ``threads`` as in :func:`capwalk.gradient`.

The loaded scene is converted, including all changes of its parameters. An object that cannot be
converted exactly raises a :class:`capwalk.LoadError` with its name. (If Dr.Jit records derivatives,
``mitsuba.render`` raises a ``RuntimeError`` with this as its cause.) A derivative that capwalk
could only estimate with a bias raises :class:`capwalk.Refused`, and a parameter without a
derivative :class:`capwalk.ParameterError`, when the derivative is computed.
"""

from __future__ import annotations

from typing import Any

import mitsuba as mi

from .. import _capwalk
from .._dictionary import load_dict
from ._convert import convert
from ._converted import Description
from ._integrator import integrator_class

__all__ = ["to_capwalk"]


def to_capwalk(
    scene: Any, sensor: Any = 0, integrator: Description | None = None
) -> _capwalk.Scene:
    """A loaded scene of Mitsuba, with one sensor, as a scene of capwalk.

    >>> import mitsuba as mi, capwalk as cw, capwalk.mitsuba
    >>> mi.set_variant("scalar_rgb")
    >>> scene = capwalk.mitsuba.to_capwalk(mi.load_dict(mi.cornell_box()))
    >>> "light.emitter.radiance.value" in cw.traverse(scene)
    True

    Parameters have the names that ``mitsuba.traverse`` gives them.

    :param sensor: a sensor of Mitsuba, or the number of a sensor of the scene.
    :param integrator: its dictionary; by default ``{"type": "path"}``.
    :raises LoadError: capwalk cannot render an object; the message has its name.
    """
    if isinstance(sensor, int):
        sensor = scene.sensors()[sensor]
    return load_dict(convert(scene, [sensor], integrator or {"type": "path"}).plain())


_REGISTERED: set[str] = set()


def _register(*_: object) -> None:
    """Makes the integrator known to the current variant, once."""
    variant = mi.variant()
    if variant is None or variant in _REGISTERED:
        return
    _REGISTERED.add(variant)
    made = integrator_class()
    if made is not None:
        mi.register_integrator("capwalk", lambda props: made(props))


_register()
# Mitsuba has plugins by variant.
mi.detail.add_variant_callback(_register)
