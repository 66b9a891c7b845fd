package rsal.server;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.Stamped;
import rsal.scenario.run.DeviceView;
import rsal.scenario.run.Reading;
import rsal.scenario.run.RobotView;

/// What of the devices of a robot is in a recording as they told it, in their order: its odometry, first scan and
/// sonars, and its estimate. Of grippers and navigators only what is drawn is recorded.
final class RecordedReadings {
    private RecordedReadings() {}

    /// @param now what the run's clock showed then
    static List<Reading> of(RobotView robot, Instant now) {
        var readings = new ArrayList<Reading>();
        for (DeviceView device : robot.devices()) {
            told(robot, device)
                    .map(value -> new Reading(device.name(), value, Duration.between(value.time(), now)))
                    .ifPresent(readings::add);
        }
        return readings;
    }

    private static Optional<? extends Stamped<?>> told(RobotView robot, DeviceView device) {
        if (!isFirst(robot, device)) {
            return Optional.empty(); // of several only the first is recorded
        }
        return switch (device.type()) { // as DeviceView calls them
            case "DriveBase" -> robot.odometry();
            case "LaserScanner" -> robot.scan();
            case "SonarArray" -> robot.ranges();
            case "Localizer" -> robot.estimate();
            default -> Optional.empty();
        };
    }

    private static boolean isFirst(RobotView robot, DeviceView device) {
        return robot.devices().stream()
                .filter(other -> other.type().equals(device.type()))
                .findFirst()
                .equals(Optional.of(device));
    }
}
