package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.message.Caught;
import rsal.data.Pose2d;
import rsal.data.Walls;
import rsal.engine.ReachedMetrics.There;
import rsal.testkit.DrawnMap;

class CaptureMetricsTest {
    /// `p` is 2 m from `n` and, through a wall, `w`; far from `f`.
    private static final DrawnMap ROOM = DrawnMap.grid(1, """
            ###########
            #..p.n...f#
            #..########
            #..w......#
            ###########""");

    private static final Pose2d PREY = ROOM.pose('p', 0);

    private final EventLog eventLog = new EventLog(() -> Duration.ZERO, () -> {});
    private final CaptureMetrics captures = new CaptureMetrics(new Walls(ROOM.grid()), eventLog);

    @Test
    void countsAtOnceWhereItIsTrue() {
        assertThat(says("hunter-1", 1.5, 'n')).isTrue();
        assertThat(captures.caught()).containsExactly("prey");
        assertThat(captures.distance("prey")).hasValue(2); // the prey may be wrong by 1 m
        assertThat(captures.isWaiting()).isFalse();
        assertThat(says("hunter-1", 1.5, 'n')).as("only once").isFalse();
        assertThat(eventLog.after(0)).isEmpty();
    }

    @Test
    void countsNotThroughAWall() {
        assertThat(says("hunter-1", 1.9, 'w')).isFalse();
        assertThat(captures.caught()).isEmpty();
        assertThat(eventLog.after(0))
                .extracting(RunEvent::text)
                .containsExactly("is not caught: 'hunter-1' is really 2.00 m away, behind a wall");
        assertThat(captures.look(List.of(prey(), hunter("hunter-1", 'w')))).isEmpty();
    }

    /// The wall ends a little beyond the straight line between them.
    @Test
    void whoIsSeenInPartIsInSight() {
        Pose2d prey = new Pose2d(4.5, 3.4, 0);
        Pose2d corner = new Pose2d(3.6, 1.5, 0);
        Walls walls = new Walls(DrawnMap.grid(1, """
                #######
                #.....#
                #.....#
                ####..#
                #.....#
                #######""").grid());
        var seen = new CaptureMetrics(walls, eventLog);
        assertThat(walls.standBetween(prey.position(), corner.position())).isTrue();
        assertThat(seen.heard(new Caught("prey", "h", 1.5), "hunter", Optional.of(prey), Optional.of(corner)))
                .isTrue();
    }

    @Test
    void countsFromWhenItBecomesTrue() {
        assertThat(says("hunter-1", 1.5, 'f')).isFalse();
        assertThat(captures.isWaiting()).isTrue();
        assertThat(captures.look(List.of(prey(), hunter("hunter-1", 'f')))).isEmpty();
        assertThat(captures.look(List.of(prey(), hunter("hunter-1", 'f'), hunter("hunter-2", 'n'))))
                .as("another hunter comes")
                .containsExactly("prey");
        assertThat(captures.caught()).containsExactly("prey");
        assertThat(captures.distance("prey")).hasValue(2);
        assertThat(captures.isWaiting()).isFalse();
        assertThat(eventLog.after(0)).extracting(RunEvent::kind).containsExactly("uncaught", "caught");
    }

    @Test
    void believesAPreyWhereNobodyKnowsBetter() {
        assertThat(captures.heard(new Caught("prey", "hunter-1", 1.5), "hunter", Optional.empty(), Optional.of(PREY)))
                .isTrue();
        assertThat(captures.caught()).containsExactly("prey");
        assertThat(captures.distance("prey")).isEmpty();
    }

    private boolean says(String hunter, double distance, char where) {
        return captures.heard(
                new Caught("prey", hunter, distance), "hunter", Optional.of(PREY), Optional.of(ROOM.pose(where, 0)));
    }

    private static There prey() {
        return new There("prey", "prey", PREY);
    }

    private static There hunter(String name, char where) {
        return new There(name, "hunter", ROOM.pose(where, 0));
    }
}
