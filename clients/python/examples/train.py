"""Trains a small policy for a task of RSAL by the cross-entropy method, and measures it on held-out seeds.

Usage: python train.py Navigation --minutes 20 --out trained

Each generation draws policies from a normal distribution, lets each of them act in the same episodes, and fits the
distribution to the best ones (Mannor, Rubinstein, Gat, ICML 2003; noise that shrinks as in Szita, Lorincz, 2006).
It writes a learning curve (CSV) and the parameters (JSON) after each check.
"""

from __future__ import annotations

import argparse
import csv
import itertools
import json
import textwrap
import time
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from rsal.agents.network import Network
from rsal.env.tasks import TASKS, Task

Floats = npt.NDArray[np.floating[Any]]

VALIDATION = range(500_000, 500_030)
"""Seeds by which the best parameters are chosen. Neither trained on nor reported."""
TRAINING = 1_000_000
"""The first seed of training."""


class Shape:
    """How a vector of parameters is a network for a task."""

    def __init__(self, task: Task, hidden: int) -> None:
        worlds = task.make_vec(1)
        layout = worlds.layout
        worlds.close()
        self.learners = len(layout.learners)
        self.scale = np.minimum(np.maximum(np.abs(layout.low), np.abs(layout.high)), 5.0)
        for number, field in enumerate(layout.fields):
            if field.endswith(("[m/s]", "[rad/s]")):
                self.scale[number] = 1.0
            elif field.startswith("range "):
                self.scale[number] = 2.0  # what is farther away does not matter now
        self.low, self.high, self.choices = layout.action_low, layout.action_high, layout.choices
        outputs = layout.choices or len(layout.action_fields)
        sizes = [len(layout.fields), hidden, outputs] if hidden else [len(layout.fields), outputs]
        self.layers = [(rows, columns + 1) for columns, rows in itertools.pairwise(sizes)]
        self.size = sum(rows * columns for rows, columns in self.layers)

    def split(self, parameters: Floats) -> list[Floats]:
        """Return the layers of one or several vectors."""
        layers, at = [], 0
        for rows, columns in self.layers:
            part = parameters[..., at : at + rows * columns]
            layers.append(part.reshape(*parameters.shape[:-1], rows, columns))
            at += rows * columns
        return layers

    def network(self, parameters: Floats) -> Network:
        """Return the network of one vector."""
        limits = ((), ()) if self.choices else (self.low.tolist(), self.high.tolist())
        layers = [layer.tolist() for layer in self.split(parameters)]
        return Network(self.scale.tolist(), layers, *limits, choices=self.choices)

    def act(self, layers: list[Floats], observations: Floats) -> Floats:
        """Return the actions of many networks, each in its own world."""
        values = np.clip(observations / self.scale, -1.0, 1.0)
        for layer in layers:
            values = np.tanh(np.einsum("wli,woi->wlo", values, layer[:, :, :-1]) + layer[:, None, :, -1])
        if self.choices:
            return values.argmax(-1)[..., None].astype(float)
        return self.low + (values + 1.0) / 2.0 * (self.high - self.low)


def returns(worlds: Any, shape: Shape, population: Floats, seeds: list[int], steps: int) -> tuple[Floats, int]:
    """Return the mean return of each policy over the same episodes, and how many steps that took."""
    observations, _ = worlds.reset(seed=seeds * len(population))
    layers = [np.repeat(layer, len(seeds), 0) for layer in shape.split(population)]
    total = np.zeros(len(population) * len(seeds))
    running = np.ones(len(total), bool)
    count = 0
    for _ in range(steps):
        observations, rewards, terminated, truncated, _ = worlds.step(shape.act(layers, observations))
        total += rewards.mean(1) * running
        count += int(running.sum())
        running &= ~(terminated | truncated)
        if not running.any():
            break
    return total.reshape(len(population), len(seeds)).mean(1), count


