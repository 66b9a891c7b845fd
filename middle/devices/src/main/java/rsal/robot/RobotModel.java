package rsal.robot;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import rsal.data.Footprint;
import rsal.data.Pose2d;

/// What a kind of robot is like: a file in `rsal/robot/models`, read by [RobotModels].
///
/// @param name `pioneer2dx`
/// @param title for people: `Pioneer 2-DX`
/// @param sensors the parts it carries, by device name (`laser`, `sonar`), in the file's order
public record RobotModel(String name, String title, Footprint footprint, Drive drive, Map<String, Part> sensors) {
    public RobotModel {
        sensors = java.util.Collections.unmodifiableMap(new java.util.LinkedHashMap<>(sensors));
    }

    /// A differential drive.
    ///
    /// @param maxSpeed [m/s]
    /// @param maxTurnRate [rad/s]
    /// @param maxAcceleration [m/s²], speeding up and slowing down
    /// @param maxTurnAcceleration [rad/s²]
    /// @param odometryNoise standard deviation of drift per way and turn made
    public record Drive(
            double maxSpeed,
            double maxTurnRate,
            double maxAcceleration,
            double maxTurnAcceleration,
            OdometryNoise odometryNoise) {}

    /// Standard deviations of what odometry gets wrong per step, growing with the square root of the way made, so
    /// that the step's length does not matter.
    ///
    /// @param distancePerMeter error of distance [m/√m]
    /// @param headingPerMeter error of heading from driving [rad/√m]
    /// @param headingPerRadian error of heading from turning [rad/√rad]
    public record OdometryNoise(double distancePerMeter, double headingPerMeter, double headingPerRadian) {}

    /// Something a model or a scenario mounts on a robot: a file in `rsal/robot/parts`.
    public sealed interface Part {
        String name();

        /// A planar laser scanner, beams from `angleMin` counter-clockwise.
        ///
        /// @param samples beams of a sweep
        /// @param noise standard deviation of a range [m]
        record Laser(
                String name,
                Pose2d baseFromLaser,
                double angleMin,
                double angleIncrement,
                int samples,
                double rangeMin,
                double rangeMax,
                double noise,
                Duration period)
                implements Part {}

        /// Single-range sensors, each a cone of `fieldOfView` [rad].
        ///
        /// @param noise standard deviation of a range [m]
        record Sonars(
                String name,
                List<Pose2d> baseFromSensors,
                double fieldOfView,
                double rangeMin,
                double rangeMax,
                double noise,
                Duration period)
                implements Part {
            public Sonars {
                baseFromSensors = List.copyOf(baseFromSensors);
            }
        }
    }
}
