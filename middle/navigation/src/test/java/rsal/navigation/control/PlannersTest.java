package rsal.navigation.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.ServiceLoader;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.GlobalPlanner;
import rsal.navigation.wavefront.Plan;
import rsal.settings.Arguments;
import rsal.testkit.DrawnMap;

/// What each global planner of the installation owes.
class PlannersTest {
    /// Two ways from `a` to `b`; `c` is shut in.
    private static final DrawnMap ROOM = DrawnMap.grid(0.25, """
            #########################
            #.......................#
            #.......................#
            #...a...............b...#
            #.......................#
            #.......................#
            #......###########......#
            #......#.........#......#
            #......#....c....#......#
            #......#.........#......#
            #......###########......#
            #.......................#
            #.......................#
            #.......................#
            #.......................#
            #########################""");

    private static final Point2d START = ROOM.place('a');
    private static final Point2d GOAL = ROOM.place('b');
    private static final double RADIUS = 0.3; // m

    static Stream<PlannerType> planners() {
        return ServiceLoader.load(PlannerType.class).stream().map(ServiceLoader.Provider::get);
    }

    private static GlobalPlanner make(PlannerType type) {
        var costs =
                CostMap.of(ROOM.grid(), DistanceField.toNotFree(ROOM.grid()), new CostMap.Clearance(RADIUS, 0.6, 3));
        return type.create(Arguments.defaults(type.parameters()), costs);
    }

    private static Path2d path(Plan plan) {
        assertThat(plan).isInstanceOf(Plan.Found.class);
        return ((Plan.Found) plan).path();
    }

    @Test
    void thereAreTwo() {
        assertThat(planners().map(PlannerType::key)).containsExactlyInAnyOrder("jumppoint", "wavefront");
    }

    @ParameterizedTest
    @MethodSource("planners")
    void theySayWhatTheyAre(PlannerType type) {
        assertThat(type.description()).isNotBlank().endsWith(".");
        assertThat(make(type).map().grid()).isEqualTo(ROOM.grid());
    }

    @ParameterizedTest
    @MethodSource("planners")
    void theyGoStraightWhereNothingIs(PlannerType type) {
        Path2d path = path(make(type).plan(START, GOAL, 0, List.of()));
        assertThat(path.points().getFirst()).isEqualTo(START);
        assertThat(path.points().getLast().distanceTo(GOAL)).isLessThan(0.3);
        assertThat(path.length()).isCloseTo(START.distanceTo(GOAL), within(0.5));
    }

    /// A fence from the upper wall to the box in the middle: the way leads around below.
    @ParameterizedTest
    @MethodSource("planners")
    void theyGoAroundWhatIsNotOnTheMap(PlannerType type) {
        var fence = new ArrayList<Point2d>();
        for (double y = ROOM.place('c').y(); y < START.y() + 1; y += 0.1) {
            fence.add(new Point2d(ROOM.place('c').x(), y));
        }
        GlobalPlanner planner = make(type);
        Path2d around = path(planner.plan(START, GOAL, 0, fence));
        assertThat(around.length()).isGreaterThan(START.distanceTo(GOAL) + 1);
        for (int i = 1; i < around.points().size(); i++) {
            Point2d from = around.points().get(i - 1);
            Point2d to = around.points().get(i);
            for (double share = 0; share <= 1; share += 0.02) {
                var at = new Point2d(from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()));
                assertThat(fence)
                        .allSatisfy(post -> assertThat(post.distanceTo(at)).isGreaterThan(RADIUS - 0.26));
            }
        }
        assertThat(path(planner.plan(START, GOAL, 0, List.of())).length())
                .as("and forget it")
                .isCloseTo(START.distanceTo(GOAL), within(0.5));
    }

    @ParameterizedTest
    @MethodSource("planners")
    void theySayWhyThereIsNoWay(PlannerType type) {
        Plan plan = make(type).plan(START, ROOM.place('c'), 0, List.of());
        assertThat(plan)
                .isInstanceOfSatisfying(
                        Plan.None.class, none -> assertThat(none.why()).endsWith("."));
        assertThat(make(type).plan(START, ROOM.place('c'), 3, List.of())).isInstanceOf(Plan.Found.class);
    }
}
