"""Finds the place and the colour of a box from three views of it, by all machines of a Ray
cluster: `ray start --head` on one of them, `ray start --address=...` on the others, then this
on any. Without a cluster, by the cores of this machine. Needs `pip install ray`."""

import capwalk as cw
import capwalk.ray
import numpy as np

SENSOR = """
<sensor type="perspective" id="{id}">
    <float name="fov" value="40"/>
    <transform name="to_world">
        <lookat origin="{x}, 3, 6" target="0, 0.5, 0" up="0, 1, 0"/>
    </transform>
    <film type="hdrfilm">
        <integer name="width" value="32"/><integer name="height" value="24"/>
        <rfilter type="box"/>
    </film>
</sensor>"""
SCENE = """
<scene version="3.0.0">
    <integrator type="direct"/>
    <shape type="rectangle" id="floor">
        <transform name="to_world"><rotate x="1" angle="-90"/><scale value="4"/></transform>
    </shape>
    <shape type="cube" id="box">
        <transform name="to_world"><scale value="0.5"/><translate y="1.2"/></transform>
        <bsdf type="diffuse"><rgb name="reflectance" value="0.2, 0.5, 0.8"/></bsdf>
    </shape>
    <shape type="rectangle" id="lamp">
        <transform name="to_world"><rotate x="1" angle="90"/><translate y="5"/></transform>
        <emitter type="area"><rgb name="radiance" value="10"/></emitter>
    </shape>
    {sensors}
</scene>"""
POSITIONS, COLOUR = "box.positions", "box.bsdf.reflectance.value"

sensors = [SENSOR.format(id=id, x=x) for id, x in [("left", -4), ("middle", 0), ("right", 4)]]
scene = cw.load_string(SCENE.format(sensors="".join(sensors)))
params = cw.traverse(scene)
positions, colour = params[POSITIONS].copy(), params[COLOUR].copy()
adam = cw.Adam(lr=0.03)
found = {"shift": np.array([0.25, 0.1, -0.2]), "colour": np.array([0.5, 0.5, 0.5])}

with capwalk.ray.Cluster() as cluster:
    targets = [image.value for image in cluster.render_views(scene, spp=256, seed=1000)]
    for step in range(40):
        # What each machine has of the scene already is not sent again.
        params.update({POSITIONS: positions + found["shift"], COLOUR: found["colour"]})
        # The images and the gradient have random numbers of their own.
        images = cluster.render_views(scene, spp=32, seed=2 * step)
        adjoints = [2 * (image.value - target) for image, target in zip(images, targets)]
        gradients = cluster.backward_views(
            scene, adjoints, [POSITIONS, COLOUR], spp=32, seed=2 * step + 1
        )
        # The box moves as a whole.
        shift = gradients[POSITIONS].sum(axis=0)
        adam.step(found, {"shift": shift, "colour": gradients[COLOUR]})
        away, off = np.linalg.norm(found["shift"]), np.abs(found["colour"] - colour).max()
        print(f"step {step + 1:2}: {away:.3f} units away, colour off by {off:.3f}")
