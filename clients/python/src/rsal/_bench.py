"""What ``rsal bench python`` measures in Python. Prints a line of JSON for each row that was measured or left out.

Nothing else is on stdout: whatever other packages, libraries and child processes print goes to stderr.
"""

from __future__ import annotations

import importlib
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any, TextIO

_WARM = 8.0  # s of real time, at least, in which Java compiles
_WARM_STEPS = 2000  # at least, as Java compiles slowly beside other work
_PATIENCE = 90.0  # s, at most
_MEASURED = 3.0  # s, of each repeat
_TABLE = 64  # random actions, drawn before
_TURN = 0.0005  # s of simulated time from one callback to the next
_TURNS = 40_000
_SHORT, _LONG = 5, 65  # s of simulated time
_BEAMS = 180
_KILO = 1024.0

_TEN = """
rsal: 1
scenario: Robots with lasers
arguments: {count: {type: integer, default: 10}}
world: {map: office}
robots:
  bot: {count: $count, model: pioneer2dx, pose: {free: true}, devices: {laser: laser.yaml, sonar: none}}
"""
_LASER = """
type: laser
fieldOfView: 180
samples: 180
range: [0.1, 8]
noise: 0.01
period: 0.1
"""
_CALLBACKS = """
rsal: 1
scenario: Callbacks
world: {map: office}
robots: {bot: {model: pioneer2dx, pose: {free: true}, devices: {laser: none, sonar: none}}}
agents: {turns: {type: agent.py, robot: bot, parameters: {file: "FILE"}}}
"""
_TURNS_AGENT = f"""
import json
import time

import rsal


class Turns(rsal.Agent):
    file: str = rsal.Param("", description="Where the times of its callbacks are written.")

    def on_start(self):
        self.times = []
        self.every({_TURN}, self.turn)

    def turn(self):
        self.times.append(time.perf_counter())

    def on_stop(self):
        with open(self.file, "w") as file:
            json.dump(self.times, file)
"""
_SCANS = """
rsal: 1
scenario: Scans
world: {map: office}
robots: {bot: {count: 10, model: pioneer2dx, pose: {free: true}, devices: {laser: urg04lx, sonar: none}}}
agents: {guards: {type: agent.py, robot: bot}}
"""
_SCANS_AGENT = """
import rsal


class Guard(rsal.Agent):
    def on_start(self):
        self.subscribe(self.robot.laser, self.on_scan)

    def on_scan(self, scan):
        if scan.value.nearest(right=-0.5, left=0.5) < 0.6:
            self.robot.base.command(turn=0.8)
        else:
            self.robot.base.command(forward=0.4)
"""


