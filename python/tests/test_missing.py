"""Derivatives of which something is left out, instead of being refused."""

from __future__ import annotations

import math
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import capwalk as cw
from capwalk.parallel import Pool

SCENE = """<scene version="3.0.0"><integrator type="path"/>
<sensor type="perspective"><transform name="to_world">
<lookat origin="0, 1, 6" target="0, 0.7, 0" up="0, 1, 0"/></transform>
<film type="hdrfilm"><integer name="width" value="24"/><integer name="height" value="18"/>
<rfilter type="box"/></film>
<sampler type="independent"><integer name="sample_count" value="16"/></sampler></sensor>
<shape type="rectangle" id="floor"><transform name="to_world"><rotate x="1" angle="-90"/>
<scale value="8"/></transform></shape>
<shape type="sphere" id="ball"><point name="center" x="-0.8" y="0.8" z="0"/>
<float name="radius" value="0.6"/><bsdf type="conductor"/></shape>
<shape type="cube" id="box"><transform name="to_world"><scale value="0.3"/>
<translate x="1" y="1" z="0.5"/></transform></shape>
<emitter type="constant"/></scene>"""
BOX = "box.translate.x"


@pytest.fixture
def glossy() -> cw.Scene:
    """A box beside a mirror ball in which it is seen."""
    return cw.load_string(SCENE)


def incomplete() -> pytest.WarningsRecorder:
    return pytest.warns(cw.UnreliableWarning, match="incomplete: .*% of the radiance")


def test_what_is_missing_is_said(glossy: cw.Scene, tmp_path: Path) -> None:
    with pytest.raises(cw.Refused) as caught:
        cw.gradient(glossy, BOX)
    assert caught.value.instead is not None and "allow_missing" in caught.value.instead
    with incomplete():
        derivative = cw.gradient(glossy, BOX, allow_missing=("specular",))
    share, stderr = derivative.statistics["missing"]
    assert 0.01 < share < 0.5 and 0 < stderr < share
    assert "left out" in repr(derivative)
    derivative.save(tmp_path / "derivative.exr")
    assert b"missing_share" in (tmp_path / "derivative.exr").read_bytes()
    # A part is not right, and what is compared is not wrong.
    with incomplete():
        check = cw.check(glossy, BOX, spp=64, allow_missing="specular")
    assert (check.verdict, check.right) == ("partial", False)
    assert check.rest in ("right", "inconclusive")
    assert "left out" in str(check)
    # A colour moves no silhouette.
    colour = cw.gradient(glossy, "box.bsdf.reflectance.value.r", allow_missing=["specular"])
    assert colour.statistics["missing"] is None and "left out" not in repr(colour)


def test_losses_say_it_too(glossy: cw.Scene) -> None:
    adjoint = np.ones((18, 24, 3))
    with incomplete():
        whole = cw.backward(glossy, adjoint, [BOX], allow_missing=("specular",))
    with ThreadPoolExecutor(2) as executor:
        pool = Pool(executor)
        with incomplete():
            parts = pool.backward(glossy, adjoint, [BOX], allow_missing=("specular",))
        with incomplete():
            views = pool.backward_views(glossy, [adjoint], [BOX], allow_missing=("specular",))
    assert whole[BOX] == parts[BOX] == views[BOX]
    assert whole.statistics["missing"] == parts.statistics["missing"]
    assert math.isfinite(views.statistics["missing"][1])


def test_names_of_what_may_be_missing(glossy: cw.Scene) -> None:
    with pytest.raises(cw.ArgumentError, match='called "speculr"; there is specular'):
        cw.gradient(glossy, BOX, allow_missing=("speculr",))
    with pytest.raises(TypeError, match="expected names"):
        cw.gradient(glossy, BOX, allow_missing=(1,))  # type: ignore[arg-type]
