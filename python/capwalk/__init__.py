"""Unbiased derivatives of rendered images, geometry above all.

>>> import capwalk as cw
>>> scene = cw.load_file("leaf")
>>> derivative = cw.gradient(scene, "leaf.translate.x", spp=16)
>>> derivative.gradient.shape == derivative.stderr.shape == derivative.value.shape
True

`__version__` is the version that `capwalk --version` prints.

Images are arrays (height, width, 3) of linear RGB in double precision. Lengths are in world
units, angles of parameters in radians.
"""

from . import cameras
from ._capwalk import VERSION as __version__
from ._capwalk import Scene
from ._dictionary import load_dict
from ._files import load_image, load_mesh, save_image, save_mesh
from ._functions import backward, check, gradient, load_file, load_string, render
from ._jobs import Optimization, optimize
from ._method import Method
from ._parameters import SceneParameters, traverse
from ._remesh import Transfer, remesh
from ._results import Check, GradientImage, Gradients, Image
from ._sobolev import sobolev_gradient
from ._steps import Adam, LargeSteps
from ._transform import Transform
from .errors import (
    ArgumentError,
    BusyError,
    DeviceError,
    DeviceWarning,
    Error,
    ImageError,
    LoadError,
    MeshError,
    ParameterError,
    Refused,
    SceneWarning,
    UnreliableWarning,
    WorkerError,
)

__all__ = [
    "Adam",
    "ArgumentError",
    "BusyError",
    "Check",
    "DeviceError",
    "DeviceWarning",
    "Error",
    "GradientImage",
    "Gradients",
    "Image",
    "ImageError",
    "LargeSteps",
    "LoadError",
    "MeshError",
    "Method",
    "Optimization",
    "ParameterError",
    "Refused",
    "Scene",
    "SceneParameters",
    "SceneWarning",
    "Transfer",
    "Transform",
    "UnreliableWarning",
    "WorkerError",
    "__version__",
    "backward",
    "cameras",
    "check",
    "gradient",
    "load_dict",
    "load_file",
    "load_image",
    "load_mesh",
    "load_string",
    "optimize",
    "remesh",
    "render",
    "save_image",
    "save_mesh",
    "sobolev_gradient",
    "traverse",
]
