"""Where the viewer of Rerun shows what."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import rerun as rr  # type: ignore[import-not-found, unused-ignore]
import rerun.blueprint as rrb  # type: ignore[import-not-found, unused-ignore]

TIMELINE = "iteration"


@dataclass
class Layout:
    """What there is to be shown."""

    images: dict[str, dict[str, str]] = field(default_factory=dict)
    """Titles by path, by sensor."""
    curves: list[str] = field(default_factory=list)
    """What is above the paths of curves that share a plot, and their title."""
    has_scene: bool = False
    eye: tuple[tuple[float, ...], tuple[float, ...]] | None = None
    """From where the scene is seen at first, and which point is in the middle."""
    has_notes: bool = False

    def blueprint(self) -> rrb.Blueprint:
        """The images of a sensor beside each other; below, the scene beside the curves; then notes."""
        rows: list[Any] = []
        shares: list[int] = []
        of_sensors = [
            rrb.Horizontal(
                *[rrb.Spatial2DView(origin=path, name=title) for path, title in titles.items()],
                name=sensor,
            )
            for sensor, titles in self.images.items()
        ]
        if of_sensors:
            rows.append(of_sensors[0] if len(of_sensors) == 1 else rrb.Tabs(*of_sensors))
            shares.append(2)
        row: list[Any] = []
        if self.has_scene:
            position, target = self.eye or (None, None)
            eye = rrb.EyeControls3D(position=position, look_target=target)
            row.append(rrb.Spatial3DView(origin="world", name="scene", eye_controls=eye))
        if self.curves:
            legend = rrb.PlotLegend(corner=rrb.Corner2D.RightTop)
            plots = [
                rrb.TimeSeriesView(
                    origin=rr.new_entity_path([name]), name=name, plot_legend=legend
                )
                for name in self.curves
            ]
            row.append(rrb.Vertical(*plots))
        if row:
            rows.append(rrb.Horizontal(*row))
            shares.append(3)
        if self.has_notes:
            rows.append(rrb.TextLogView(origin="notes", name="notes"))
            shares.append(1)
        return rrb.Blueprint(
            rrb.Vertical(*rows, row_shares=shares),
            rrb.TimePanel(timeline=TIMELINE, state="collapsed"),
            rrb.BlueprintPanel(state="collapsed"),
            rrb.SelectionPanel(state="collapsed"),
        )
