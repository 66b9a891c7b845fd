"""Measures policies in the tasks of RSAL on held-out seeds, and writes a table of their scores.

Usage: python scores.py --out scores.csv [--tasks Navigation Pursuit] [--policies random agents hand learned]

Policies are trained on other seeds (see train.py). Intervals are 95 % intervals of the mean, by bootstrap.
"""

from __future__ import annotations

import argparse
import csv
import time
from pathlib import Path
from typing import Any

import numpy as np

from rsal.env.tasks import TASKS, Task

SEEDS = range(1, 33)


def interval(values: list[float]) -> tuple[float, float]:
    """Return the 95 % interval of a mean, by percentiles of 10,000 bootstrap samples."""
    random = np.random.default_rng(1)
    means = np.array(values)[random.integers(0, len(values), (10_000, len(values)))].mean(1)
    low, high = np.percentile(means, [2.5, 97.5])
    return float(low), float(high)


def measure(task: Task, policy: str, configuration: str) -> list[dict[str, Any]] | None:
    """Return how the episodes ended; None where there is no such policy."""
    if policy == "agents":
        scripted = task.scripted.get(configuration)
        return None if scripted is None else task.evaluate_scripted(seeds=SEEDS, configuration=configuration)
    if policy == "random":
        return task.evaluate(task.at_random(), seeds=SEEDS, configuration=configuration)
    acting = task.by_hand if policy == "hand" else task.learned()
    return None if acting is None else task.evaluate(acting, seeds=SEEDS, configuration=configuration)


def main() -> None:
    """Read the command line, and measure."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tasks", nargs="*", default=list(TASKS))
    parser.add_argument("--policies", nargs="*", default=["random", "agents", "hand", "learned"])
    parser.add_argument("--out", default="scores.csv")
    options = parser.parse_args()
    file = Path(options.out)
    begun = file.exists()
    with file.open("a", newline="", encoding="utf-8") as out:
        writer = csv.writer(out, lineterminator="\n")
        if not begun:
            writer.writerow(["task", "configuration", "policy", "episodes", "mean", "low", "high", "successes"])
        for name in options.tasks:
            task = TASKS[name]
            others = [each for each in task.scripted if each not in (task.configuration, *task.held_out)]
            for configuration in (task.configuration, *task.held_out, *others):
                for policy in options.policies:
                    if configuration in others and policy != "agents":
                        continue
                    began = time.time()
                    endings = measure(task, policy, configuration)
                    if endings is None:
                        continue
                    scores = [float(ending["score"]) for ending in endings]
                    successes = sum(ending["outcome"] == "success" for ending in endings)
                    low, high = interval(scores)
                    row = [name, configuration, policy, len(scores)]
                    writer.writerow([*row, *(round(each, 2) for each in (np.mean(scores), low, high)), successes])
                    out.flush()
                    print(*row, round(float(np.mean(scores)), 2), round(low, 2), round(high, 2), successes,
                          f"{time.time() - began:.0f} s", flush=True)  # fmt: skip


if __name__ == "__main__":
    main()
