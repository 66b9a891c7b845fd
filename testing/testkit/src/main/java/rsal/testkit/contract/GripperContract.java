package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.data.GripperState;
import rsal.data.GripperState.Lift;
import rsal.data.GripperState.Paddles;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.GoalHandle;
import rsal.device.Gripper;
import rsal.device.Gripper.Result;
import rsal.device.SimulationControl.Thing;
import rsal.robot.RobotModel.Part;

/// What every [Gripper] with a lift owes.
public abstract class GripperContract extends SensorContract<GripperState, Gripper> {
    protected GripperContract() {
        super(Gripper.class, "r1/gripper");
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("gripper", "pioneer-gripper");
    }

    private Part.Gripper part() {
        return (Part.Gripper) java.util.Objects.requireNonNull(model().sensors().get("gripper"));
    }

    /// A can between the paddles of the robot where it starts.
    private Thing can() {
        double between = (part().length() - part().paddleLength()) / 2;
        Pose2d baseFromCan = part().baseFromGripper().compose(new Pose2d(between, 0, 0));
        return Thing.of(
                "can",
                START.compose(baseFromCan),
                Solid.standing(new Shape.Disc(new Point2d(0, 0), 0.05), 0.15),
                new Rgb(255, 0, 0));
    }

    private GripperState state() {
        return device().latest().orElseThrow().value();
    }

    private Pose2d baseFromCan() {
        return truth().inverse().compose(simulation().truth("can").orElseThrow());
    }

    @Test
    void atFirstItIsOpenDownAndEmpty() {
        GripperState state = reading();
        assertThat(state.paddles()).isEqualTo(Paddles.OPEN);
        assertThat(state.lift()).isEqualTo(Lift.DOWN);
        assertThat(state.innerBeamBroken() || state.outerBeamBroken()).isFalse();
        assertThat(state.leftContact() || state.rightContact()).isFalse();
        assertThat(state.holding()).isFalse();
    }

    @Test
    void closesOnNothingAndOpensAgain() {
        Result closed = await(device().close().result());
        assertThat(closed)
                .isInstanceOfSatisfying(
                        Result.Reached.class,
                        reached -> assertThat(reached.state().holding()).isFalse());
        assertThat(state().paddles()).isEqualTo(Paddles.CLOSED);
        assertThat(await(device().open().result())).isInstanceOf(Result.Reached.class);
        assertThat(state().paddles()).isEqualTo(Paddles.OPEN);
    }

    @Test
    void takesItsTimeAndReportsItsProgress() {
        var reported = new ArrayList<GripperState>();
        GoalHandle<GripperState, Result> handle = device().close();
        handle.onFeedback(stamped -> reported.add(stamped.value()));
        advance(seconds(part().closingTime()) / 2);
        assertThat(state().paddles()).isEqualTo(Paddles.CLOSING);
        assertThat(handle.result().toCompletableFuture()).isNotDone();
        await(handle.result());
        assertThat(reported).hasSizeGreaterThan(2);
        assertThat(reported.subList(0, reported.size() - 1))
                .extracting(GripperState::paddles)
                .containsOnly(Paddles.CLOSING);
        int before = reported.size();
        advance(1);
        assertThat(reported).as("told nothing after the end").hasSize(before);
    }

    @Test
    void liftsAndLowers() {
        assertThat(await(device().lift().result())).isInstanceOf(Result.Reached.class);
        assertThat(state().lift()).isEqualTo(Lift.UP);
        GoalHandle<GripperState, Result> lower = device().lower();
        advance(seconds(part().liftingTime()) / 2);
        assertThat(state().lift()).isEqualTo(Lift.SINKING);
        assertThat(await(lower.result())).isInstanceOf(Result.Reached.class);
        assertThat(state().lift()).isEqualTo(Lift.DOWN);
    }

