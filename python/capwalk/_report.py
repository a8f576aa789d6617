"""An optimisation as one HTML page: pictures and curves, all in the file."""

from __future__ import annotations

import base64
import html
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from ._numbers import Array

WIDTH, HEIGHT, LEFT, TOP, BELOW = 420, 200, 72, 14, 22
"""Of a chart and of its margins, pixels."""
COLOURS = ("#1f6feb", "#d1570a", "#2a8f4b", "#8250df")
MOST_PICTURES = 6
STYLE = """body { font: 15px/1.5 system-ui, sans-serif; margin: 2em auto; max-width: 920px;
color: #222 }
h1 { font-size: 1.4em } h2 { font-size: 1.1em; margin-top: 2em }
figure { display: inline-block; margin: 0 16px 16px 0; vertical-align: top }
figcaption { font-size: 0.9em; color: #555 } img { max-width: 100%; image-rendering: pixelated }
table { border-collapse: collapse }
td { padding: 2px 16px 2px 0; font-variant-numeric: tabular-nums }
svg text { fill: #555 }"""


def page(
    title: str,
    stopped: str,
    record: Mapping[str, Array],
    parameters: Mapping[str, Array],
    pictures: Sequence[tuple[str, bytes]],
) -> str:
    """The page. ``pictures`` are PNG files with their captions, in order."""
    loss, error = record["loss"], record["loss_stderr"]
    rows = [("iterations", f"{max(len(loss) - 1, 0):,}"), ("stopped", stopped)]
    if len(loss) > 0:
        rows += _ends(record)
    for name, value in parameters.items():
        numbers = (
            ", ".join(f"{x:.5g}" for x in value.ravel())
            if value.size <= 4
            else f"{value.size:,} numbers"
        )
        rows.append((name, numbers))
    charts = [chart("loss", {"loss": loss}, band=error, logarithmic=True)]
    samples = {"of images": record["spp"], "of gradients": record["spp_grad"]}
    charts.append(chart("samples per pixel", samples, logarithmic=True))
    norms = {"gradient": record["gradient_norm"], "its noise": record["gradient_noise"]}
    charts.append(chart("length of the gradient", norms, logarithmic=True))
    # Parameters of a few numbers have columns of their own, one or several.
    for name, value in parameters.items():
        columns = {key: column for key, column in record.items() if _is_of(key, name)}
        if columns and value.size <= len(COLOURS):
            short = {key.removeprefix(name): column for key, column in columns.items()}
            charts.append(chart(name, short))
    chosen = list(pictures)
    if len(chosen) > MOST_PICTURES:
        places = np.linspace(0, len(chosen) - 1, MOST_PICTURES).round().astype(int)
        chosen = [chosen[i] for i in places]
    table = "".join(f"<tr><td>{html.escape(a)}</td><td>{html.escape(b)}</td></tr>" for a, b in rows)
    shown = "".join(_picture(*picture) for picture in chosen)
    return (
        f'<!doctype html><html lang="en"><meta charset="utf-8"><title>{html.escape(title)}</title>'
        f"<style>{STYLE}</style><h1>{html.escape(title)}</h1><table>{table}</table>"
        f"<h2>Curves</h2>{''.join(charts)}<h2>Image, target and difference</h2>{shown}</html>\n"
    )


def _ends(record: Mapping[str, Array]) -> list[tuple[str, str]]:
    """The first and the last row of a record."""
    loss, error = record["loss"], record["loss_stderr"]
    spp, spp_grad = record["spp"][-1], record["spp_grad"][-1]
    return [
        ("loss at first", f"{loss[0]:.4g} ± {error[0]:.2g}"),
        ("loss at the end", f"{loss[-1]:.4g} ± {error[-1]:.2g}"),
        ("samples per pixel at the end", f"{spp:.0f} and {spp_grad:.0f}"),
    ]


