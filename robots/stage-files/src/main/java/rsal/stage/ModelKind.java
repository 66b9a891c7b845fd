package rsal.stage;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import rsal.data.Twist2d;

/// What a model can do, by Stage's types. Angles are in rad, counter-clockwise.
public sealed interface ModelKind {

    /// `model`: it is there.
    record Thing() implements ModelKind {}

    /// `position`: the base of a robot.
    ///
    /// @param wheelbase between the axes of a car [m]
    /// @param velocity it starts with
    /// @param speeds what commands are clamped to [m/s, rad/s]
    /// @param accelerations how fast its velocity can change [m/s², rad/s²]
    /// @param odometryOrigin what odometry says at the start; the start pose when empty
    /// @param odometryError part of each way that odometry adds to it; drawn from the run's seed when empty
    record Position(
            Drive drive,
            double wheelbase,
            Twist2d velocity,
            Limits speeds,
            Limits accelerations,
            Localization localization,
            Optional<Placement> odometryOrigin,
            Optional<OdometryError> odometryError)
            implements ModelKind {}

    enum Drive {
        DIFFERENTIAL,
        OMNIDIRECTIONAL,
        CAR
    }

    enum Localization {
        /// It knows where it is in the world.
        GPS,
        /// It adds up its movements, with an error.
        ODOMETRY
    }

    /// Bounds of a velocity or acceleration.
    ///
    /// @param x forward
    /// @param y to the left
    /// @param z up
    /// @param turn counter-clockwise
    record Limits(ValueRange x, ValueRange y, ValueRange z, ValueRange turn) {}

    /// Shares: 0.05 adds 5 cm to each meter.
    ///
    /// @param turn rad to each rad
    record OdometryError(double x, double y, double z, double turn) {}

    /// `ranger`: a laser scanner, sonars, infrared sensors.
    record Ranger(List<Transducer> transducers) implements ModelKind {
        public Ranger {
            transducers = List.copyOf(transducers);
        }
    }

    /// One eye of a ranger.
    ///
    /// @param rangerFromTransducer rays leave at half the size's height above it
    /// @param size as it is drawn
    /// @param range what it can measure [m]
    /// @param fov angle between first and last ray; a single ray goes straight ahead
    /// @param samples how many rays; the first is the rightmost
    record Transducer(
            Placement rangerFromTransducer, Size size, ValueRange range, double fov, int samples, RangeNoise noise) {
        /// Angle between two rays [rad]; 0 for a single one.
        public double spacing() {
            return samples > 1 ? fov / (samples - 1) : 0;
        }

        /// Direction of the first ray in the transducer's frame [rad].
        public double first() {
            return samples > 1 ? -fov / 2 : 0;
        }
    }

    /// As Stage adds it to what was hit: range · (1 + relative · u) + a normal value, u uniform in [-1, 1).
    ///
    /// @param variance of the normal value [m²]
    /// @param angular half of this times u times the spacing turns each ray
    record RangeNoise(double variance, double relative, double angular) {
        static final RangeNoise NONE = new RangeNoise(0, 0, 0);
    }

    /// `blobfinder`: a camera that reports patches of color.
    ///
    /// @param colors it looks for; any when empty
    /// @param columns of its image [px]
    /// @param rows of its image [px]
    /// @param range how far it sees [m]
    /// @param fov angle of its image
    /// @param pan direction of the image's middle
    record Blobfinder(List<StageColor> colors, int columns, int rows, double range, double fov, double pan)
            implements ModelKind {
        public Blobfinder {
            colors = List.copyOf(colors);
        }
    }

    /// `fiducial`: sees markers.
    ///
    /// @param range in which it sees that there is one [m]
    /// @param idRange up to which it reads the id [m]
    /// @param key of the markers that it sees
    /// @param ignoresHeight whether it sees over and under things
    record Fiducial(ValueRange range, double idRange, double fov, int key, boolean ignoresHeight)
            implements ModelKind {}

    /// `gripper`: two paddles that close and a lift. Its body is its back; the paddles stand in front of that.
    ///
    /// @param paddle size of one [m]
    /// @param closed whether the paddles are at first
    /// @param up whether the lift is at first
    /// @param snatches whether it closes by itself when something is between the paddles
    record Gripper(Size paddle, boolean closed, boolean up, boolean snatches) implements ModelKind {}

    /// `bumper`: feels what it touches.
    record Bumper(List<Strip> strips) implements ModelKind {
        public Bumper {
            strips = List.copyOf(strips);
        }
    }

    /// A part of a bumper: a line across its frame's x axis.
    ///
    /// @param length of the line [m]
    record Strip(Placement bumperFromStrip, double length) {}

    /// `actuator`: a joint that moves its children.
    ///
    /// @param x of the axis that it moves along, when linear; of length 1
    /// @param turning whether it turns around z rather than moves along its axis
    /// @param positions that it can take [m or rad]
    /// @param maxSpeed [m/s or rad/s]
    /// @param start position
    record Actuator(boolean turning, double x, double y, double z, ValueRange positions, double maxSpeed, double start)
            implements ModelKind {}

    /// `camera`: gives no images here.
    ///
    /// @param columns of its image [px]
    /// @param rows of its image [px]
    /// @param range what it sees [m]
    /// @param fov angle of the image across
    /// @param fovHeight angle of the image up and down
    /// @param pan direction of the image's middle
    /// @param tilt the same, up
    record Camera(int columns, int rows, ValueRange range, double fov, double fovHeight, double pan, double tilt)
            implements ModelKind {}

    /// `blinkenlight`: a lamp.
    ///
    /// @param period from one flash to the next
    /// @param dutyCycle share of the period that it is on, 0–1
    record Blinkenlight(Duration period, double dutyCycle, boolean enabled) implements ModelKind {}

    /// `lightindicator`: a box that shows whether something is on.
    record LightIndicator() implements ModelKind {}
}