    @Test
    void whereItIsAlreadyIsReached() {
        assertThat(await(device().open().result())).isInstanceOf(Result.Reached.class);
        assertThat(await(device().lower().result())).isInstanceOf(Result.Reached.class);
        assertThat(state().paddles()).isEqualTo(Paddles.OPEN);
    }

    @Test
    void calledOffItStaysWhereItIs() {
        GoalHandle<GripperState, Result> handle = device().close();
        List<Result> endings = endings(handle);
        advance(seconds(part().closingTime()) / 2);
        handle.cancel();
        handle.cancel();
        advance(seconds(part().closingTime()));
        assertThat(endings).containsExactly(new Result.Cancelled());
        assertThat(state().paddles()).isEqualTo(Paddles.STOPPED);
        assertThat(await(device().open().result())).isInstanceOf(Result.Reached.class);
    }

    @Test
    void aNewGoalForThePaddlesTakesOverAndLeavesTheLiftAlone() {
        List<Result> lift = endings(device().lift());
        List<Result> close = endings(device().close());
        advance(0.5);
        GoalHandle<GripperState, Result> open = device().open();
        assertThat(close).containsExactly(new Result.Cancelled());
        assertThat(lift).isEmpty();
        assertThat(await(open.result())).isInstanceOf(Result.Reached.class);
        advance(seconds(part().liftingTime()) + 1);
        assertThat(lift).hasSize(1).first().isInstanceOf(Result.Reached.class);
        assertThat(state().lift()).isEqualTo(Lift.UP);
    }

    @Test
    void theEndOfAnOldGoalDoesNotTouchTheNewOne() {
        GoalHandle<GripperState, Result> old = device().open();
        GoalHandle<GripperState, Result> now = device().close();
        advance(0.3);
        old.cancel();
        assertThat(await(now.result())).isInstanceOf(Result.Reached.class);
        assertThat(state().paddles()).isEqualTo(Paddles.CLOSED);
    }

    @Test
    void closesAndLiftsLowersAndOpensAsOne() {
        assertThat(await(device().closeAndLift().result())).isInstanceOf(Result.Reached.class);
        assertThat(state().paddles()).isEqualTo(Paddles.CLOSED);
        assertThat(state().lift()).isEqualTo(Lift.UP);
        assertThat(await(device().lowerAndOpen().result())).isInstanceOf(Result.Reached.class);
        assertThat(state().paddles()).isEqualTo(Paddles.OPEN);
        assertThat(state().lift()).isEqualTo(Lift.DOWN);
    }

    @Test
    void twoAsOneCanBeCalledOffInEither() {
        GoalHandle<GripperState, Result> first = device().closeAndLift();
        advance(0.5);
        first.cancel();
        assertThat(await(first.result())).isEqualTo(new Result.Cancelled());
        assertThat(state().lift()).isEqualTo(Lift.DOWN);
        GoalHandle<GripperState, Result> second = device().closeAndLift();
        advance(seconds(part().closingTime()) + seconds(part().liftingTime()) / 2);
        assertThat(state().paddles()).isEqualTo(Paddles.CLOSED);
        second.cancel();
        assertThat(await(second.result())).isEqualTo(new Result.Cancelled());
        advance(seconds(part().liftingTime()) + 1);
        assertThat(state().lift()).isEqualTo(Lift.STOPPED);
    }

