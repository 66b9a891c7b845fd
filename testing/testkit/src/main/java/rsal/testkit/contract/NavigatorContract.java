package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.GoalHandle;
import rsal.device.Navigator;
import rsal.device.Navigator.Progress;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.testkit.Rounds;

/// What every [Navigator] owes.
public abstract class NavigatorContract extends DeviceContract<Navigator> {
    private static final double LONG = 120;

    protected NavigatorContract() {
        super(Navigator.class);
    }

    @Test
    void reachesAFreePlace() {
        Pose2d goal = WORLD.pose('a', 0);
        Result result = await(device().goTo(goal).result(), LONG);
        assertThat(result).isInstanceOf(Result.Reached.class);
        assertThat(truth().distanceTo(goal)).isLessThan(Tolerance.DEFAULT.distance() + 0.3);
        advance(2);
        assertStanding();
    }

    @Test
    void turnsAsAsked() {
        Pose2d goal = WORLD.pose('a', 90);
        Result result = await(device().goTo(goal, new Tolerance(0.4, 0.2)).result(), LONG);
        assertThat(result).isInstanceOf(Result.Reached.class);
        assertThat(truth().isNear(goal, 0.7, 0.5)).as("it is at %s", truth()).isTrue();
    }

    @Test
    void reportsItsProgress() {
        var progress = new ArrayList<Progress>();
        GoalHandle<Progress, Result> handle = device().goTo(WORLD.pose('a', 0), Tolerance.position(0.4));
        handle.onFeedback(stamped -> progress.add(stamped.value()));
        await(handle.result(), LONG);
        assertThat(progress).hasSizeGreaterThan(3);
        assertThat(progress.getLast().remaining())
                .isLessThan(progress.getFirst().remaining());
        assertThat(progress).extracting(Progress::driving).isSorted();
        assertThat(progress).allSatisfy(p -> assertThat(p.remaining()).isBetween(0.0, 20.0));
        int reported = progress.size();
        advance(2);
        assertThat(progress).as("told nothing after the end").hasSize(reported);
    }

    @Test
    void showsItsGoalAndItsWayWhileItDrives() {
        assertThat(device().goal()).isEmpty();
        assertThat(device().path().points()).isEmpty();
        Pose2d goal = WORLD.pose('a', 0);
        GoalHandle<Progress, Result> handle = device().goTo(goal);
        advance(3);
        assertThat(device().goal()).contains(goal);
        assertThat(device().path().points()).hasSizeGreaterThanOrEqualTo(2);
        await(handle.result(), LONG);
        assertThat(device().goal()).isEmpty();
        assertThat(device().path().points()).isEmpty();
    }

    @Test
    void theWayThatItMeansToGoBeginsWhereItIs() {
        assertThat(device().localPath().points()).isEmpty();
        GoalHandle<Progress, Result> handle = device().goTo(WORLD.pose('a', 0));
        for (int look = 0; look < 20; look++) {
            advance(0.5);
            List<Point2d> points = device().localPath().points();
            assertThat(points).hasSizeLessThanOrEqualTo(16);
            points.stream()
                    .limit(1)
                    .forEach(first ->
                            assertThat(first.distanceTo(truth().position())).isLessThan(0.5));
        }
        device().pause();
        assertThat(device().localPath().points()).isEmpty();
        device().resume();
        await(handle.result(), LONG);
        assertThat(device().localPath().points()).isEmpty();
    }

    @Test
    void canBeCalledOff() {
        GoalHandle<Progress, Result> handle = device().goTo(WORLD.pose('a', 0));
        List<Result> endings = endings(handle);
        advance(3);
        handle.cancel();
        handle.cancel();
        advance(2);
        assertThat(endings).containsExactly(Result.Cancelled.asked());
        assertThat(device().goal()).isEmpty();
        assertStanding();
    }

    @Test
    void aNewGoalTakesOver() {
        List<Result> first = endings(device().goTo(WORLD.pose('a', 0)));
        advance(3);
        Result second =
                await(device().goTo(WORLD.pose('b', 0), Tolerance.position(0.4)).result(), LONG);
        assertThat(first).containsExactly(Result.Cancelled.by(WORLD.pose('b', 0)));
        assertThat(second).isInstanceOf(Result.Reached.class);
        assertThat(truth().distanceTo(WORLD.pose('b', 0))).isLessThan(0.7);
    }

    @Test
    void theEndOfAnOldGoalDoesNotTouchTheNewOne() {
        GoalHandle<Progress, Result> old = device().goTo(WORLD.pose('a', 0));
        advance(1);
        GoalHandle<Progress, Result> now = device().goTo(WORLD.pose('b', 0), Tolerance.position(0.4));
        old.cancel();
        assertThat(await(now.result(), LONG)).isInstanceOf(Result.Reached.class);
    }

    @Test
    void pausedItStandsStillAndKeepsTheGoal() {
        Pose2d goal = WORLD.pose('a', 0);
        List<Result> endings = endings(device().goTo(goal, Tolerance.position(0.4)));
        advance(3);
        device().pause();
        assertThat(device().paused()).isTrue();
        advance(2);
        assertStanding();
        Pose2d paused = truth();
        advance(5);
        assertThat(truth()).isEqualTo(paused);
        assertThat(device().goal()).contains(goal);
        assertThat(endings).isEmpty();
        device().resume();
        assertThat(device().paused()).isFalse();
        for (int seconds = 0; seconds < 60 && endings.isEmpty(); seconds++) {
            advance(1);
        }
        assertThat(endings).hasSize(1).first().isInstanceOf(Result.Reached.class);
    }

    @Test
    void aPlaceWithoutAWayEndsInNoPath() {
        Result result = await(device().goTo(WORLD.pose('x', 0)).result(), LONG);
        assertThat(result)
                .isInstanceOfSatisfying(
                        Result.NoPath.class, no -> assertThat(no.why()).isNotBlank());
        assertThat(device().goal()).isEmpty();
    }

    @Test
    void standingThereAlreadyIsReached() {
        Result result = await(device().goTo(START, Tolerance.position(0.5)).result(), 10);
        assertThat(result).isInstanceOf(Result.Reached.class);
        assertThat(truth().distanceTo(START)).isLessThan(0.5);
    }

    @Test
    void everyGoalEndsOnce() {
        var endings = new ArrayList<List<Result>>();
        char[] places = {'a', 'b', 'c', 'x', 'a'};
        for (char place : places) {
            endings.add(endings(device().goTo(WORLD.pose(place, 0), Tolerance.position(0.4))));
            advance(1.5);
        }
        for (int second = 0; second < 90 && endings.getLast().isEmpty(); second++) {
            advance(1);
        }
        advance(Rounds.of(2, 60)); // in which a second ending would come
        assertThat(endings).allSatisfy(e -> assertThat(e).hasSize(1));
        assertThat(endings.getLast().getFirst()).isInstanceOf(Result.Reached.class);
    }

    @Test
    void refusesWhatIsNotFinite() {
        assertThatIllegalArgumentException().isThrownBy(() -> device().goTo(new Pose2d(Double.NaN, 0, 0)));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> device().goTo(new Pose2d(0, Double.POSITIVE_INFINITY, 0)));
        assertThat(device().goal()).isEmpty();
    }

    private static List<Result> endings(GoalHandle<Progress, Result> handle) {
        var endings = new ArrayList<Result>();
        handle.result().thenAccept(endings::add);
        return endings;
    }

    private void assertStanding() {
        assertThat(robot().require(DriveBase.class)
                        .latest()
                        .orElseThrow()
                        .value()
                        .velocity())
                .isEqualTo(Twist2d.STOP);
    }
}
