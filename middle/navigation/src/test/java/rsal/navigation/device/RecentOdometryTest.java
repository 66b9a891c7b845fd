package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import org.junit.jupiter.api.Test;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;

class RecentOdometryTest {
    private final RecentOdometry odometry = new RecentOdometry();

    @Test
    void tellsWhereTheRobotWasWhenSomethingWasMeasured() {
        assertThat(odometry.odomFromBase(Instant.EPOCH)).isEmpty();
        assertThat(odometry.newest()).isEmpty();
        add(1000, new Pose2d(1, 0, 0));
        assertThat(odometry.odomFromBase(at(500))).contains(new Pose2d(1, 0, 0));
        add(1100, new Pose2d(1, 0.1, 0.2));

        assertThat(odometry.odomFromBase(at(1050)))
                .hasValueSatisfying(pose -> assertThat(pose.isNear(new Pose2d(1, 0.05, 0.1), 1e-9, 1e-9))
                        .isTrue());
        assertThat(odometry.odomFromBase(at(900))).contains(new Pose2d(1, 0, 0));
        assertThat(odometry.odomFromBase(at(1200))).contains(new Pose2d(1, 0.1, 0.2));
        assertThat(odometry.newest()).contains(new Pose2d(1, 0.1, 0.2));
    }

    private void add(long millis, Pose2d odomFromBase) {
        odometry.add(new Stamped<>(at(millis), "odom", new Odometry(odomFromBase, Twist2d.STOP, false)));
    }

    private static Instant at(long millis) {
        return Instant.ofEpochMilli(millis);
    }
}