    @Test
    void standsStillWhileItsRobotsMotorsAreOffAndGoesOnWhenTheyAreOn() {
        List<Result> close = endings(device().close());
        List<Result> lift = endings(device().lift());
        advance(Math.min(seconds(part().closingTime()), seconds(part().liftingTime())) / 2);
        robot().require(DriveBase.class).enable(false);
        advance(0.3);
        GripperState stopped = state();
        assertThat(stopped.paddles()).isEqualTo(Paddles.STOPPED);
        assertThat(stopped.lift()).isEqualTo(Lift.STOPPED);
        advance(seconds(part().closingTime()) + seconds(part().liftingTime()));
        assertThat(state()).isEqualTo(stopped);
        assertThat(close).isEmpty();
        assertThat(lift).isEmpty();
        robot().require(DriveBase.class).enable(true);
        advance(seconds(part().closingTime()) + seconds(part().liftingTime()) + 1);
        assertThat(close).hasSize(1).first().isInstanceOf(Result.Reached.class);
        assertThat(lift).hasSize(1).first().isInstanceOf(Result.Reached.class);
        assertThat(state().paddles()).isEqualTo(Paddles.CLOSED);
        assertThat(state().lift()).isEqualTo(Lift.UP);
    }

    @Test
    void whatItIsToDoWhileMotorsAreOffWaitsForThem() {
        robot().require(DriveBase.class).enable(false);
        List<Result> close = endings(device().close());
        advance(seconds(part().closingTime()) + 1);
        assertThat(close).isEmpty();
        assertThat(state().paddles()).isEqualTo(Paddles.OPEN);
        List<Result> open = endings(device().open());
        assertThat(close).containsExactly(new Result.Cancelled());
        robot().require(DriveBase.class).enable(true);
        advance(seconds(part().closingTime()) + 1);
        assertThat(open).hasSize(1).first().isInstanceOf(Result.Reached.class);
        assertThat(state().paddles()).isEqualTo(Paddles.OPEN);
    }

    @Test
    void feelsWhatIsBetweenItsPaddles() {
        put(can().asGrippable());
        GripperState state = reading();
        assertThat(state.innerBeamBroken()).isTrue();
        assertThat(state.outerBeamBroken()).isTrue();
        assertThat(state.leftContact() || state.rightContact()).isFalse();
        simulation().remove("can");
        assertThat(reading().innerBeamBroken()).isFalse();
    }

    @Test
    void holdsWhatItGripsCarriesItAndLetsItGo() {
        put(can().asGrippable());
        assertThat(await(device().close().result()))
                .isInstanceOfSatisfying(
                        Result.Reached.class,
                        reached -> assertThat(reached.state().holding()).isTrue());
        assertThat(state().paddles()).isEqualTo(Paddles.CLOSED);
        assertThat(state().leftContact() && state().rightContact()).isTrue();
        Pose2d held = baseFromCan();
        drive(Twist2d.drive(0.3, 0.2), 3);
        advance(2);
        assertThat(truth().distanceTo(START)).isGreaterThan(0.5);
        assertThat(baseFromCan().isNear(held, 0.02, 0.02)).isTrue();
        assertThat(await(device().open().result())).isInstanceOf(Result.Reached.class);
        assertThat(state().holding()).isFalse();
        Pose2d left = simulation().truth("can").orElseThrow();
        drive(Twist2d.drive(-0.3, 0), 3);
        advance(1);
        assertThat(simulation().truth("can").orElseThrow().distanceTo(left)).isCloseTo(0, within(1e-9));
        assertThat(baseFromCan().distanceTo(held)).isGreaterThan(0.3);
    }

    @Test
    void doesNotHoldWhatCannotBeGripped() {
        put(can());
        await(device().close().result());
        assertThat(state().holding()).isFalse();
    }

    @Test
    void goalsEndWhenItsSystemIsClosed() {
        List<Result> close = endings(device().close());
        List<Result> lift = endings(device().lift());
        advance(0.3);
        system().close();
        advance(0.3);
        assertThat(close).hasSize(1).first().isInstanceOf(Result.Stuck.class);
        assertThat(lift).hasSize(1).first().isInstanceOf(Result.Stuck.class);
    }

    private static double seconds(Duration duration) {
        return duration.toMillis() / 1000.0;
    }

    private static List<Result> endings(GoalHandle<GripperState, Result> handle) {
        var endings = new ArrayList<Result>();
        handle.result().thenAccept(endings::add);
        return endings;
    }
}
