"""glTF files as scenes."""

from __future__ import annotations

import base64
import json
import struct
from pathlib import Path

import capwalk as cw
import numpy as np
import pytest


def room(**changes: object) -> dict[str, object]:
    """A triangle that fills the image, and a light behind the camera."""
    corners = struct.pack("<9f", -4, -4, 0, 4, -4, 0, 0, 8, 0)
    data = base64.b64encode(corners).decode()
    light = {
        "KHR_lights_punctual": {"lights": [{"type": "directional", "intensity": 3}]}
    }
    shown = {"KHR_lights_punctual": {"light": 0}}
    lens = {"yfov": 0.5, "znear": 0.1, "aspectRatio": 1}
    return {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0, 1, 2]}],
        "nodes": [
            {"name": "Wall", "mesh": 0},
            {"name": "Eye", "camera": 0, "translation": [0, 0, 5]},
            {"name": "Sun", "extensions": shown},
        ],
        "cameras": [{"type": "perspective", "perspective": lens}],
        "extensions": light,
        "materials": [{"name": "Paint", "pbrMetallicRoughness": {"metallicFactor": 0}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
        ],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36, "uri": "data:;base64," + data}],
        **changes,
    }


def test_a_file_is_a_scene(tmp_path: Path) -> None:
    file = tmp_path / "room.gltf"
    file.write_text(json.dumps(room()))
    with pytest.warns(cw.SceneWarning, match="not doubleSided"):
        scene = cw.load_file(file)
    assert "Paint.roughness.value" in cw.traverse(scene)
    # At least three quarters of a white wall's radiance under three of irradiance.
    assert cw.render(scene, spp=1).value.mean() > 0.75 * 3 / np.pi


def test_what_is_wrong_has_a_place(tmp_path: Path) -> None:
    file = tmp_path / "room.gltf"
    file.write_text(json.dumps(room(nodes=[{}, {}, {}])))
    with pytest.raises(cw.LoadError, match="room.gltf: its scene has no camera"):
        cw.load_file(file)
