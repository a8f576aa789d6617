"""Prepares copies of scene files for Mitsuba 3 and capwalk, and makes the meshes, textures and
shapes that they name: files whose names begin with `made-`."""

import math
import random
import sys
import xml.etree.ElementTree as xml

import mitsuba as mi
import numpy as np

# Primitives as meshes.

CORNERS = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
CUBE_SIDES = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]

# Squares along each edge of the cube that a ball is made of: 20,172 triangles.
BALL_STEPS = 41


def ball():
    """A cube of many squares, blown up to the unit sphere."""
    numbers, faces = {}, []

    def number(corner):
        return numbers.setdefault(corner, len(numbers) + 1)

    for side in CUBE_SIDES:
        a, b, _, d = (np.array(CORNERS[i - 1]) * BALL_STEPS for i in side)
        for i in range(BALL_STEPS):
            for j in range(BALL_STEPS):
                places = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                corners = [a + (b - a) * s // BALL_STEPS + (d - a) * t // BALL_STEPS for s, t in places]
                faces.append(tuple(number(tuple(corner)) for corner in corners))
    # Equal angles, so that all squares are about as large.
    points = [np.tan(np.array(corner) / BALL_STEPS * math.pi / 4) for corner in numbers]
    return [tuple(point / np.linalg.norm(point)) for point in points], faces


# Vertices, and faces that are counted from 1. Mitsuba's rectangle has no vertices to move, its
# cube has three at each corner.
MESHES = {
    "rectangle": ([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], [(1, 2, 3, 4)]),
    "cube": (CORNERS, CUBE_SIDES),
    "sphere": ball(),
}


def write_mesh(file, vertices, faces):
    """An OBJ file of triangles, two for each face."""
    lines = ["v %g %g %g" % tuple(vertex) for vertex in vertices]
    for a, b, c, d in faces:
        lines += [f"f {a} {b} {c}", f"f {a} {c} {d}"]
    file.write_text("\n".join(lines) + "\n")


# The arcade: sheets of squares, each an array of points (rows, columns, 3).


def write_sheets(file, sheets):
    vertices, faces = [], []
    for sheet in sheets:
        rows, columns, _ = sheet.shape
        numbers = len(vertices) + 1 + np.arange(rows * columns).reshape(rows, columns)
        corners = numbers[:-1, :-1], numbers[:-1, 1:], numbers[1:, 1:], numbers[1:, :-1]
        faces += zip(*(corner.ravel().tolist() for corner in corners), strict=True)
        vertices += sheet.reshape(-1, 3).tolist()
    write_mesh(file, vertices, faces)


def places(rows, columns):
    """From 0 to 1 down the rows and along the columns of a sheet."""
    return np.meshgrid(np.linspace(0, 1, rows + 1), np.linspace(0, 1, columns + 1), indexing="ij")


# Where columns stand: along the two sides, as far apart as the arches are wide.
SIDES = [-2.0, 2.0]
ALONG = [2.0 * i for i in range(6)]


def columns(file):
    """Twelve fluted columns of 9,216 triangles."""
    height, turn = places(48, 96)
    angle = 2 * math.pi * turn
    # Wider at both ends; sixteen flutes between them.
    ends = np.exp(-20 * height) + np.exp(-20 * (1 - height))
    radius = 0.22 - 0.03 * height + 0.12 * ends + 0.012 * np.cos(16 * angle) * (1 - ends)
    column = np.stack([radius * np.cos(angle), radius * np.sin(angle), 2.5 * height], axis=-1)
    write_sheets(file, [column + (x, y, 0) for y in SIDES for x in ALONG])


def arches(file):
    """Ten half rings of 3,840 triangles from column to column."""
    along, around = (math.pi * place for place in places(48, 40))
    radius = 1.0 - 0.18 * np.cos(2 * around)
    arch = np.stack(
        [1 - radius * np.cos(along), 0.18 * np.sin(2 * around), 2.5 + radius * np.sin(along)], axis=-1
    )
    write_sheets(file, [arch + (x, y, 0) for y in SIDES for x in ALONG[:-1]])


def cloth(file):
    """Five sheets of 20,000 triangles that hang across, in folds."""
    across, down = places(100, 100)
    sag = 0.5 * (1 - (2 * across - 1) ** 2)
    folds = (0.05 + 0.15 * down) * np.sin(30 * across + 4 * down)
    sheet = np.stack([folds, 4 * across - 2, 3.3 - sag - 0.9 * down], axis=-1)
    write_sheets(file, [sheet + (x + 1, 0, 0) for x in ALONG[:-1]])


# A thousand shapes.

MATERIALS = 20


def shapes(file):
    """Spheres, cubes, disks and cylinders, of each material fifty."""
    random_numbers = random.Random(1)
    uniform = random_numbers.uniform
    lines = ['<scene version="3.0.0">']
    for i in range(1000):
        kind = random_numbers.choice(["sphere", "cube", "disk", "cylinder"])
        turns = "".join(f'<rotate {axis}="1" angle="{uniform(0, 360):.2f}"/>' for axis in "xyz")
        x, y, z = uniform(-5, 5), uniform(-3, 4), uniform(0.3, 2)
        lines.append(
            f'<shape type="{kind}" id="shape-{i}"><transform name="to_world">'
            f'<scale value="{uniform(0.08, 0.2):.3f}"/>{turns}'
            f'<translate x="{x:.3f}" y="{y:.3f}" z="{z:.3f}"/>'
            f'</transform><ref id="material-{i % MATERIALS}"/></shape>'
        )
    file.write_text("\n".join([*lines, "</scene>"]) + "\n")


# Textures.


def write_texels(file, texels):
    mi.Bitmap(texels.astype(np.float32)).write(str(file))


def colours(file):
    write_texels(file, np.random.default_rng(1).uniform(0.2, 0.8, (64, 64, 3)))


def roughness(file):
    write_texels(file, np.random.default_rng(2).uniform(0.15, 0.5, (64, 64)))


def sky(file):
    """Brighter at the top, clouds, and a sun of one texel."""
    texels = np.random.default_rng(3).uniform(0.8, 1.2, (32, 64, 1)) * (0.4, 0.5, 0.7)
    texels *= np.linspace(1.5, 0.3, 32)[:, None, None]
    texels[9, 40] = (400.0, 370.0, 320.0)
    write_texels(file, texels)


MADE = {
    "made-columns.obj": columns,
    "made-arches.obj": arches,
    "made-cloth.obj": cloth,
    "made-shapes.xml": shapes,
    "made-colours.exr": colours,
    "made-roughness.exr": roughness,
    "made-sky.exr": sky,
}

# Scene files.


def prepare(file, shape_id=None, size=None, source=None):
    """Changes a copy of a scene for both programs: a shape that moves becomes a mesh if it is a
    primitive, the image gets its size, what the file names is made beside it, or, if the copy is
    of a file in the folder `source`, is found there. A variant of Mitsuba must be set."""
    tree = xml.parse(file)
    root = tree.getroot()
    if shape_id is not None:
        as_mesh(file, root, shape_id)
    film = root.find("sensor/film")
    if size is not None:
        for number in film.iter("integer"):
            name = number.get("name").removeprefix("crop_")
            if name in size:
                number.set("value", str(size[name]))
    # Older than version 3, which both programs refuse; it changes the border alone.
    for element in film.findall("boolean[@name='high_quality_edges']"):
        film.remove(element)
    for element in [*root.iter("include"), *root.iter("string")]:
        key = "filename" if element.tag == "include" else "value"
        name = element.get(key)
        if name in MADE:
            MADE[name](file.parent / name)
        elif source is not None and element.get("name") == "filename":
            element.set(key, str(source / name))
    tree.write(file)


def as_mesh(file, root, shape_id):
    """Puts a mesh in the place of a primitive."""
    shape = next((s for s in root.iter("shape") if s.get("id") == shape_id), None)
    if shape is None:
        sys.exit(f'{file}: expected a shape with the id "{shape_id}"; correct the list in subjects.rs')
    if shape.get("type") in MESHES:
        mesh = f"{shape_id}-as-mesh.obj"
        write_mesh(file.parent / mesh, *MESHES[shape.get("type")])
        shape.set("type", "obj")
        xml.SubElement(shape, "string", name="filename", value=mesh)
        xml.SubElement(shape, "boolean", name="face_normals", value="true")


def integrator_of(file):
    """Mitsuba's integrator for derivatives of a scene that the file renders with
    `direct` or `path`."""
    element = xml.parse(file).getroot().find("integrator")
    if element.get("type") == "direct":
        return {"type": "direct_projective"}
    depth = element.find("integer[@name='max_depth']")
    depth = -1 if depth is None else int(depth.get("value"))
    return {"type": "prb_projective", "max_depth": depth}