def pictures_in(folder: Path) -> list[tuple[str, bytes]]:
    """The pictures that a run drew, with their iterations."""
    files = sorted(folder.glob("*.png"))
    return [(f"iteration {_words(file.stem)}", file.read_bytes()) for file in files]


def chart(
    title: str,
    columns: Mapping[str, Array],
    *,
    band: Array | None = None,
    logarithmic: bool = False,
) -> str:
    """Columns over iterations, as SVG; on a logarithmic axis without what is not above zero."""
    every = np.concatenate(list(columns.values()))
    usable = every[np.isfinite(every) & ((every > 0) | (not logarithmic))]
    if usable.size == 0:
        return ""
    low, high = float(usable.min()), float(usable.max())
    if low == high:
        low, high = (low / 2, high * 2) if logarithmic else (low - 1, high + 1)
    count = max(len(column) for column in columns.values())

    def place(values: Array) -> Array:
        if logarithmic:
            with np.errstate(divide="ignore", invalid="ignore"):
                share = np.log(values / low) / np.log(high / low)
        else:
            share = (values - low) / (high - low)
        placed: Array = TOP + (HEIGHT - TOP - BELOW) * (1 - share)
        return placed

    x = LEFT + (WIDTH - LEFT - 8) * np.arange(count) / max(count - 1, 1)
    parts = [
        f'<text x="{LEFT - 6}" y="{y:.0f}" text-anchor="end" dy="4">{value:.3g}</text>'
        f'<path d="M{LEFT} {y:.1f}H{WIDTH - 8}" stroke="#ddd"/>'
        for value, y in ((value, float(place(np.array(value)))) for value in (low, high))
    ]
    parts.append(f'<text x="{WIDTH - 8}" y="{HEIGHT - 4}" text-anchor="end">{count - 1}</text>')
    parts.append(f'<text x="{LEFT}" y="{HEIGHT - 4}">0</text>')
    for (name, column), colour in zip(columns.items(), COLOURS, strict=False):
        if band is not None:
            least = np.maximum(column - band, low) if logarithmic else column - band
            edges = [(x, place(least)), (x[::-1], place(np.maximum(column + band, low))[::-1])]
            parts.append(f'<path d="{_line(edges)}Z" fill="{colour}" opacity="0.2"/>')
        parts.append(
            f'<path d="{_line([(x, place(column))])}" fill="none" stroke="{colour}" '
            'stroke-width="1.5"/>'
        )
    legend = (
        ""
        if len(columns) == 1
        else ": "
        + ", ".join(
            f'<span style="color:{colour}">{html.escape(name)}</span>'
            for name, colour in zip(columns, COLOURS, strict=False)
        )
    )
    return (
        f'<figure><svg font-family="sans-serif" font-size="11" width="{WIDTH}" '
        f'height="{HEIGHT}">{"".join(parts)}'
        f"</svg><figcaption>{html.escape(title)}{legend}</figcaption></figure>"
    )


def _line(parts: Sequence[tuple[Array, Array]]) -> str:
    """A path through points, which begins anew behind those that are not finite."""
    path, is_open = "", False
    for xs, ys in parts:
        for x, y in zip(xs, ys, strict=False):
            if np.isfinite(y):
                path += f"{'L' if is_open else 'M'}{x:.1f} {min(max(y, 0.0), HEIGHT):.1f}"
            is_open = bool(np.isfinite(y))
    return path


def _picture(caption: str, content: bytes) -> str:
    data = base64.b64encode(content).decode()
    caption = html.escape(caption)
    return (
        f'<figure><img alt="{caption}" src="data:image/png;base64,{data}">'
        f"<figcaption>{caption}</figcaption></figure>"
    )


def _is_of(column: str, parameter: str) -> bool:
    return column == parameter or column.startswith(f"{parameter}[")


def _words(stem: str) -> str:
    number, _, view = stem.partition("-view")
    return f"{int(number)}" + (f", view {view}" if view else "")