class Bench:
    """Measures the rows that are wanted, in a folder for its files."""

    def __init__(
        self, wanted: list[str], repeats: int, episodes: int, *, command: list[str], folder: Path, results: TextIO
    ) -> None:
        self._wanted = wanted
        self._repeats = repeats
        self._episodes = episodes
        self._command = command
        self._folder = folder
        self._results = results

    def wants(self, *names: str) -> bool:
        """Whether one of these rows is to be measured."""
        return any(name in self._wanted for name in names)

    def tell(self, name: str, *values: float) -> None:
        """Tell what was measured, if it is wanted."""
        if name in self._wanted:
            self._say(name=name, values=[float(value) for value in values])

    def leave_out(self, name: str, why: str) -> None:
        """Tell why something is not measured, if it is wanted."""
        if name in self._wanted:
            self._say(name=name, note=why)

    def _say(self, **words: Any) -> None:
        print(json.dumps(words), file=self._results, flush=True)

    def file(self, name: str, text: str) -> str:
        """Write a file, and return its name."""
        file = self._folder / name
        file.parent.mkdir(exist_ok=True)
        file.write_text(text, encoding="utf-8")
        return str(file)

    def measure(self) -> None:
        """Measure all rows that are wanted."""
        self._import()
        self._callbacks()
        self._scans()
        self._environments()
        self._peers()

    def _import(self) -> None:
        if self.wants("python.import.ms"):
            code = (
                "import sys, time; sys.path[0] = sys.argv[1]; t = time.perf_counter(); import rsal; "
                "print(time.perf_counter() - t)"
            )
            words = [sys.executable, "-c", code, str(Path(__file__).parents[1])]
            times = [float(subprocess.run(words, capture_output=True, check=True).stdout) for _ in range(self._repeats)]
            self.tell("python.import.ms", *(1000 * each for each in times))

    def _run(self, scenario: str, seconds: float) -> float:
        """Make a run, and return the real time that it took [s]."""
        words = [*self._command, "run", scenario, "--headless", "--speed", "max", "--seed", "1", "--for", str(seconds)]
        start = time.perf_counter()
        done = subprocess.run(words, capture_output=True, text=True, check=False, env=_environment())
        if done.returncode not in (0, 1):
            raise RuntimeError(f"A run of '{scenario}' failed: {done.stderr.strip()}")
        return time.perf_counter() - start

    def _callbacks(self) -> None:
        names = ("python.agent.callback.p50", "python.agent.callback.p99")
        if not self.wants(*names):
            return
        times = self._folder / "times.json"
        self.file("callbacks/agent.py", _TURNS_AGENT)
        scenario = self.file("callbacks/scenario.yaml", _CALLBACKS.replace("FILE", str(times)))
        middle, late = [], []
        for _ in range(self._repeats):
            self._run(scenario, _TURNS * _TURN)
            began = json.loads(times.read_text())[_TURNS // 8 :]  # before, Java compiles
            turns = sorted(1e6 * (after - before) for before, after in pairwise(began))
            middle.append(turns[len(turns) // 2])
            late.append(turns[len(turns) * 99 // 100])
        self.tell(names[0], *middle)
        self.tell(names[1], *late)

    def _scans(self) -> None:
        if self.wants("python.agent.scans.rtf"):
            self.file("scans/agent.py", _SCANS_AGENT)
            scenario = self.file("scans/scenario.yaml", _SCANS)
            pairs = [(self._run(scenario, _SHORT), self._run(scenario, _LONG)) for _ in range(self._repeats)]
            took = [long - short for short, long in pairs if long > short]
            if took:
                self.tell("python.agent.scans.rtf", *((_LONG - _SHORT) / each for each in took))
            else:
                self.leave_out("python.agent.scans.rtf", "other work made the short runs longer than the long ones")

    def _environments(self) -> None:
        if not any(name.startswith("python.env.") for name in self._wanted):
            return
        try:
            from rsal import launch  # noqa: PLC0415 - only where it is needed

            env = importlib.import_module("rsal.env")
        except ImportError as error:
            if (error.name or "").startswith("rsal."):
                raise  # the package itself is not whole
            for name in self._wanted:
                if name.startswith("python.env."):
                    self.leave_out(name, f"not installed ({error}): pip install 'rsal[env]'")
            return
        launch.command = lambda arguments, **_: [*self._command, *arguments]
        launch.environment = _environment
        self.file("lasers/laser.yaml", _LASER)
        _Environments(self, env, self.file("lasers/scenario.yaml", _TEN), self._repeats, self._episodes).measure()

    def _peers(self) -> None:
        self._peer("python.peer.mpe.10.agents", "mpe2.simple_spread_v3", "mpe2", {"N": 10})
        self._peer("python.peer.sisl.8.agents", "pettingzoo.sisl.pursuit_v5", "'pettingzoo[sisl]'", {"n_pursuers": 8})
        name = "python.peer.irsim.10.agents"
        if self.wants(name):
            try:
                irsim = importlib.import_module("irsim")
            except ImportError as error:
                self.leave_out(name, f"not installed ({error}): pip install ir-sim")
                return
            world = irsim.make(self.file("irsim/world.yaml", _irsim_world()), display=False)
            self.tell(name, *(10 * each for each in rates(lambda _: world.step(), self._repeats)))
            world.end()

    def _peer(self, name: str, module: str, package: str, arguments: dict[str, Any]) -> None:
        """Measure another environment of PettingZoo, with random actions."""
        if not self.wants(name):
            return
        try:
            made = importlib.import_module(module).parallel_env(max_cycles=10**9, **arguments)
            made.reset(seed=1)
        except (ImportError, AttributeError) as error:
            self.leave_out(name, f"not installed ({error}): pip install {package}")
            return
        count = len(made.agents)
        table = [{agent: made.action_space(agent).sample() for agent in made.agents} for _ in range(_TABLE)]

        def step(number: int = 0) -> None:
            if not made.agents:
                made.reset()
            made.step(table[number % _TABLE])

        self.tell(name, *(count * each for each in rates(step, self._repeats)))
        made.close()


class _Environments:
    """Rows of learning environments."""

    def __init__(self, bench: Bench, env: Any, scenario: str, repeats: int, episodes: int) -> None:
        self._bench = bench
        self._env = env
        self._scenario = scenario
        self._repeats = repeats
        self._episodes = episodes
        self._observe = [env.Observe.ranges(sectors=_BEAMS), env.Observe.velocity()]

    def measure(self) -> None:
        self._first()
        self._parallel()
        self._vector("python.env.vector.1x10.agents", 1, 10)
        self._vector("python.env.vector.16x10.agents", 16, 10)
        self._vector("python.env.vector.1x100.agents", 1, 100)
        self._resets("python.env.reset.lasers.ms", self._scenario, "bot")
        self._resets("python.env.reset.hunt.ms", "hunt-and-prey", "hunter")
        self._many()

    def _made(self, worlds: int, count: int) -> Any:
        return self._env.make_vec(
            self._scenario,
            num_envs=worlds,
            threads=min(worlds, os.cpu_count() or 1),
            learners="bot",
            observe=self._observe,
            arguments={"count": count},
        )

    def _first(self) -> None:
        if self._bench.wants("python.env.first.s"):
            times = []
            for _ in range(self._repeats):
                start = time.perf_counter()
                made = self._made(1, 10)
                made.reset(seed=1)
                times.append(time.perf_counter() - start)
                made.close()
            self._bench.tell("python.env.first.s", *times)

    def _parallel(self) -> None:
        name = "python.env.pettingzoo.10.agents"
        if self._bench.wants(name):
            made = self._env.parallel_env(self._scenario, learners="bot", observe=self._observe)
            made.reset(seed=1)
            agents = made.agents
            drawn = _actions((_TABLE, len(agents)))
            table = [dict(zip(agents, each, strict=True)) for each in drawn]
            values = rates(lambda number: made.step(table[number % _TABLE]), self._repeats)
            self._bench.tell(name, *(len(agents) * each for each in values))
            made.close()

    def _vector(self, name: str, worlds: int, count: int) -> None:
        share = "python.env.transport.share"
        measures_share = (worlds, count) == (1, 10) and self._bench.wants(share)
        if not (self._bench.wants(name) or measures_share):
            return
        made = self._made(worlds, count)
        made.reset(seed=1)
        table = _actions((_TABLE, worlds, count))
        values = rates(lambda number: made.step(table[number % _TABLE]), self._repeats)
        self._bench.tell(name, *(worlds * count * each for each in values))
        if measures_share:
            inner = made._episodes.worlds  # an answer with all arrays, for which nothing is simulated
            transports = rates(lambda _: inner.reset([], []), self._repeats)
            self._bench.tell(share, *(step / way for step, way in zip(values, transports, strict=True)))
        made.close()

    def _resets(self, name: str, scenario: str, role: str) -> None:
        if self._bench.wants(name):
            made = self._env.make_vec(scenario, num_envs=1, threads=1, learners=role)
            values = rates(lambda number: made.reset(seed=number), self._repeats)
            self._bench.tell(name, *(1000 / each for each in values))
            made.close()

    def _many(self) -> None:
        names = [f"python.env.episodes.{what}" for what in ("java.mb", "python.mb", "files")]
        if not self._bench.wants(*names):
            return
        if not Path("/proc/self/statm").exists():
            for name in names:
                self._bench.leave_out(name, "there is no folder /proc on this system")
            return
        made = self._made(1, 2)
        made.reset(seed=1)
        process = made._episodes.worlds._process.pid
        still = _actions((1, 2))

        def held() -> tuple[float, float, float]:
            files = sum(len(list(Path(f"/proc/{each}/fd").iterdir())) for each in (process, os.getpid()))
            return _resident(process), _resident(os.getpid()), float(files)

        before = held()
        for episode in range(self._episodes):
            made.reset(seed=episode)
            made.step(still)
            if episode == self._episodes // 2:  # by then, Java has compiled
                before = held()
        after = held()
        for name, late, early in zip(names, after, before, strict=True):
            self._bench.tell(name, late - early)
        made.close()


def _resident(process: int) -> float:
    """Memory of a process [MB]."""
    pages = int(Path(f"/proc/{process}/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / _KILO / _KILO


def rates(step: Callable[[int], object], repeats: int) -> list[float]:
    """How often something can be done per second, once it is warm."""
    number = 0
    values = []
    start = time.perf_counter()
    while time.perf_counter() - start < (_WARM if number >= _WARM_STEPS else _PATIENCE):
        step(number)
        number += 1
    for _ in range(repeats):
        start = time.perf_counter()
        first = number
        while time.perf_counter() - start < _MEASURED:
            step(number)
            number += 1
        values.append((number - first) / (time.perf_counter() - start))
    return values


def _actions(shape: tuple[int, ...]) -> Any:
    numpy = importlib.import_module("numpy")
    generator = numpy.random.default_rng(1)
    drawn = [generator.uniform(low, high, shape) for low, high in ((0, 0.5), (-1.5, 1.5))]
    return numpy.stack(drawn, -1).astype("float32")


def _irsim_world() -> str:
    robots = "".join(
        f"  - {{kinematics: {{name: diff}}, shape: {{name: circle, radius: 0.2}}, state: [{2 + 3 * (i % 5)}, "
        f"{3 + 5 * (i // 5)}, 0], velocity: [0.3, 0.2], behavior: null, sensors: [{{name: lidar2d, range_max: 8, "
        f"angle_range: 3.14, number: {_BEAMS}}}]}}\n"
        for i in range(10)
    )
    return f"world: {{height: 20, width: 20, step_time: 0.1}}\nrobot:\n{robots}"


def _environment() -> dict[str, str]:
    return {**os.environ, "RSAL_PYTHON": sys.executable}


def _own_stdout() -> TextIO:
    """Return stdout, which from now on nobody else has: what others print goes to stderr."""
    own = os.fdopen(os.dup(1), "w", encoding="utf-8")
    sys.stdout.flush()
    os.dup2(2, 1)
    return own


def main() -> None:
    """Measure what the JSON on stdin says."""
    given = json.load(sys.stdin)
    os.environ["MPLBACKEND"] = "Agg"  # else matplotlib may open windows
    with _own_stdout() as results, tempfile.TemporaryDirectory(prefix="rsal-bench-") as folder:
        Bench(
            given["wanted"],
            given["repeats"],
            given["episodes"],
            command=given["command"],
            folder=Path(folder),
            results=results,
        ).measure()
