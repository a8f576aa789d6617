# Derivatives by Mitsuba's projective sampling: python3 projective.py
# SCENE.xml SHAPE AXIS INTEGRATOR MAX_DEPTH SPP SEEDS OUTPUT
# Writes little-endian float32, for each seed the pixels: of the derivative to
# OUTPUT, of the image to OUTPUT.image. Prints the seconds of the CPU.
import struct
import sys
import time

import drjit as dr
import mitsuba as mi

scene_file, shape, axis, integrator, depth, spp, seeds, output = sys.argv[1:]
mi.set_variant("llvm_ad_rgb")
scene = mi.load_file(scene_file)
params = mi.traverse(scene)
key = shape + ".vertex_positions"
start = dr.detach(params[key])
unit = [0.0, 0.0, 0.0]
unit[int(axis)] = 1.0
settings = {"type": integrator, "sppc": int(spp), "sppp": int(spp), "sppi": int(spp)}
if integrator != "direct_projective":
    settings["max_depth"] = int(depth)
method = mi.load_dict(settings)

def write(file, image):
    numbers = list(image.array)
    file.write(struct.pack("<%df" % len(numbers), *numbers))


with open(output, "wb") as derivatives, open(output + ".image", "wb") as images:
    for seed in range(int(seeds)):
        amount = mi.Float(0.0)
        dr.enable_grad(amount)
        points = dr.unravel(mi.Point3f, start) + amount * mi.Vector3f(unit)
        params[key] = dr.ravel(points)
        params.update()
        image = mi.render(scene, params, integrator=method, spp=int(spp), seed=1000 + seed, seed_grad=2000 + seed)
        dr.forward(amount)
        write(derivatives, dr.grad(image))
        write(images, dr.detach(image))

# On a line of its own: Mitsuba's warnings end with a colour and no line feed.
print()
print(time.process_time())
