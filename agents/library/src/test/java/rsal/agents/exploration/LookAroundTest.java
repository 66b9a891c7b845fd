package rsal.agents.exploration;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import rsal.behavior.Percept;
import rsal.behavior.Surroundings;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;

class LookAroundTest {
    private static final double RATE = Math.toRadians(45);
    private static final double ENOUGH = Math.toRadians(330);
    private static final double STEP = 0.1; // s

    /// Where a robot is held up, by heading.
    private record Stops(double left, double right) {}

    /// What came of turning between two headings until it was done, or a minute was over.
    private record Look(boolean done, double leftmost, double rightmost, double seconds) {}

    private static Look look(Stops stops) {
        var around = new LookAround(RATE, ENOUGH, Duration.ofSeconds(1));
        double heading = 0;
        double leftmost = 0;
        double rightmost = 0;
        int steps = 0;
        for (; steps < 600 && !around.isDone(); steps++) {
            Twist2d wanted = around.act(percept(heading, steps), Twist2d.STOP);
            heading = Math.clamp(heading + wanted.omega() * STEP, stops.right, stops.left);
            leftmost = Math.max(leftmost, heading);
            rightmost = Math.min(rightmost, heading);
        }
        assertThat(around.act(percept(heading, steps), Twist2d.STOP).omega() == 0)
                .isEqualTo(around.isDone());
        return new Look(around.isDone(), leftmost, rightmost, steps * STEP);
    }

    private static Percept percept(double heading, int step) {
        var nothing = new float[Surroundings.SECTORS];
        Arrays.fill(nothing, Float.NaN);
        return new Percept(
                Instant.EPOCH.plusMillis(100L * step),
                new Odometry(new Pose2d(0, 0, heading), Twist2d.STOP, false),
                new Surroundings(nothing));
    }

    @Test
    void turnsToTheLeftUntilAllWasSeen() {
        Look free = look(new Stops(100, -100));
        assertThat(free.done).isTrue();
        assertThat(free.rightmost).isZero();
        assertThat(free.leftmost).isCloseTo(ENOUGH, Offset.offset(RATE * STEP * 2));
    }

    @Test
    void turnsTheOtherWayWhereItIsHeldUp() {
        Look held = look(new Stops(0.3, -100));
        assertThat(held.done).isTrue();
        assertThat(held.leftmost).isEqualTo(0.3);
        assertThat(held.rightmost).isCloseTo(0.3 - ENOUGH, Offset.offset(RATE * STEP * 2));
    }

    @Test
    void isDoneWhereItIsHeldUpOnBothSides() {
        Look held = look(new Stops(0.3, -0.4));
        assertThat(held.done).isTrue();
        assertThat(held.rightmost).isEqualTo(-0.4);
        assertThat(held.seconds).isBetween(3.0, 5.0);
    }
}
