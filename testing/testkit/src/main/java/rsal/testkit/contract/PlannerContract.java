package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.Planner;

/// What every [Planner] owes.
public abstract class PlannerContract extends DeviceContract<Planner> {
    protected PlannerContract() {
        super(Planner.class);
    }

    @Test
    void findsAWayThroughFreeSpaceFromStartToGoal() {
        Pose2d goal = WORLD.pose('a', 90);
        assertThat(plan(START, goal)).isInstanceOfSatisfying(Planner.Result.Found.class, found -> {
            List<Point2d> points = found.path().points();
            assertThat(points.getFirst().distanceTo(START.position())).isLessThan(0.3);
            assertThat(points.getLast().distanceTo(goal.position())).isLessThan(0.3);
            assertThat(found.path().length())
                    .isBetween(START.distanceTo(goal) - 0.5, 1.3 * START.distanceTo(goal) + 0.5);
            assertThat(found.cost()).isGreaterThanOrEqualTo(found.path().length() * 0.99);
            for (int i = 1; i < points.size(); i++) {
                assertFree(points.get(i - 1), points.get(i));
            }
        });
    }

    @Test
    void longerWaysCostMore() {
        assertThat(cost(START, WORLD.pose('a', 0))).isGreaterThan(cost(START, WORLD.pose('b', 0)));
    }

    @Test
    void theWayBackCostsTheSame() {
        double there = cost(START, WORLD.pose('a', 0));
        assertThat(cost(WORLD.pose('a', 0), START)).isCloseTo(there, within(0.1 * there));
    }

    @Test
    void aPlaceBehindWallsHasNoWay() {
        assertNoPath(WORLD.pose('x', 0));
    }

    @Test
    void aPlaceOutsideTheMapHasNoWay() {
        assertNoPath(new Pose2d(-5, 3, 0));
        assertNoPath(new Pose2d(1e9, 1e9, 0));
    }

    @Test
    void reportsCostsOfPathsToSeveralPlaces() {
        List<Pose2d> goals =
                List.of(WORLD.pose('b', 0), WORLD.pose('x', 0), WORLD.pose('a', 0), new Pose2d(-5, 3, 0), START);
        List<Double> costs = await(device().costs(START, goals, Double.POSITIVE_INFINITY));
        assertThat(costs).hasSameSizeAs(goals);
        for (int i = 0; i < goals.size(); i++) {
            double expected = plan(START, goals.get(i)) instanceof Planner.Result.Found found
                    ? found.cost()
                    : Double.POSITIVE_INFINITY;
            assertThat(costs.get(i))
                    .as("to %s", goals.get(i))
                    .satisfiesAnyOf(
                            cost -> assertThat(cost).isEqualTo(expected),
                            cost -> assertThat(cost).isCloseTo(expected, within(0.01)));
        }
        assertThat(await(device().costs(START, List.of(), 0))).isEmpty();
    }

    @Test
    void waysThatEndTooFarFromAPlaceLeadNowhereWhenAskedSo() {
        Pose2d there = WORLD.pose('a', 0);
        List<Pose2d> goals = IntStream.range(0, 40) // some of them too near to a wall
                .mapToObj(i -> new Pose2d(there.x() + 0.05 * i, there.y() + 0.05 * i, 0))
                .toList();
        for (double near : new double[] {0, 0.2}) {
            List<Double> costs = await(device().costs(START, goals, near));
            for (int i = 0; i < goals.size(); i++) {
                boolean leadsThere =
                        plan(START, goals.get(i)) instanceof Planner.Result.Found found && found.offGoal() <= near;
                assertThat(Double.isFinite(costs.get(i)))
                        .as("to %s, %s m from it", goals.get(i), near)
                        .isEqualTo(leadsThere);
            }
        }
    }

    @Test
    void reportsWhatItWasAskedLast() {
        assertThat(device().latest()).isEmpty();
        Pose2d goal = WORLD.pose('a', 90);
        Planner.Result.Found found = (Planner.Result.Found) plan(START, goal);
        Stamped<Planner.Asked> asked = device().latest().orElseThrow();
        assertThat(asked.frame()).isEqualTo("map");
        assertThat(asked.value())
                .isEqualTo(new Planner.Asked(
                        START,
                        goal,
                        1,
                        1,
                        OptionalDouble.of(found.cost()),
                        OptionalDouble.of(found.path().length()),
                        ""));

        advance(1);
        Pose2d nowhere = WORLD.pose('x', 0);
        String why = ((Planner.Result.NoPath) plan(START, nowhere)).why();
        assertThat(device().latest()).hasValueSatisfying(later -> {
            assertThat(later.time()).isAfter(asked.time());
            assertThat(later.value())
                    .isEqualTo(new Planner.Asked(
                            START, nowhere, 1, 0, OptionalDouble.empty(), OptionalDouble.empty(), why));
        });
    }

    @Test
    void askingMovesNothing() {
        Pose2d before = truth();
        plan(START, WORLD.pose('a', 0));
        advance(2);
        assertThat(truth()).isEqualTo(before);
    }

    private Planner.Result plan(Pose2d start, Pose2d goal) {
        return await(device().plan(start, goal));
    }

    private double cost(Pose2d start, Pose2d goal) {
        assertThat(plan(start, goal)).isInstanceOf(Planner.Result.Found.class);
        return ((Planner.Result.Found) plan(start, goal)).cost();
    }

    private void assertNoPath(Pose2d goal) {
        assertThat(plan(START, goal))
                .isInstanceOfSatisfying(
                        Planner.Result.NoPath.class, no -> assertThat(no.why()).isNotBlank());
    }

    private static void assertFree(Point2d from, Point2d to) {
        for (int i = 0; i <= 100; i++) {
            double x = from.x() + (to.x() - from.x()) * i / 100;
            double y = from.y() + (to.y() - from.y()) * i / 100;
            assertThat(WORLD.grid().isFree(x, y)).as("(%s, %s)", x, y).isTrue();
        }
    }
}
