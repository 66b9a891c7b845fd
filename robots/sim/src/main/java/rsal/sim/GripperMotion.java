package rsal.sim;

import java.time.Duration;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.GripperState;
import rsal.data.Stamped;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.device.Gripper.Result;

/// Paddles or lift of a gripper, on their way from 0 to 1 at a constant speed, and what they are to do.
final class GripperMotion {
    private final double speed; // [1/s]
    private double position;
    private double target;
    private @Nullable GoalSource<GripperState, Result> goal;
    private @Nullable GoalSource<GripperState, Result> inProgress; // in the last step

    /// @param time from 0 to 1; zero when it can't move
    /// @param begin where it is at first
    GripperMotion(Duration time, double begin) {
        position = begin;
        target = begin;
        speed = time.isZero() ? 0 : 1e9 / time.toNanos();
    }

    double position() {
        return position;
    }

    /// Begins a goal; the one before it is cancelled.
    GoalHandle<GripperState, Result> goTo(double place) {
        end(new Result.Cancelled());
        target = place;
        GoalSource<GripperState, Result> next = new GoalSource<>(() -> end(new Result.Cancelled()));
        goal = next;
        return next;
    }

    /// It stays where it is.
    void end(Result ending) {
        GoalSource<GripperState, Result> ended = goal;
        goal = null;
        target = position;
        if (ended != null) {
            ended.end(ending);
        }
    }

    /// Where it is one step on, if nothing stops it.
    ///
    /// @param dt [s]
    double next(double dt) {
        return Math.clamp(target, position - speed * dt, position + speed * dt);
    }

    void moveTo(double place) {
        position = place;
        inProgress = goal;
    }

    /// It goes no farther, and that is all that was wanted.
    void stopHere() {
        target = position;
    }

    boolean arrived() {
        return position == target;
    }

    /// Whether a goal has come to its end and nobody was told yet.
    boolean done() {
        return goal != null && arrived();
    }

    /// 1 towards 1, −1 towards 0, 0 when it stands.
    double direction() {
        return Math.signum(target - position);
    }

    <M> Optional<M> moving(M up, M down) {
        return arrived() ? Optional.empty() : Optional.of(direction() > 0 ? up : down);
    }

    void reported(Stamped<GripperState> reading) {
        GoalSource<GripperState, Result> now = goal;
        if (now != null && now == inProgress) { // a listener may have begun another
            now.publish(reading);
            if (now == goal && arrived()) {
                end(new Result.Reached(reading.value()));
            }
        }
    }
}
