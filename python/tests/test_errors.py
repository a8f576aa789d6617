"""Wrong input: each exception says what was found, what was expected and what to do."""

from __future__ import annotations

import pickle
import warnings
from collections.abc import Callable
from pathlib import Path

import capwalk as cw
import numpy as np
import pytest

CUT_MIRROR = """<scene version="3.0.0">
<integrator type="path"><integer name="max_depth" value="4"/></integrator>
<sensor type="perspective"><float name="near_clip" value="5.5"/><transform name="to_world">
<lookat origin="0, 0, 6" target="0, 0, 0" up="0, 1, 0"/></transform>
<film type="hdrfilm"><integer name="width" value="16"/><integer name="height" value="12"/></film>
</sensor>
<shape type="sphere" id="mirror"><bsdf type="conductor"/></shape>
<shape type="cube" id="box"><transform name="to_world"><scale value="0.3"/>
<translate x="1.2" y="1" z="1.5"/></transform></shape>
<emitter type="constant"/>
</scene>"""


def test_places_of_mistakes(tmp_path: Path) -> None:
    file = tmp_path / "scene.xml"
    start = '<scene version="3.0.0"><integrator type="path"/><sensor type="perspective"/>'
    file.write_text(f'{start}\n  <shape type="cubus"/>\n</scene>')
    with pytest.raises(cw.LoadError) as caught:
        cw.load_file(file)
    error = caught.value
    assert (error.file, error.line, error.column) == (str(file), 2, 16)
    assert "known shape plugins: " in str(error)
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.line) == (str(error), 2)
    with pytest.raises(cw.LoadError, match="no file .*no built-in scene"):
        cw.load_file(tmp_path / "nothing.xml")


def test_warnings_of_files() -> None:
    text = (
        '<scene version="3.0.0"><integrator type="path"/><sensor type="perspective">'
        '<film type="hdrfilm"><integer name="width" value="4"/><integer name="height" value="3"/>'
        '<string name="file_format" value="pfm"/></film></sensor><shape type="cube"/></scene>'
    )
    with pytest.warns(cw.SceneWarning, match="file_format"):
        scene = cw.load_string(text)
    # Only light needs emitters.
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        cw.render(scene, aov="mask", spp=1)
    for rendered in scene, scene.copy():
        with pytest.warns(cw.SceneWarning, match="no emitter"):
            cw.render(rendered, spp=1)


def test_what_is_read_is_never_written(tmp_path: Path) -> None:
    texture = tmp_path / "texture.exr"
    cw.render(cw.load_file("leaf"), spp=1).save(texture)
    before = texture.read_bytes()
    file = tmp_path / "scene.xml"
    file.write_text(
        '<scene version="3.0.0"><integrator type="path"/><sensor type="perspective">'
        '<film type="hdrfilm"><integer name="width" value="4"/><integer name="height" value="3"/>'
        '</film></sensor><emitter type="envmap"><string name="filename" value="texture.exr"/>'
        '</emitter><shape type="cube" id="box"/></scene>'
    )
    scene = cw.load_file(file)
    results = cw.render(scene, spp=1), cw.gradient(scene.copy(), "box.translate.x", spp=1)
    for result in results:
        with pytest.raises(cw.ArgumentError, match="would overwrite"):
            result.save(texture)
        result.save(tmp_path / "new.exr")
    assert texture.read_bytes() == before


def test_numbers_beyond_all_reason_are_refused() -> None:
    scene = cw.load_file("leaf")
    with pytest.raises(cw.ParameterError, match="infinite velocity"):
        cw.gradient(scene, "1e308*leaf.translate.x + 1e308*leaf.translate.x", spp=1)
    params = cw.traverse(scene)
    with pytest.raises(cw.ArgumentError, match="up to 1e30"):
        params.update({"leaf.positions": np.full((3, 3), 1e200)})


def test_refusals_say_what_to_do_instead() -> None:
    scene = cw.load_string(CUT_MIRROR)
    with pytest.raises(cw.Refused) as caught:
        cw.gradient(scene, "box.translate.x", spp=16)
    error = caught.value
    assert "near_clip of 5.5 cuts" in error.reason
    assert error.instead is not None and "another near_clip" in error.instead
    assert str(error) == f"{error.reason}. {error.instead}"
    assert pickle.loads(pickle.dumps(error)).instead == error.instead


