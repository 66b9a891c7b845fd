"""Hunter: drives to where it last heard of its prey."""

from __future__ import annotations

import rsal
from rsal.agents.devices import Localizer, Navigator
from rsal.agents.messages import Caught, PoseReport
from rsal.agents.values import Pose2d


class Hunter(rsal.Agent):
    """Drives to where it last heard of its prey."""

    prey: str = rsal.Param("prey", robots=True, description="Role of the robots to hunt, or id of the one.")
    catch_distance: float = rsal.Param(1.5, min=0.8, unit="m", description="It stops when nearer to its prey.")
    interval: float = rsal.Param(2.0, min=0.1, unit="s", description="Time between two goals.")

    needs = (Localizer, Navigator)

    def on_start(self) -> None:
        self.heard: Pose2d | None = None
        self.subscribe(PoseReport, self.on_pose)
        self.subscribe(Caught, self.on_caught)
        self.every(0.5, self.report)
        self.every(self.interval, self.pursue)
        self.state("looking for prey")

    def where(self) -> Pose2d | None:
        estimate = self.robot.localizer.latest
        return estimate.value.map_from_base if estimate else None

    def report(self) -> None:
        here = self.where()
        if here:
            self.publish(PoseReport(self.robot.id, self.robot.role, here))

    def on_pose(self, message: rsal.Message[PoseReport]) -> None:
        report = message.content
        if self.prey in (report.robot, report.role):
            self.heard = report.map_from_base

    def on_caught(self, message: rsal.Message[Caught]) -> None:
        print(f"{message.content.hunter} has caught {message.content.prey}")
        self.heard = None
        self.robot.base.stop()

    async def pursue(self) -> None:
        here = self.where()
        if here is None or self.heard is None:
            return
        if here.distance_to(self.heard) < self.catch_distance:
            self.robot.base.stop()
            self.state("holding its prey at bay")
            return
        self.state("hunting")
        match await self.robot.navigator.go_to(self.heard):
            case Navigator.NoPath(why=why) | Navigator.Stuck(why=why):
                print(f"no way to its prey: {why}")
