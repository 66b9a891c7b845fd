"""Hunter: goes for the newest pose of a prey until that has been caught, then for the next."""

from __future__ import annotations

import rsal
from rsal.agents.devices import LaserScanner, Localizer, Navigator
from rsal.agents.messages import Caught, Chase, PoseReport
from rsal.agents.values import LaserScan, Pose2d


class Hunter(rsal.Agent):
    """Goes for the newest pose of a prey until that has been caught, then for the next."""

    prey: str = rsal.Param("prey", robots=True, description="Role of the robots to hunt, or id of the one.")
    catch_distance: float = rsal.Param(1.5, min=0.8, unit="m", description="It stops when nearer to its prey.")
    period: float = rsal.Param(0.5, min=0.1, unit="s", description="Time between two messages with its pose.")
    interval: float = rsal.Param(2.0, min=0.1, unit="s", description="Time between two goals.")

    needs = (LaserScanner, Localizer, Navigator)

    def __init__(self) -> None:
        self.target: str | None = None
        self.seen: dict[str, Pose2d] = {}
        self.caught: set[str] = set()
        self.chases: dict[str, str] = {}
        self.ahead = float("inf")

    def on_start(self) -> None:
        self.subscribe(PoseReport, self.on_pose)
        self.subscribe(Chase, self.on_chase)
        self.subscribe(Caught, self.on_caught)
        self.subscribe(self.robot.laser, self.on_scan)
        self.every(self.period, self.report)
        self.every(self.interval, self.pursue)
        self.state("looking for prey")

    def where(self) -> Pose2d | None:
        estimate = self.robot.localizer.latest
        return estimate.value.map_from_base if estimate else None

    def report(self) -> None:
        here = self.where()
        if here:
            self.publish(PoseReport(self.robot.id, self.robot.role, here))

    def on_scan(self, scan: rsal.Stamped[LaserScan]) -> None:
        self.ahead = scan.value.nearest(-0.5, 0.5)

    def on_pose(self, message: rsal.Message[PoseReport]) -> None:
        report = message.content
        if self.prey in (report.robot, report.role) and report.robot not in self.caught:
            self.seen[report.robot] = report.map_from_base

    def on_chase(self, message: rsal.Message[Chase]) -> None:
        self.chases[message.content.hunter] = message.content.prey

    def on_caught(self, message: rsal.Message[Caught]) -> None:
        prey = message.content.prey
        self.caught.add(prey)
        self.seen.pop(prey, None)
        if self.target == prey:
            self.target = None
            self.mind.reach(f"catch {prey}")
            self.robot.base.stop()
            self.spawn(self.pursue())

    def cost(self, prey: str, here: Pose2d) -> float:
        """One that others hunt is as if it were ten meters farther for each of them."""
        others = sum(chased == prey for chased in self.chases.values())
        return here.distance_to(self.seen[prey]) + 10 * others

    async def pursue(self) -> None:
        here = self.where()
        if here is None or not self.seen:
            self.state("looking for prey")
            return
        if self.target not in self.seen:
            self.target = min(sorted(self.seen), key=lambda prey: self.cost(prey, here))
            self.publish(Chase(self.robot.id, self.target))
            self.show("prey", self.target)
            self.mind.pursue(f"catch {self.target}")
        goal = self.seen[self.target]
        if here.distance_to(goal) < self.catch_distance:
            self.state(f"holding {self.target} at bay")
            return
        self.state(f"hunting {self.target}")
        self.mind.believe("ahead", f"{self.ahead:.1f} m")
        match await self.robot.navigator.go_to(goal):
            case Navigator.NoPath(why) | Navigator.Stuck(why=why):
                print(f"no way to {self.target}: {why}")
