package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import org.junit.jupiter.api.Test;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;

class RecentOdometryTest {
    private final RecentOdometry odometry = new RecentOdometry();

    @Test
    void reportsWhereTheRobotWasWhenSomethingWasMeasured() {
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

    @Test
    void remembersASecondForScansThatComeLate() {
        for (int i = 0; i <= 100; i++) {
            add(1000 + 20 * i, new Pose2d(0.01 * i, 0, 0)); // half a meter per second
        }
        for (int late = 0; late <= 1000; late += 50) {
            double x = 1 - 0.0005 * late;
            assertThat(odometry.odomFromBase(at(3000 - late)))
                    .hasValueSatisfying(pose -> assertThat(pose.x()).isCloseTo(x, within(1e-9)));
        }
        assertThat(odometry.odomFromBase(at(1900))).as("nothing tells").isEmpty();
    }

    @Test
    void beginsAnewWhenAClockIsSetBack() {
        add(5000, new Pose2d(1, 0, 0));
        add(5100, new Pose2d(2, 0, 0));
        add(100, new Pose2d(3, 0, 0));
        assertThat(odometry.newest()).contains(new Pose2d(3, 0, 0));
        assertThat(odometry.odomFromBase(at(100))).contains(new Pose2d(3, 0, 0));
    }

    private void add(long millis, Pose2d odomFromBase) {
        odometry.add(new Stamped<>(at(millis), "odom", new Odometry(odomFromBase, Twist2d.STOP, false)));
    }

    private static Instant at(long millis) {
        return Instant.ofEpochMilli(millis);
    }
}
