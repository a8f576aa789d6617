from os import PathLike
from typing import Any, final

from numpy import float64, uint32
from numpy.typing import NDArray

from ._options import Options
from ._steps import Adam

_Array = NDArray[float64]
_Estimate = tuple[_Array, _Array]
_Statistics = dict[str, Any]
_Along = str | dict[str, _Array]
_Method = tuple[str, bytes]
_Asked = _Along | tuple[_Array, list[str]] | None

@final
class Scene:
    """A scene that is ready to be rendered and differentiated, from :func:`load_file` and its
    like. It can be rendered by several threads at once, pickled, and copied."""

    @property
    def name(self) -> str:
        """What it was loaded from."""

    @property
    def warnings(self) -> list[str]:
        """Warnings about its file."""

    @property
    def _light_warnings(self) -> list[str]: ...
    @property
    def _files(self) -> list[PathLike[str]]: ...
    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the image of its first sensor, pixels."""

    @property
    def revision(self) -> int:
        """How often it was changed."""

    def resize(self, width: int, height: int) -> None:
        """Gives the images of all sensors another size, pixels, without crop."""

    def faces(self, shape: str) -> NDArray[uint32]:
        """The triangles of a shape, (F, 3): numbers of their vertices, counter-clockwise seen
        from outside."""

    def copy(self) -> Scene:
        """Another scene with the same numbers, which changes by itself."""

    def __copy__(self) -> Scene: ...
    def __deepcopy__(self, memo: Any, /) -> Scene: ...
    @staticmethod
    def from_bytes(bytes: bytes, name: str) -> Scene:
        """What pickling made of a scene."""

    def _sensors(self) -> list[tuple[str, tuple[int, int], int, int]]: ...
    def _arrays(self) -> list[tuple[str, list[int], str, str, str | None, bool]]: ...
    def _gradient_shape(self, name: str, sensor: int) -> list[int]: ...
    def _values(self, name: str) -> _Array: ...
    def _update(self, changes: dict[str, _Array]) -> None: ...
    def _restore(self, other: Scene, changes: dict[str, _Array]) -> None: ...
    def _replace(self, bytes: bytes) -> None: ...
    def _gradient_names(self, sensor: int) -> tuple[list[str], list[str], str | None]: ...

def load_file(path: str, defines: dict[str, str]) -> Scene: ...
def load_string(text: str, folder: str, defines: dict[str, str]) -> Scene: ...
def load_lines(text: str, folder: str, lines: list[str]) -> Scene: ...
def check_options(options: Options) -> None: ...
def independent_seed(seed: int) -> int: ...
def view_seed(seed: int, view: int) -> int: ...
def render(
    scene: Scene, options: Options
) -> tuple[tuple[_Estimate, _Statistics], str | None, str | None]: ...
def gradient(
    scene: Scene, along: _Along, options: Options
) -> tuple[tuple[_Estimate, _Estimate, _Method, _Statistics], str | None, str | None]: ...
def backward(
    scene: Scene, adjoint: _Array, names: list[str], options: Options
) -> tuple[
    tuple[dict[str, _Array], dict[str, _Array], _Method, _Statistics], str | None, str | None
]: ...
def check(
    scene: Scene,
    along: _Along,
    options: Options,
    reference_spp: int | None,
    step: float | None,
) -> tuple[_Estimate, _Estimate, dict[str, Any]]: ...
def choose(scene: Scene, asked: _Asked, options: Options) -> tuple[str, bytes] | None: ...
def part(scene: Scene, asked: _Asked, options: Options, index: int, count: int) -> bytes: ...
def merge(scene: Scene, asked: _Asked, options: Options, parts: list[bytes]) -> Any: ...
@final
class Smooth:
    def __init__(self, positions: _Array, faces: list[list[int]], lambda_: float, /) -> None: ...
    @property
    def sizes(self) -> tuple[int, int]: ...
    def multiply(self, positions: _Array) -> _Array: ...
    def solve(self, nodes: _Array) -> _Array: ...
    def pull(self, gradient: _Array) -> _Array: ...

def adam(
    rates: Adam, step: int, numbers: _Array, gradient: _Array, means: list[_Array]
) -> tuple[_Array, _Array, _Array]: ...
def png(image: _Array, signed: bool) -> bytes: ...
def write_images(
    path: str,
    layers: list[tuple[str, _Array]],
    notes: list[tuple[str, str]],
    read: list[PathLike[str]],
) -> None: ...