def imitated(task: Task, shape: Shape, options: argparse.Namespace) -> Floats:
    """Return parameters that act as the policy by hand, as far as the network can.

    The robots act by hand with noise, so that the network also sees what happens after errors. Then Adam (Kingma, Ba,
    2015) reduces the squared error of continuous actions, or the cross-entropy of choices.
    """
    if task.by_hand is None:
        raise SystemExit(f"There is nothing to imitate in the task {task.name}.")
    random = np.random.default_rng(options.seed)
    worlds = task.make_vec(40, threads=1)
    observations, _ = worlds.reset(seed=900_000)
    seen, done = [], []
    for _ in range(options.imitate):
        action = task.by_hand(observations)
        seen.append(observations.reshape(-1, observations.shape[-1]))
        done.append(np.asarray(action).reshape(-1, action.shape[-1]))
        wild = random.random((*action.shape[:2], 1)) < 0.3
        if shape.choices:
            noisy = np.where(wild, random.integers(0, shape.choices, action.shape), action)
        else:
            noise = random.normal(0, 0.3, action.shape) * (shape.high - shape.low)
            noisy = np.clip(action + noise * wild, shape.low, shape.high)
        observations, *_ = worlds.step(noisy)
    worlds.close()
    inputs = np.clip(np.concatenate(seen) / shape.scale, -1.0, 1.0)
    acts = np.concatenate(done)
    if shape.choices:
        wanted = np.eye(shape.choices)[acts[:, 0].astype(int)]
    else:
        wanted = np.clip(2 * (acts - shape.low) / (shape.high - shape.low) - 1, -0.95, 0.95)
    parameters = random.normal(0, 0.3, shape.size)
    first, second = np.zeros(shape.size), np.zeros(shape.size)
    for step in range(1, options.fits + 1):
        chosen = random.integers(0, len(inputs), 256)
        values = [inputs[chosen]]
        layers = shape.split(parameters)
        for layer in layers:
            values.append(np.tanh(values[-1] @ layer[:, :-1].T + layer[:, -1]))
        error = (_shares(values[-1]) if shape.choices else values[-1]) - wanted[chosen]
        slope, slopes = error, []
        for layer, before, after in zip(reversed(layers), reversed(values[:-1]), reversed(values[1:]), strict=True):
            slope = slope * (1 - after**2)
            slopes.append(np.concatenate([slope.T @ before, slope.sum(0)[:, None]], 1).ravel() / len(chosen))
            slope = slope @ layer[:, :-1]
        gradient = np.concatenate(slopes[::-1])
        first = 0.9 * first + 0.1 * gradient
        second = 0.999 * second + 0.001 * gradient**2
        parameters = parameters - 0.01 * (first / (1 - 0.9**step)) / (np.sqrt(second / (1 - 0.999**step)) + 1e-8)
    print(f"imitated {len(inputs)} decisions, mean squared error {float((error**2).mean()):.4f}", flush=True)
    return parameters


def _shares(outputs: Floats) -> Floats:
    """Return how likely each choice is (softmax). Outputs lie between -1 and 1, so they count five times."""
    powers = np.exp(5.0 * outputs)
    shares: Floats = powers / powers.sum(-1, keepdims=True)
    return shares


def agent(task: Task, shape: Shape, parameters: Floats, made: str) -> str:
    """Return the text of an agent that acts by a network: what it observes and does is that of the task."""

    def listed(values: Any) -> str:
        return "[" + "\n             ".join(textwrap.wrap(", ".join("%.4g" % value for value in values), 100)) + "]"

    layers = ",\n".join(
        "        [" + ",\n         ".join(listed(row) for row in layer) + "]" for layer in shape.split(parameters)
    )
    observe = "".join(f"        {json.dumps(each)},\n" for each in task.observe)
    limits = (
        f", choices={shape.choices}"
        if shape.choices
        else (
            f", low={['%.4g' % each for each in shape.low]}, high={['%.4g' % each for each in shape.high]}".replace(
                "'", ""
            )
        )
    )
    return (
        f'"""The policy that was trained in the task {task.name}: {made}."""\n\n'
        "from rsal.agents import Network, PolicyAgent\n\n\n"
        f"class {task.name}Policy(PolicyAgent):\n"
        f'    """Acts by a network with {shape.size} parameters, trained in the task {task.name}."""\n\n'
        f"    observe = [\n{observe}    ]\n"
        f"    act = {json.dumps(task.act)}\n"
        f"    period = {task.steps / 10}\n"
        "    # fmt: off\n    network = Network(\n"
        f"        {listed(shape.scale)},\n"
        f"        [\n{layers}\n        ]{limits},\n    )\n    # fmt: on\n"
    )


