package rsal.agents;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import rsal.data.GripperState;
import rsal.data.GripperState.Lift;
import rsal.data.GripperState.Paddles;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.device.Gripper;
import rsal.device.SensorCore;

/// A gripper that is there at once, and grips something when the test says that there is something.
public final class FakeHand extends SensorCore<GripperState> implements Gripper {
    public final List<String> reported = new ArrayList<>();
    public boolean somethingIsThere;
    private boolean closed;
    private boolean raised;
    private boolean holding;

    public FakeHand(String robot) {
        super(new DeviceInfo(robot, "gripper", "fake"));
        feel();
    }

    /// Tells what it feels now.
    public void feel() {
        deliver(new Stamped<>(Instant.EPOCH, info().id(), state()));
    }

    private GripperState state() {
        return new GripperState(
                closed ? Paddles.CLOSED : Paddles.OPEN,
                closed ? 1 : 0,
                raised ? Lift.UP : Lift.DOWN,
                raised ? 1 : 0,
                somethingIsThere,
                somethingIsThere,
                holding,
                holding,
                holding);
    }

    private GoalHandle<GripperState, Result> done(String what) {
        reported.add(what);
        feel();
        var goal = new GoalSource<GripperState, Result>(() -> {});
        goal.end(new Result.Reached(state()));
        return goal;
    }

    @Override
    public GoalHandle<GripperState, Result> open() {
        closed = false;
        holding = false;
        return done("open");
    }

    @Override
    public GoalHandle<GripperState, Result> close() {
        closed = true;
        holding = somethingIsThere;
        return done("close");
    }

    @Override
    public GoalHandle<GripperState, Result> lift() {
        raised = true;
        return done("lift");
    }

    @Override
    public GoalHandle<GripperState, Result> lower() {
        raised = false;
        return done("lower");
    }
}
