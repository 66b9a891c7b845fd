package rsal.engine.metric;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.data.Walls;
import rsal.device.SimulationControl.Marker;
import rsal.device.SimulationControl.Standing;
import rsal.device.SimulationControl.Thing;
import rsal.engine.event.EventLog;
import rsal.engine.metric.ReachedMetrics.There;
import rsal.scenario.PlannedThings;
import rsal.scenario.PlannedThings.PlannedThing;
import rsal.scenario.PlannedThings.Reach;
import rsal.testkit.DrawnMap;

class ReachedMetricsTest {
    /// `v` is 2 m from `a`, `b` and, through a wall, `c`.
    private static final DrawnMap ROOM = DrawnMap.grid(1, """
            #########
            #a.v.b..#
            #..####.#
            #..c....#
            #########""");

    private static final Pose2d VICTIM = ROOM.pose('v', 0);
    private static final Solid BODY = Solid.standing(new Shape.Disc(new Point2d(0, 0), 0.2), 0.6);

    private final ReachedMetrics reached =
            new ReachedMetrics(List.of(victims()), new Walls(ROOM.grid()), new EventLog(() -> Duration.ZERO, () -> {}));

    private static PlannedThings victims() {
        var thing =
                new Thing("victim-1", VICTIM, BODY, Rgb.of(0x808080), true, false, Optional.of(new Marker(7, 0)), 0);
        return new PlannedThings(
                "victim",
                List.of(new PlannedThing(thing, Duration.ZERO)),
                Optional.empty(),
                Optional.of(new Reach(Optional.of("helper"), 2.1, Duration.ofSeconds(10))));
    }

    /// Where robots of a role are at a time [s].
    private void look(String role, char place, double now) {
        var standing = new Standing(1, "victim-1", BODY, VICTIM, 0, false);
        reached.look(List.of(standing), List.of(new There("r", role, ROOM.pose(place, 0))), now);
    }

    @Test
    void whoStaysForLongEnoughHasReachedIt() {
        look("helper", 'a', 5);
        look("helper", 'a', 14.9);
        assertThat(reached.reached("victim")).isZero();
        look("helper", 'b', 15);
        assertThat(reached.reached("victim")).isEqualTo(1);
        assertThat(reached.reached("other")).isZero();
    }

    @Test
    void whoLeavesInBetweenBeginsAgain() {
        look("helper", 'a', 5);
        look("helper", 'c', 10);
        look("helper", 'a', 11);
        look("helper", 'a', 20);
        assertThat(reached.reached("victim")).isZero();
    }

    @Test
    void whoStandsBehindAWallOrHasAnotherRoleDoesNotCount() {
        for (int second = 0; second < 30; second++) {
            look("helper", 'c', second);
        }
        for (int second = 30; second < 60; second++) {
            look("explorer", 'a', second);
        }
        assertThat(reached.reached("victim")).isZero();
    }
}