BOX = "box.translate.x"
ONES = np.ones((18, 24, 3))
WRONG: list[tuple[Callable[[cw.Scene], object], type[Exception], str]] = [
    (lambda s: cw.render(s, spp=0), cw.ArgumentError, "spp is 0; expected 1 to"),
    (lambda s: cw.render(s, spp=2.5), TypeError, "expected an integer"),  # type: ignore[arg-type]
    (lambda s: cw.render(s, seed=-1), cw.ArgumentError, "seed is -1; expected 0 to"),
    (lambda s: cw.render(s, threads=0), cw.ArgumentError, "threads is 0"),
    (lambda s: cw.render(s, ssp=4), TypeError, r"render\(\) got .* 'ssp'. Did you mean 'spp'"),  # type: ignore[call-arg]
    (lambda s: cw.render(s, steps=4), TypeError, "unexpected keyword argument 'steps'"),  # type: ignore[call-arg]
    (lambda s: cw.check(s, BOX, device="cpu"), TypeError, "argument 'device'"),  # type: ignore[call-arg]
    (lambda s: cw.render(s, device="tpu"), cw.ArgumentError, 'no device "tpu"; there are auto'),
    (lambda s: cw.gradient(s, "box.tranlate.x"), cw.ParameterError, "did you mean `box.translate"),
    (lambda s: cw.gradient(s, "box.scale - box.scale"), cw.ArgumentError, "nothing changes"),
    (lambda s: cw.gradient(s, 3), TypeError, "expected the name of a parameter"),  # type: ignore[arg-type]
    (lambda s: cw.gradient(s, {"box.positions": ONES}), cw.ArgumentError, r"found \(18, 24, 3\)"),
    (lambda s: cw.gradient(s, {"box.positions": ONES[0].T}), cw.ArgumentError, r"shape \(8, 3\)"),
    (lambda s: cw.backward(s, ONES * 1j), cw.ArgumentError, "complex128; expected real"),
    (lambda s: cw.gradient(s, BOX, method="was"), cw.ArgumentError, "there are auto, walk, edges"),
    (lambda s: cw.gradient(s, BOX, method="walk", steps=10**6), cw.ArgumentError, "expected 1 to 1000"),
    (lambda s: cw.gradient(s, BOX, method="walk", max_angle="a"), TypeError, "expected a number"),  # type: ignore[arg-type]
    (lambda s: cw.render("leaf"), TypeError, "expected what load_file"),  # type: ignore[arg-type]
    (lambda s: cw.render(s, sensor=1), cw.ArgumentError, "sensor is 1; expected 0 to 0"),
    (lambda s: cw.render(s, sensor="left"), cw.ArgumentError, 'no sensor "left"; there are sensor'),
    (lambda s: cw.render(s, aov="deep"), cw.ArgumentError, 'no aov "deep"; there are depth'),
    (lambda s: cw.render(s, progress=5), TypeError, "expected True, False or a function"),  # type: ignore[arg-type]
    (lambda s: cw.load_string("<scene/>", a=None), TypeError, "a is None; expected"),
    (lambda s: cw.gradient(s, {"box.positions": "up"}), cw.ArgumentError, "expected real numbers"),
    (lambda s: cw.gradient(s, {"box.positions": [[1], [1, 2]]}), cw.ArgumentError, "no array of"),
    (lambda s: cw.gradient(s, {"bx.positions": ONES}), cw.ParameterError, "no parameter"),
    (lambda s: cw.gradient(s, BOX, method="fast"), cw.ArgumentError, "there are auto, walk, edges"),
    (lambda s: cw.gradient(s, BOX, method=3), TypeError, "expected a name, or the method of"),  # type: ignore[arg-type]
    (lambda s: cw.gradient(s, BOX, method=cw.Method("walk", b"")), cw.ArgumentError, "too few"),
    (lambda s: cw.gradient(s, BOX, method="walk", steps=0), cw.ArgumentError, "steps is 0"),
    (lambda s: cw.gradient(s, BOX, method="walk", max_angle=-1), cw.Refused, "largest angle"),
    (lambda s: cw.check(s, BOX, step=0.0), cw.ArgumentError, "`step` is 0; expected"),
    (lambda s: cw.backward(s, ONES[0]), cw.ArgumentError, "has 3 x 24 pixels; expected 24 x 18"),
    (lambda s: cw.backward(s, ONES[:9]), cw.ArgumentError, "expected 24 x 18"),
    (lambda s: cw.backward(s, ONES * np.nan), cw.ArgumentError, "expected finite numbers"),
    (lambda s: cw.backward(s, ONES, "box.positions"), TypeError, "expected a list of names"),
    (lambda s: cw.backward(s, ONES, ["x.positions"]), cw.ParameterError, "no parameter"),
    (lambda s: s._update({"box.positions": ONES[0]}), cw.ArgumentError, r"found \(24, 3\)"),
    (lambda s: cw.traverse(s)["box.position"], cw.ParameterError, "did you mean"),
    (lambda s: cw.render(s).save("image.jpg"), cw.ImageError, "image.jpg"),
    (lambda s: cw.render(s).save("/no/folder/image.exr"), cw.ImageError, "/no/folder/image.exr"),
]


@pytest.mark.parametrize("case", range(len(WRONG)))
def test_wrong_input(scene: cw.Scene, case: int) -> None:
    call, kind, message = WRONG[case]
    with pytest.raises(kind, match=message):
        call(scene)


def test_numbers_that_a_scene_cannot_have(scene: cw.Scene) -> None:
    params = cw.traverse(scene)
    params["box.positions"][3, 1] = np.nan
    with pytest.raises(cw.ParameterError, match="finite"):
        params.update()
    with pytest.raises(cw.ArgumentError, match=r"shape \(8, 3\); found \(5, 3\)"):
        params["box.positions"] = np.ones((5, 3))
