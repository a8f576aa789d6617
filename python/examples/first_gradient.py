"""How does every pixel change when the leaf moves? Writes gradient.png: red gets brighter,
blue darker."""

import capwalk as cw

scene = cw.load_file("leaf")  # a Mitsuba 3 XML file, or a built-in scene
scene.resize(128, 96)
derivative = cw.gradient(scene, "leaf.translate.x", spp=64, progress=True)
derivative.save("gradient.png")
print(derivative)
print(cw.check(scene, "leaf.translate.x", spp=64))
