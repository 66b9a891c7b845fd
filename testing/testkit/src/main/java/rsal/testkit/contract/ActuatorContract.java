package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.ActuatorState;
import rsal.data.ActuatorState.Motion;
import rsal.device.Actuator;
import rsal.device.Actuator.Result;
import rsal.device.DriveBase;
import rsal.device.GoalHandle;
import rsal.robot.RobotModel.Part;

/// What every [Actuator] owes.
public abstract class ActuatorContract extends SensorContract<ActuatorState, Actuator> {
    private static final double NEARLY = 0.02; // rad

    protected ActuatorContract() {
        super(Actuator.class, "r1/turntable");
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of("turntable", "turntable");
    }

    private Part.Actuator part() {
        return (Part.Actuator)
                java.util.Objects.requireNonNull(model().sensors().get("turntable"));
    }

    private ActuatorState state() {
        return device().latest().orElseThrow().value();
    }

    @Test
    void atFirstItRestsAtHome() {
        ActuatorState state = reading();
        assertThat(state.joint()).isEqualTo(part().joint());
        assertThat(state.limits().least()).isCloseTo(part().limits().least(), within(1e-3));
        assertThat(state.limits().most()).isCloseTo(part().limits().most(), within(1e-3));
        assertThat(state.position()).isCloseTo(part().home(), within(NEARLY));
        assertThat(state.speed()).isZero();
        assertThat(state.motion()).isEqualTo(Motion.IDLE);
    }

    @Test
    void goesWhereItIsSentNoFasterThanItCan() {
        GoalHandle<ActuatorState, Result> handle = device().goTo(2);
        advance(0.5);
        assertThat(state().motion()).isEqualTo(Motion.MOVING);
        assertThat(state().position()).isGreaterThan(0.1).isLessThanOrEqualTo(0.6 * part().maxSpeed());
        assertThat(state().speed()).isPositive().isLessThanOrEqualTo(part().maxSpeed() * 1.01);
        assertThat(await(handle.result()))
                .isInstanceOfSatisfying(
                        Result.Reached.class,
                        reached -> assertThat(reached.position()).isCloseTo(2, within(NEARLY)));
        advance(1);
        assertThat(state().position()).isCloseTo(2, within(NEARLY));
        assertThat(state().motion()).isEqualTo(Motion.IDLE);
    }

    @Test
    void goesHome() {
        await(device().goTo(-1).result());
        assertThat(await(device().home().result())).isInstanceOf(Result.Reached.class);
        assertThat(state().position()).isCloseTo(part().home(), within(NEARLY));
    }

    @Test
    void goesNoFartherThanItsLimits() {
        Result result = await(device().goTo(100).result());
        assertThat(result)
                .isInstanceOfSatisfying(
                        Result.Reached.class,
                        reached -> assertThat(reached.position())
                                .isCloseTo(part().limits().most(), within(NEARLY)));
        for (int step = 0; step < 10; step++) {
            device().command(1);
            run.advance(STEP);
        }
        assertThat(state().position()).isCloseTo(part().limits().most(), within(NEARLY));
    }

    @Test
    void movesAtASpeedUntilCommandsDryUp() {
        for (int step = 0; step < 10; step++) {
            device().command(-0.5);
            run.advance(STEP);
        }
        assertThat(state().speed()).isCloseTo(-0.5, within(0.05));
        assertThat(state().position()).isBetween(-0.6, -0.3);
        advance(1);
        assertThat(state().speed()).isZero();
        double stopped = state().position();
        assertThat(stopped).isBetween(-0.9, -0.4);
        advance(1);
        assertThat(state().position()).isEqualTo(stopped);
    }

    @Test
    void aNewGoalOrCommandTakesOver() {
        List<Result> first = endings(device().goTo(2));
        advance(0.3);
        List<Result> second = endings(device().goTo(-2));
        assertThat(first).containsExactly(new Result.Cancelled());
        advance(0.3);
        device().command(0);
        assertThat(second).containsExactly(new Result.Cancelled());
        advance(1);
        assertThat(state().motion()).isEqualTo(Motion.IDLE);
        assertThat(state().position()).isBetween(-0.6, 0.6);
    }

    @Test
    void calledOffItStaysWhereItIs() {
        GoalHandle<ActuatorState, Result> handle = device().goTo(2);
        List<Result> endings = endings(handle);
        advance(0.5);
        handle.cancel();
        handle.cancel();
        advance(2);
        assertThat(endings).containsExactly(new Result.Cancelled());
        assertThat(state().position()).isLessThan(1.5);
        assertThat(state().speed()).isZero();
    }

    @Test
    void standsStillWhileItsRobotsMotorsAreOffAndGoesOnWhenTheyAreOn() {
        List<Result> endings = endings(device().goTo(2));
        advance(0.5);
        robot().require(DriveBase.class).enable(false);
        advance(0.3);
        double stopped = state().position();
        assertThat(state().motion()).isEqualTo(Motion.IDLE);
        assertThat(stopped).isBetween(0.1, 1.5);
        advance(3);
        assertThat(state().position()).isEqualTo(stopped);
        assertThat(endings).isEmpty();
        robot().require(DriveBase.class).enable(true);
        advance(4);
        assertThat(endings).hasSize(1).first().isInstanceOf(Result.Reached.class);
        assertThat(state().position()).isCloseTo(2, within(NEARLY));
    }

    @Test
    void speedsThatAreWantedWhileMotorsAreOffCountForNothing() {
        robot().require(DriveBase.class).enable(false);
        device().command(0.5);
        robot().require(DriveBase.class).enable(true);
        advance(1);
        assertThat(state().position()).isCloseTo(part().home(), within(NEARLY));
    }

    @Test
    void theEndOfAnOldGoalDoesNotTouchTheNewOne() {
        GoalHandle<ActuatorState, Result> old = device().goTo(-1);
        GoalHandle<ActuatorState, Result> now = device().goTo(1);
        old.cancel();
        assertThat(await(now.result())).isInstanceOf(Result.Reached.class);
    }

    @Test
    void goalsEndWhenItsSystemIsClosed() {
        List<Result> endings = endings(device().goTo(2));
        advance(0.3);
        system().close();
        advance(0.3);
        assertThat(endings).hasSize(1).first().isInstanceOf(Result.Stuck.class);
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void refusesWhatIsNotFinite(double value) {
        List<Result> endings = endings(device().goTo(1));
        assertThatIllegalArgumentException().isThrownBy(() -> device().goTo(value));
        assertThatIllegalArgumentException().isThrownBy(() -> device().command(value));
        advance(3);
        assertThat(endings).as("goes on with what it did").hasSize(1).first().isInstanceOf(Result.Reached.class);
    }

    private static List<Result> endings(GoalHandle<ActuatorState, Result> handle) {
        var endings = new ArrayList<Result>();
        handle.result().thenAccept(endings::add);
        return endings;
    }
}
