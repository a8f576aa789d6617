"""What several tests use."""

from __future__ import annotations

import signal

import pytest

import capwalk as cw

SCENE = """<scene version="3.0.0">
    <default name="width" value="24"/>
    <default name="spp" value="16"/>
    <integrator type="direct"/>
    <sensor type="perspective">
        <float name="fov" value="40"/>
        <transform name="to_world">
            <lookat origin="0, 3, 6" target="0, 0.5, 0" up="0, 1, 0"/>
        </transform>
        <film type="hdrfilm">
            <integer name="width" value="$width"/>
            <integer name="height" value="18"/>
            <rfilter type="box"/>
        </film>
        <sampler type="independent"><integer name="sample_count" value="$spp"/></sampler>
    </sensor>
    <shape type="rectangle" id="floor">
        <transform name="to_world"><rotate x="1" angle="-90"/><scale value="4"/></transform>
        <bsdf type="diffuse"><rgb name="reflectance" value="0.7, 0.5, 0.3"/></bsdf>
    </shape>
    <shape type="cube" id="box">
        <transform name="to_world"><scale value="0.5"/><translate y="1.2"/></transform>
        <bsdf type="diffuse"><rgb name="reflectance" value="0.2, 0.5, 0.8"/></bsdf>
    </shape>
    <shape type="rectangle" id="lamp">
        <transform name="to_world"><rotate x="1" angle="90"/><translate y="5"/></transform>
        <emitter type="area"><rgb name="radiance" value="10"/></emitter>
    </shape>
</scene>"""


@pytest.fixture(autouse=True)
def interruptible() -> None:
    """Ctrl-C is what tests of it mean, also in what was started in the background, where a shell
    has it ignored."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture
def scene() -> cw.Scene:
    """A box above a floor, in 24 x 18 pixels."""
    return cw.load_string(SCENE)
