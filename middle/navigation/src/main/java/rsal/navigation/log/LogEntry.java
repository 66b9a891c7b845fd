package rsal.navigation.log;

import java.time.Instant;
import rsal.data.LaserScan;
import rsal.data.Pose2d;

/// One message of a log that was understood.
public sealed interface LogEntry {
    /// Line of the log it stands in, from 1.
    int line();

    /// What the wheels say (`ODOM` in CARMEN's logs).
    ///
    /// @param speed forward [m/s]
    /// @param turnRate counter-clockwise [rad/s]
    record Motion(int line, Instant time, Pose2d odomFromBase, double speed, double turnRate) implements LogEntry {}

    /// A sweep of the laser (`FLASER`, `ROBOTLASER1`, `RAWLASER1`).
    ///
    /// @param time when it was taken
    /// @param poses where the robot was
    /// @param broken readings that were no numbers, below zero or zero
    record Scan(int line, Instant time, LaserScan scan, Poses poses, int broken) implements LogEntry {
        /// The same, with other ranges.
        Scan with(LaserScan other) {
            return new Scan(line, time, other, poses, broken);
        }
    }

    /// A setting of the robot that made the log (`PARAM`).
    record Parameter(int line, String name, String value) implements LogEntry {}

    /// Where a robot was when it took a scan.
    sealed interface Poses {
        /// The log doesn't tell (`RAWLASER1`): the odometry around the scan may.
        record Unknown() implements Poses {}

        /// @param odomFromBase what the wheels said
        /// @param mapFromBase what the log's author made of it; the same in logs that hold only odometry, and
        /// where the odometry was replaced ("corrected")
        record Reported(Pose2d odomFromBase, Pose2d mapFromBase) implements Poses {}
    }
}
