"""Draws learning curves of train.py: python curves.py OUT.png CURVE.csv…"""

from __future__ import annotations

import csv
import sys
from pathlib import Path

import matplotlib as mpl

mpl.use("Agg")
import matplotlib.pyplot as plt

_SCORES = {
    "navigation": "time to the goal [s]",
    "pursuit": "time to the capture [s]",
    "coverage": "covered [%]",
    "formation": "error [m]",
    "foraging": "cans of 8",
    "patrol": "mean idleness [s]",
}
_COLUMNS = 3


def main() -> None:
    """Draw a panel for each table: scores of checks, and the mean return of each generation."""
    out, *files = sys.argv[1:]
    columns = min(_COLUMNS, len(files))
    rows_of_panels = -(-len(files) // columns)
    figure, panels = plt.subplots(rows_of_panels, columns, figsize=(4.6 * columns, 3.2 * rows_of_panels), squeeze=False)
    for panel in panels.flat[len(files) :]:
        panel.axis("off")
    for panel, file in zip(panels.flat, files, strict=False):
        with Path(file).open(encoding="utf-8") as table:
            rows = list(csv.DictReader(table))
        steps = [int(row["agent_steps"]) / 1000 for row in rows]
        checks = [(step, float(row["score"])) for step, row in zip(steps, rows, strict=True) if row["score"]]
        (scores,) = panel.plot(*zip(*checks, strict=True), "o-", color="#0072b2")
        panel.set_xlabel("thousand steps of robots")
        panel.set_ylabel(_SCORES.get(Path(file).stem, "score on validation seeds"), color=scores.get_color())
        panel.set_title(Path(file).stem.capitalize())
        returns = panel.twinx()
        returns.plot(steps, [float(row["mean_return"]) for row in rows], color="#d55e00", linewidth=1)
        returns.set_ylabel("mean return of the population", color="#d55e00")
    figure.tight_layout()
    figure.savefig(out, dpi=110)


if __name__ == "__main__":
    main()
