package rsal.server.description;

import java.util.List;
import rsal.data.Blobs;
import rsal.data.BumperState;
import rsal.data.Fiducials;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.engine.report.Reading;
import rsal.server.message.Messages.MountInfo;
import rsal.server.message.Messages.Mounts;

/// Where devices are mounted that tell it with what they measure.
public final class DeviceMountings {
    private DeviceMountings() {}

    public static Mounts of(List<Reading> readings) {
        return new Mounts(readings.stream()
                .flatMap(reading -> baseFromSensors(reading.value().value()).stream()
                        .map(pose -> new MountInfo(reading.device(), pose.x(), pose.y(), pose.theta())))
                .toList());
    }

    private static List<Pose2d> baseFromSensors(Object reported) {
        return switch (reported) {
            case LaserScan scan -> List.of(scan.baseFromLaser());
            case RangeArray array -> array.baseFromSensors();
            case Blobs seen -> List.of(seen.baseFromCamera());
            case Fiducials seen -> List.of(seen.baseFromFinder());
            case BumperState felt -> felt.baseFromBumpers();
            default -> List.of();
        };
    }
}