def train(task: Task, options: argparse.Namespace) -> None:
    """Train until the time is over."""
    shape = Shape(task, options.hidden)
    random = np.random.default_rng(options.seed)
    steps = options.max_steps or task.max_steps
    configurations = options.configurations or [task.configuration]
    count = options.population * options.episodes
    worlds = [
        task.make_vec(count, configuration=c, max_steps=steps, threads=1, autoreset=False) for c in configurations
    ]
    mean, deviation = np.zeros(shape.size), np.full(shape.size, options.deviation)
    if options.imitate:
        mean = imitated(task, shape, options)
    if options.start:
        mean = np.array(json.loads(Path(options.start).read_text(encoding="utf-8"))["parameters"])
    sign = 1.0 if task.better == "more" else -1.0
    best, begun, done, episodes = -np.inf, time.time(), 0, 0
    out = Path(options.out)
    out.mkdir(parents=True, exist_ok=True)
    curve = (out / f"{task.name.lower()}.csv").open("w", newline="", encoding="utf-8")
    writer = csv.writer(curve, lineterminator="\n")
    writer.writerow(["generation", "episodes", "agent_steps", "seconds", "mean_return", "best_return", "score"])
    for generation in range(options.generations):
        population = mean + deviation * random.standard_normal((options.population, shape.size))
        first = TRAINING + generation * options.episodes
        found, used = returns(
            worlds[generation % len(worlds)], shape, population, list(range(first, first + options.episodes)), steps
        )
        done, episodes = done + used * shape.learners, episodes + count
        elite = population[np.argsort(-found)[: options.elite]]
        mean = mean + options.rate * (elite.mean(0) - mean)
        noise = options.noise * max(0.0, 1.0 - generation / options.noisy)
        deviation = np.sqrt((1 - options.rate) * deviation**2 + options.rate * elite.var(0) + noise**2 * options.rate)
        over = time.time() - begun > 60 * options.minutes
        score: float | str = ""
        if generation % options.every == 0 or over or generation == options.generations - 1:
            score = float(
                np.mean(
                    [
                        ending["score"]
                        for configuration in configurations
                        for ending in task.evaluate(shape.network(mean), seeds=VALIDATION, configuration=configuration)
                    ]
                )
            )
            if sign * score > best:
                best = sign * score
                kept = {
                    "task": task.name,
                    "scale": shape.scale.tolist(),
                    "hidden": options.hidden,
                    "layers": [layer.tolist() for layer in shape.split(mean)],
                    "parameters": mean.tolist(),
                    "validation": score,
                    "generation": generation,
                    "command": vars(options),
                }
                (out / f"{task.name.lower()}.json").write_text(json.dumps(kept), encoding="utf-8")
                text = agent(task, shape, mean, f"cross-entropy method, generation {generation}, seed {options.seed}")
                (out / f"{task.name.lower()}_policy.py").write_text(text, encoding="utf-8")
        seconds = time.time() - begun
        row = [
            generation,
            episodes,
            done,
            round(seconds, 1),
            round(float(found.mean()), 3),
            round(float(found.max()), 3),
        ]
        writer.writerow([*row, score])
        curve.flush()
        print(*row, score, round(float(deviation.mean()), 3), flush=True)
        if over:
            break
    curve.close()
    for each in worlds:
        each.close()


def main() -> None:
    """Read the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("task", choices=list(TASKS))
    parser.add_argument("--minutes", type=float, default=20)
    parser.add_argument("--generations", type=int, default=1000)
    parser.add_argument("--population", type=int, default=40)
    parser.add_argument("--elite", type=int, default=8)
    parser.add_argument("--episodes", type=int, default=3, help="by policy and generation")
    parser.add_argument("--max-steps", type=int, default=0, help="of an episode in training; as the task says")
    parser.add_argument("--hidden", type=int, default=8)
    parser.add_argument("--deviation", type=float, default=0.7)
    parser.add_argument("--noise", type=float, default=0.2)
    parser.add_argument("--noisy", type=int, default=60, help="generations after which no noise is added")
    parser.add_argument("--rate", type=float, default=0.7)
    parser.add_argument("--every", type=int, default=10, help="generations between two checks")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--start", default="", help="parameters to start from")
    parser.add_argument("--imitate", type=int, default=0, help="steps of the policy by hand to begin with")
    parser.add_argument("--fits", type=int, default=6000, help="steps of Adam to imitate")
    parser.add_argument("--configurations", nargs="*", help="of the scenario; as the task says")
    parser.add_argument("--out", default="trained")
    options = parser.parse_args()
    train(TASKS[options.task], options)


if __name__ == "__main__":
    main()
