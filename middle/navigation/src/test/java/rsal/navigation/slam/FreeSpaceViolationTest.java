package rsal.navigation.slam;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.navigation.scanmatch.Cloud;
import rsal.navigation.scanmatch.Walls;

class FreeSpaceViolationTest {
    private static final Walls HALL = new Walls().box(0, 0, 14, 3);
    private static final Walls ROOM = new Walls().box(0, 0, 5, 6);

    private final SplittableRandom random = new SplittableRandom(4);
    private final List<GraphNode> frames = new ArrayList<>();
    private final List<Pose2d> poses = new ArrayList<>();

    /// Drives ahead and back in a world, through the same poses in each.
    private void drive(Walls world, int scans) {
        for (int i = 0; i < scans; i++) {
            var pose = new Pose2d(1 + 0.15 * (i % 20), 1.5, i % 40 < 20 ? 0.2 : 2.9);
            LaserScan scan = world.scan(pose, 0.01, random);
            frames.add(new GraphNode(pose, 0.15 * i, scan, Cloud.of(scan, 25)));
            poses.add(pose);
        }
    }

    @Test
    void twoPlacesOnTopOfEachOtherAreTooMuch() {
        drive(HALL, 40);
        drive(ROOM, 40);

        assertThat(FreeSpaceViolation.of(frames, poses)).hasValueSatisfying(most -> {
            assertThat(most.isTooMuch()).isTrue();
            assertThat(most.share()).isBetween(0.3, 1.0);
            assertThat(most.to() - most.from()).isEqualTo(19);
        });
    }

    @Test
    void onePlaceContradictsItselfNot() {
        drive(HALL, 80);

        assertThat(FreeSpaceViolation.of(frames, poses)).hasValueSatisfying(most -> {
            assertThat(most.isTooMuch()).isFalse();
            assertThat(most.share()).isLessThan(0.02);
        });
    }

    @Test
    void whatTwoScansHaveSeenMayHaveGone() {
        drive(HALL, 40);
        drive(new Walls().box(0, 0, 14, 3).chain(6, 0, 6, 3), 2);
        drive(HALL, 38);

        assertThat(FreeSpaceViolation.of(frames, poses))
                .hasValueSatisfying(most -> assertThat(most.share()).isLessThan(0.02));
    }

    @Test
    void aFewScansSayNothing() {
        drive(HALL, 9);

        assertThat(FreeSpaceViolation.of(frames, poses)).isEmpty();
    }
}
