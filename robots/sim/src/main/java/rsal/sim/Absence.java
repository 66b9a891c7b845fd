package rsal.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import rsal.device.Health;
import rsal.sim.world.World;
import rsal.system.RobotSystem.Change;

/// Robots that are gone for a while: they vanish, or stand where they were like things.
final class Absence {
    private final World world;
    private final SimulatedRobots team;
    private final ContactTracker touches;
    private final Consumer<Change> changes;
    private final List<SimRobot> returning = new ArrayList<>(); // as soon as there is room

    /// @param changes told who is gone and who is back
    Absence(World world, SimulatedRobots team, ContactTracker touches, Consumer<Change> changes) {
        this.world = world;
        this.team = team;
        this.touches = touches;
        this.changes = changes;
    }

    /// @param stays whether it stands where it was
    void begin(SimRobot robot, boolean stays) {
        if (returning.remove(robot) || !team.has(robot)) {
            return;
        }
        team.leave(robot);
        if (!stays) {
            world.hide(robot.body());
            touches.forget(robot.body());
            robot.leaveBehind();
        }
        String why = stays ? "It stands still and says nothing." : "It has vanished.";
        robot.close(new Health.Lost(why));
        changes.accept(new Change.Gone(robot.id(), why));
    }

    /// It comes back where it was, as soon as there is room, unless somebody took it out of the world meanwhile.
    void end(SimRobot robot) {
        if (!team.isAway(robot)) {
            return;
        }
        if (!robot.body().isThere() && !world.reveal(robot.body())) {
            returning.add(robot);
            return;
        }
        team.comeBack(robot);
        robot.drive().standStill();
        changes.accept(new Change.Appeared(robot.robot()));
    }

    /// Lets those come back that had no room.
    void retry() {
        if (!returning.isEmpty()) {
            var some = List.copyOf(returning);
            returning.clear();
            some.forEach(this::end);
        }
    }
}
