package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Point2d;
import rsal.data.Pose2d;

class MateTest {
    private static final float NOTHING = Float.POSITIVE_INFINITY;

    /// To the right, ahead, to the left; the laser is 0.1 m before the base's middle.
    private static LaserScan scan(float right, float ahead, float left) {
        return new LaserScan(
                new Pose2d(0.1, 0, 0), -Math.PI / 2, Math.PI / 2, 0.1, 5, new float[] {right, ahead, left});
    }

    @Test
    void beamsThatEndAtAMateAreLeftOut() {
        var mates = List.of(new Mate(new Point2d(10, 7), 0.25));
        Pose2d mapFromBase = new Pose2d(10, 5, Math.PI / 2); // the mate is 2 m ahead
        assertThat(Mate.leaveOut(mates, scan(2, 1.7f, 3), mapFromBase).ranges()).containsExactly(2, Float.NaN, 3);
        assertThat(Mate.leaveOut(mates, scan(2, 1.3f, NOTHING), mapFromBase).ranges())
                .containsExactly(2, 1.3f, NOTHING); // something stands before it
        assertThat(Mate.leaveOut(mates, scan(2, 3f, 3), mapFromBase).ranges())
                .containsExactly(2, 3, 3); // the beam passes over it
    }

    @Test
    void aScanWithoutMatesNearIsTheSame() {
        LaserScan scan = scan(1, 2, 3);
        assertThat(Mate.leaveOut(List.of(), scan, Pose2d.ORIGIN)).isSameAs(scan);
        assertThat(Mate.leaveOut(List.of(new Mate(new Point2d(9, 0), 0.25)), scan, Pose2d.ORIGIN))
                .isSameAs(scan);
    }
}
