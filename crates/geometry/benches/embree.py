"""Times Embree (`pip install embreex`) for the bench `traversal`, which calls it.

Arguments: a file of corners of triangles, one of origins and directions (single precision), what
to ask (OCCLUDED: within the length of the direction) and the number of rays in a batch. Prints
for each batch the seconds it took, and how many rays found something. embreex traces the rays of
a call one by one in a compiled loop.
"""

import sys
import time

import numpy
from embreex.mesh_construction import TriangleMesh
from embreex.rtcore_scene import EmbreeScene

corners_file, rays_file, query, batch = sys.argv[1:]
corners = numpy.fromfile(corners_file, numpy.float32).reshape(-1, 3)
rays = numpy.fromfile(rays_file, numpy.float32).reshape(-1, 2, 3)
scene = EmbreeScene()
faces = numpy.arange(len(corners), dtype=numpy.int32).reshape(-1, 3)
mesh = TriangleMesh(scene, corners, faces)
for start in range(0, len(rays), int(batch)):
    origins, directions = (
        numpy.ascontiguousarray(part) for part in rays[start : start + int(batch)].transpose(1, 0, 2)
    )
    ends = numpy.full(len(origins), 1.0 if query == "OCCLUDED" else 1e30, numpy.float32)
    if start == 0:
        scene.run(origins, directions, dists=ends, query=query)  # builds the tree
    begin = time.perf_counter()
    found = scene.run(origins, directions, dists=ends, query=query)
    print(time.perf_counter() - begin, int((found >= 0).sum()))
