package rsal.server.description;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Blobs;
import rsal.data.BumperState;
import rsal.data.Fiducials;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.engine.report.Reading;
import rsal.server.message.Messages.MountInfo;

class DeviceMountingsTest {
    private static final Pose2d AHEAD = new Pose2d(0.2, 0, 0);
    private static final Pose2d LEFT = new Pose2d(0, 0.1, 1.5);

    private static Reading reading(String device, Object value) {
        return new Reading(device, new Stamped<>(Instant.EPOCH, "base_link", value), Duration.ZERO);
    }

    @Test
    void reportsWhereEachSensorOfADeviceIs() {
        var sonar = new RangeArray(List.of(AHEAD, LEFT), 0.3, 0.1, 5, new float[2]);

        assertThat(DeviceMountings.of(List.of(reading("sonar", sonar))).mounts())
                .containsExactly(new MountInfo("sonar", 0.2, 0, 0), new MountInfo("sonar", 0, 0.1, 1.5));
    }

    @Test
    void saysNothingOfDevicesThatDoNotReportIt() {
        var readings = List.of(
                reading("base", new Odometry(AHEAD, Twist2d.STOP, false)),
                reading("camera", new Blobs(LEFT, 80, 60, 0.8, List.of())),
                reading("markers", new Fiducials(AHEAD, 3, 5, List.of())),
                reading("bumpers", new BumperState(List.of(LEFT), List.of(false))));

        assertThat(DeviceMountings.of(readings).mounts())
                .extracting(MountInfo::device)
                .containsExactly("camera", "markers", "bumpers");
    }
}
