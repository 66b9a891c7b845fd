package rsal.agents;

import java.util.Optional;
import rsal.agent.AgentContext;
import rsal.behavior.Pilot;
import rsal.behavior.PioneerStack;
import rsal.device.Navigator;
import rsal.robot.Robot;

/// Has a robot follow the wall on its left. Where it has a navigator, errands come first.
final class WallFollowing {
    private final AgentContext self;
    private final Robot robot;
    private final Pilot pilot;
    private final Optional<Errands> errands;

    WallFollowing(AgentContext self, Robot robot) {
        this.self = self;
        this.robot = robot;
        this.pilot = robot.require(Pilot.class);
        this.errands = robot.find(Navigator.class)
                .map(navigator -> new Driver(self, navigator))
                .map(driver -> new Errands(self, robot.id(), driver, pilot::release, this::follow));
        self.atEnd(pilot::release);
    }

    void begin() {
        errands.ifPresent(Errands::begin);
        follow();
    }

    /// Lets go of the robot for good.
    void end() {
        errands.ifPresent(Errands::end);
        pilot.release();
    }

    private void follow() {
        pilot.engage(PioneerStack.followLeftWall(robot.model()));
        self.state("following the wall");
    }
}
