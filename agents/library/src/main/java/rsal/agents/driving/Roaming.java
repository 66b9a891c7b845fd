package rsal.agents.driving;

import java.util.Optional;
import java.util.function.Function;
import rsal.agent.AgentContext;
import rsal.behavior.Pilot;
import rsal.behavior.PioneerStack;
import rsal.behavior.Subsumption;
import rsal.device.Navigator;
import rsal.robot.Robot;
import rsal.robot.RobotModel;

/// Has a robot follow the wall on its left, or wander. Where it has a navigator, errands come first.
public final class Roaming {
    private final AgentContext self;
    private final Robot robot;
    private final String state;
    private final Function<RobotModel, Subsumption> behavior;
    private final Pilot pilot;
    private final Optional<GoalService> goals;

    public static Roaming alongWalls(AgentContext self, Robot robot) {
        return new Roaming(self, robot, "following the wall", PioneerStack::followLeftWall);
    }

    public static Roaming anywhere(AgentContext self, Robot robot) {
        return new Roaming(self, robot, "wandering", PioneerStack::wander);
    }

    private Roaming(AgentContext self, Robot robot, String state, Function<RobotModel, Subsumption> behavior) {
        this.self = self;
        this.robot = robot;
        this.state = state;
        this.behavior = behavior;
        this.pilot = robot.require(Pilot.class);
        this.goals = robot.find(Navigator.class)
                .map(navigator -> new NavigationClient(self, navigator))
                .map(driver -> new GoalService(self, robot.id(), driver, pilot::release, this::roam));
        self.atEnd(pilot::release);
    }

    public void begin() {
        goals.ifPresent(GoalService::begin);
        roam();
    }

    /// Whether it drives where it was told.
    public boolean isOnErrand() {
        return goals.filter(GoalService::busy).isPresent();
    }

    /// Lets go of the robot until it is to go on.
    public void pause() {
        pilot.release();
    }

    public void goOn() {
        roam();
    }

    /// Lets go of the robot for good.
    public void end() {
        goals.ifPresent(GoalService::end);
        pilot.release();
    }

    private void roam() {
        pilot.engage(behavior.apply(robot.model()));
        self.state(state);
    }
}
