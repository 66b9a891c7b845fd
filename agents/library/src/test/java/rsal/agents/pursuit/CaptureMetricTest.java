package rsal.agents.pursuit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.Walls;
import rsal.metric.Metric;
import rsal.metric.MetricType;
import rsal.settings.Arguments;
import rsal.testkit.DrawnMap;
import rsal.testkit.contract.MetricContract;
import rsal.testkit.fake.FakeRun;
import rsal.testkit.fake.FakeRun.Event;
import rsal.testkit.fake.FakeRun.Sample;

class CaptureMetricTest implements MetricContract {
    /// `p` is 2 m from `n` and, through a wall, `w`; far from `f`.
    private static final DrawnMap ROOM = DrawnMap.grid(1, """
            ###########
            #..p.n...f#
            #..########
            #..w......#
            ###########""");

    private static final Pose2d PREY = ROOM.pose('p', 0);

    private FakeRun run = new FakeRun(ROOM.grid());
    private Metric captures = begin(ROOM.grid());

    @Override
    public MetricType type() {
        return new CaptureMetric();
    }

    private Metric begin(OccupancyGrid map) {
        run = new FakeRun(map);
        run.place("prey-1", "prey", PREY);
        captures = type().create(Arguments.defaults(List.of()), run);
        return captures;
    }

    private double caught() {
        return captures.value("caught", List.of("prey"));
    }

    private void says(double distance, char hunter) {
        run.place("hunter-1", "hunter", ROOM.pose(hunter, 0));
        captures.onMessage("prey-1", new Caught("prey-1", "hunter-1", distance));
    }

    private void step(char hunter) {
        run.place("hunter-1", "hunter", ROOM.pose(hunter, 0));
        captures.onStep();
    }

    @Test
    void countsAtOnceWhereItIsTrue() {
        says(1.5, 'n'); // the prey may be wrong by 1 m
        assertThat(caught()).isEqualTo(1);
        assertThat(captures.holdsForAll("caught", "prey", 1)).isTrue();
        assertThat(captures.holdsForAll("caught", "prey", 2)).isFalse();
        assertThat(captures.value("caught", List.of("hunter"))).isZero();
        says(1.5, 'n');
        assertThat(run.samples()).as("only once").containsExactly(new Sample("captureDistance", "prey-1", 2));
        assertThat(run.events()).isEmpty();
    }

    @Test
    void countsNotThroughAWall() {
        says(1.9, 'w');
        assertThat(run.events())
                .containsExactly(new Event(
                        "uncaught", "prey-1", "is not caught: 'hunter-1' is really 2.00 m away, behind a wall"));
        step('w');
        assertThat(caught()).isZero();
    }

    /// The wall ends a little beyond the straight line between them.
    @Test
    void whoIsSeenInPartIsInSight() {
        Pose2d prey = new Pose2d(4.5, 3.4, 0);
        Pose2d corner = new Pose2d(3.6, 1.5, 0);
        OccupancyGrid map = DrawnMap.grid(1, """
                #######
                #.....#
                #.....#
                ####..#
                #.....#
                #######""").grid();
        assertThat(new Walls(map).standBetween(prey.position(), corner.position()))
                .isTrue();
        begin(map);
        run.place("prey-1", "prey", prey);
        run.place("h", "hunter", corner);
        captures.onMessage("prey-1", new Caught("prey-1", "h", 1.5));
        assertThat(caught()).isEqualTo(1);
    }

    @Test
    void countsFromWhenItBecomesTrue() {
        says(1.5, 'f');
        step('f');
        assertThat(caught()).isZero();
        run.place("hunter-2", "hunter", ROOM.pose('n', 0)); // another hunter comes
        captures.onStep();
        assertThat(caught()).isEqualTo(1);
        assertThat(run.samples()).containsExactly(new Sample("captureDistance", "prey-1", 2));
        assertThat(run.events()).extracting(Event::kind).containsExactly("uncaught", "caught");
    }

    @Test
    void aRobotOfAnotherRoleCatchesNobody() {
        says(1.5, 'f');
        run.place("guard-1", "guard", ROOM.pose('n', 0));
        captures.onStep();
        assertThat(caught()).isZero();
    }

    @Test
    void believesAPreyWhereNobodyKnowsBetter() {
        run.placeNowhere("prey-1", "prey");
        says(1.5, 'f');
        assertThat(caught()).isEqualTo(1);
        assertThat(run.samples()).isEmpty();
    }
}
