package rsal.robot;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.ActuatorState.Joint;
import rsal.data.Footprint;
import rsal.data.Interval;
import rsal.data.LightState.Signal;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.device.LaserScanner;
import rsal.device.SonarArray;
import rsal.settings.Arguments;

/// What a kind of robot is like: a file in `rsal/model/models`, read by the module `models`. Places of what actuators
/// carry hold while the actuators are at home.
///
/// Longer than 500 lines, since the parts of a model are values inside it: drive, body, sensors, actuators.
///
/// @param name `pioneer2dx`
/// @param title for people: `Pioneer 2-DX`
/// @param body what is solid of it, in its base frame; pieces without a color have that of the robot
/// @param sensors the parts it carries, by device name (`laser`, `sonar`), in the file's order
/// @param heights above the floor [m] of those that do not sit on top of the body, by device name
/// @param carriers the actuators that devices stand on, both by device name; those not named stand on the base
public record RobotModel(
        String name,
        String title,
        Solid body,
        Drive drive,
        Map<String, Part> sensors,
        Map<String, Double> heights,
        Map<String, String> carriers) {
    /// Height of a robot's body where none is given [m].
    public static final double HEIGHT = 0.25;

    public RobotModel {
        sensors = java.util.Collections.unmodifiableMap(new java.util.LinkedHashMap<>(sensors));
        heights = Map.copyOf(heights);
        carriers = Map.copyOf(carriers);
        for (String device : carriers.keySet()) {
            chain(device, sensors, carriers);
        }
    }

    /// A model with all devices on its base.
    public RobotModel(
            String name,
            String title,
            Solid body,
            Drive drive,
            Map<String, Part> sensors,
            Map<String, Double> heights) {
        this(name, title, body, drive, sensors, heights, Map.of());
    }

    /// A model with all devices on top of its body.
    public RobotModel(String name, String title, Solid body, Drive drive, Map<String, Part> sensors) {
        this(name, title, body, drive, sensors, Map.of());
    }

    /// A model of a plain body.
    public RobotModel(String name, String title, Footprint footprint, Drive drive, Map<String, Part> sensors) {
        this(name, title, Solid.standing(Shape.Polygon.of(footprint), HEIGHT), drive, sensors);
    }

    /// Its convex outline, which is what it takes for itself when it keeps out of the way of things.
    public Footprint footprint() {
        return body.hull();
    }

    /// How high above the floor a device looks or works [m].
    public double height(String device) {
        return heights.getOrDefault(device, body.top());
    }

    /// At which height a device looks or works in simulated worlds [m], where all is level. Where its own is not told,
    /// that is half as high as the body, so that it meets what stands on the floor.
    public double level(String device) {
        return heights.getOrDefault(device, body.top() / 2);
    }

    /// The actuators that carry a device, from the base outwards.
    public List<String> carriersOf(String device) {
        return chain(device, sensors, carriers);
    }

    private static List<String> chain(String device, Map<String, Part> sensors, Map<String, String> carriers) {
        var chain = new ArrayDeque<String>();
        for (String on = carriers.get(device); on != null; on = carriers.get(on)) {
            if (!(sensors.get(on) instanceof Part.Actuator) || chain.contains(on)) {
                throw new IllegalArgumentException("Device '%s' can't stand on '%s'.".formatted(device, on));
            }
            chain.addFirst(on);
        }
        return List.copyOf(chain);
    }

    /// The same robot with another drive.
    public RobotModel with(Drive other) {
        return new RobotModel(name, title, body, other, sensors, heights, carriers);
    }

    /// How it moves.
    ///
    /// @param steering what it can do at all
    /// @param forward along its x axis [m/s, m/s²]
    /// @param sideways along its y axis [m/s, m/s²]; nothing unless it is omnidirectional
    /// @param turn counter-clockwise [rad/s, rad/s²]
    /// @param odometryNoise standard deviation of drift per way and turn made
    public record Drive(Steering steering, Axis forward, Axis sideways, Axis turn, OdometryNoise odometryNoise) {

        /// A differential drive that is as fast both ways.
        ///
        /// @param maxSpeed [m/s]
        /// @param maxTurnRate [rad/s]
        /// @param maxAcceleration [m/s²], speeding up and slowing down
        /// @param maxTurnAcceleration [rad/s²]
        public Drive(
                double maxSpeed,
                double maxTurnRate,
                double maxAcceleration,
                double maxTurnAcceleration,
                OdometryNoise odometryNoise) {
            this(
                    new Steering.Differential(),
                    Axis.symmetric(maxSpeed, maxAcceleration),
                    Axis.NONE,
                    Axis.symmetric(maxTurnRate, maxTurnAcceleration),
                    odometryNoise);
        }

        /// Fastest speed forward [m/s].
        public double maxSpeed() {
            return forward.speed().most();
        }

        /// Fastest rate at which it turns both ways [rad/s].
        public double maxTurnRate() {
            return turn.speed().reach();
        }

        /// What it manages speeding up as well as slowing down [m/s²].
        public double maxAcceleration() {
            return forward.acceleration().reach();
        }

        /// The same, turning [rad/s²].
        public double maxTurnAcceleration() {
            return turn.acceleration().reach();
        }

        /// Whether it is as fast and as quick to change its speed both ways, on every axis.
        public boolean symmetric() {
            return forward.symmetric() && sideways.symmetric() && turn.symmetric();
        }

        /// Whether it can turn without going anywhere.
        public boolean turnsInPlace() {
            return !(steering instanceof Steering.Car);
        }

        /// What it makes of a velocity that somebody wants, once it is up to speed. What it can't do at all is
        /// left out; a car turns no tighter than its wheels let it. If anything is too fast then, all is cut by
        /// the same factor, which keeps the curvature.
        public Twist2d feasible(Twist2d wanted) {
            double vx = wanted.vx();
            double vy = steering instanceof Steering.Omnidirectional ? wanted.vy() : 0;
            double omega = wanted.omega();
            if (steering instanceof Steering.Car car) {
                omega = Interval.around0(Math.abs(vx) / car.turningRadius()).clamp(omega);
            }
            double part = Math.min(Math.min(forward.part(vx), sideways.part(vy)), Math.min(turn.part(omega), 1));
            return new Twist2d(vx * part + 0.0, vy * part + 0.0, omega * part + 0.0); // + 0.0: no negative zeros
        }
    }

    /// What a drive can do at all.
    public sealed interface Steering {
        /// Forward, and turning, also in place.
        ///
        /// @param wheels empty where the model does not have them
        record Differential(Optional<Wheels> wheels) implements Steering {
            public Differential() {
                this(Optional.empty());
            }
        }

        /// In every direction and turning, all at once.
        record Omnidirectional() implements Steering {}

        /// Forward, turning only on the way: the rear wheels are fixed, the front wheels steer (Ackermann). The
        /// base's origin is in the middle of the rear axle.
        ///
        /// @param wheelbase between the axles [m]
        /// @param maxSteeringAngle of a wheel in the middle of the front axle, to each side [rad]
        record Car(double wheelbase, double maxSteeringAngle) implements Steering {
            /// Of the smallest circle that the base can drive [m].
            public double turningRadius() {
                return wheelbase / Math.tan(maxSteeringAngle);
            }
        }
    }

    /// The two wheels of a differential drive, between which the base's origin is.
    ///
    /// @param radius [m]
    /// @param track from the middle of one to that of the other [m]
    public record Wheels(double radius, double track) {}

    /// What a drive can do in one direction and against it. Signed: the least speed is the fastest one backward,
    /// the least acceleration is what brakes on the way forward and speeds up on the way back.
    ///
    /// @param speed 0 is in it
    /// @param acceleration 0 is in it
    public record Axis(Interval speed, Interval acceleration) {
        /// Nothing.
        public static final Axis NONE = symmetric(0, 0);

        public static Axis symmetric(double maxSpeed, double maxAcceleration) {
            return new Axis(Interval.around0(maxSpeed), Interval.around0(maxAcceleration));
        }

        boolean symmetric() {
            return speed.least() == -speed.most() && acceleration.least() == -acceleration.most();
        }

        /// How much of a speed is possible; more than 1 when it could be faster.
        double part(double wanted) {
            return wanted == 0 ? 1 : (wanted > 0 ? speed.most() : speed.least()) / wanted;
        }
    }

    /// Standard deviations of what odometry gets wrong per step, growing with the square root of the way made, so
    /// that the step's length does not matter.
    ///
    /// @param distancePerMeter error of distance [m/√m]
    /// @param headingPerMeter error of heading from driving [rad/√m]
    /// @param headingPerRadian error of heading from turning [rad/√rad]
    public record OdometryNoise(double distancePerMeter, double headingPerMeter, double headingPerRadian) {}

    /// What is random about measured ranges.
    ///
    /// @param deviation standard deviation of what is added [m]
    /// @param share of the range by which it is off at most besides, evenly spread
    /// @param angle by which each beam is turned at most, either way, evenly spread [rad]
    public record RangeNoise(double deviation, double share, double angle) {
        public static RangeNoise of(double deviation) {
            return new RangeNoise(deviation, 0, 0);
        }

        public RangeNoise times(double factor) {
            return new RangeNoise(factor * deviation, factor * share, factor * angle);
        }
    }

    /// Something a model or a scenario mounts on a robot: a file in `rsal/model/parts`.
    public sealed interface Part {
        String name();

        /// What it becomes on a robot.
        Class<? extends Device> makes();

        /// What a robot has where its robot system has such, and knows best: a localizer, a navigator, a map of its
        /// own, something to draw on.
        record Own(String name, Class<? extends Device> makes) implements Part {}

        /// A device of a kind that is registered ([DeviceKind]).
        ///
        /// @param arguments for the kind's parameters
        /// @param period between readings
        record Registered(String name, DeviceKind kind, Pose2d baseFromDevice, Arguments arguments, Duration period)
                implements Part {
            @Override
            public Class<? extends Device> makes() {
                return kind.makes();
            }
        }

        /// A planar laser scanner, beams from `angleMin` counter-clockwise.
        ///
        /// @param samples beams of a sweep
        record Laser(
                String name,
                Pose2d baseFromLaser,
                double angleMin,
                double angleIncrement,
                int samples,
                double rangeMin,
                double rangeMax,
                RangeNoise noise,
                Duration period)
                implements Part {
            @Override
            public Class<LaserScanner> makes() {
                return LaserScanner.class;
            }
        }

        /// Single-range sensors, each a cone of `fieldOfView` [rad].
        ///
        /// @param noise of ranges; a cone has no beams that could be turned
        record Sonars(
                String name,
                List<Pose2d> baseFromSensors,
                double fieldOfView,
                double rangeMin,
                double rangeMax,
                RangeNoise noise,
                Duration period)
                implements Part {
            public Sonars {
                baseFromSensors = List.copyOf(baseFromSensors);
            }

            @Override
            public Class<SonarArray> makes() {
                return SonarArray.class;
            }
        }

        /// A camera that finds patches of color.
        ///
        /// @param width of its image [px]
        /// @param height of its image [px]
        /// @param fieldOfView from the left edge of the image to its right [rad]
        /// @param rangeMax how far it sees [m]
        /// @param colors that it looks for; every color when there are none
        record BlobFinder(
                String name,
                Pose2d baseFromCamera,
                int width,
                int height,
                double fieldOfView,
                double rangeMax,
                List<Rgb> colors,
                Duration period)
                implements Part {
            public BlobFinder {
                colors = List.copyOf(colors);
            }

            @Override
            public Class<rsal.device.BlobFinder> makes() {
                return rsal.device.BlobFinder.class;
            }
        }

        /// Finds markers.
        ///
        /// @param fieldOfView [rad]
        /// @param rangeMax how far away it sees that there is one [m]
        /// @param idRange how far away it reads the id [m]
        /// @param key it sees only markers of the same key
        /// @param allHeights whether it sees markers that are higher or lower than itself, too
        record FiducialFinder(
                String name,
                Pose2d baseFromFinder,
                double fieldOfView,
                double rangeMax,
                double idRange,
                int key,
                boolean allHeights,
                Duration period)
                implements Part {
            @Override
            public Class<rsal.device.FiducialFinder> makes() {
                return rsal.device.FiducialFinder.class;
            }
        }

        /// Two paddles in front of a body, which close towards its middle.
        ///
        /// @param baseFromGripper middle of body and paddles together, open along its x axis
        /// @param length of body and paddles together [m]
        /// @param width [m]
        /// @param height [m]
        /// @param paddleLength [m]
        /// @param paddleWidth how thick a paddle is [m]
        /// @param closingTime from open to closed
        /// @param liftingTime from down to up; zero when it has no lift
        /// @param closed whether it is at first
        /// @param raised whether its lift is up at first
        /// @param snatches whether it closes by itself when something comes between its open paddles
        record Gripper(
                String name,
                Pose2d baseFromGripper,
                double length,
                double width,
                double height,
                double paddleLength,
                double paddleWidth,
                Duration closingTime,
                Duration liftingTime,
                boolean closed,
                boolean raised,
                boolean snatches,
                Duration period)
                implements Part {
            public boolean hasLift() {
                return !liftingTime.isZero();
            }

            /// Between the open paddles [m].
            public double opening() {
                return width - 2 * paddleWidth;
            }

            @Override
            public Class<rsal.device.Gripper> makes() {
                return rsal.device.Gripper.class;
            }
        }

        /// What feels touches around a robot.
        record Bumper(String name, List<Pad> pads, Duration period) implements Part {
            public Bumper {
                pads = List.copyOf(pads);
            }

            /// A straight piece of it.
            ///
            /// @param baseFromPad its middle, the x axis pointing outwards
            /// @param length along its y axis [m]
            public record Pad(Pose2d baseFromPad, double length) {}

            @Override
            public Class<rsal.device.Bumper> makes() {
                return rsal.device.Bumper.class;
            }
        }

        /// A joint that is moved by a motor; lengths in m when it is linear, angles in rad when it is rotational.
        ///
        /// @param baseFromJoint a linear one moves along its x axis, a rotational one turns around its origin
        /// @param slope of a linear one's way, upwards [rad]: π/2 is that of a lift
        /// @param limits of its position
        /// @param maxSpeed both ways
        /// @param home where it is at first, and at rest
        record Actuator(
                String name,
                Pose2d baseFromJoint,
                Joint joint,
                double slope,
                Interval limits,
                double maxSpeed,
                double home,
                Duration period)
                implements Part {
            /// One that does not move up or down.
            public Actuator(
                    String name,
                    Pose2d baseFromJoint,
                    Joint joint,
                    Interval limits,
                    double maxSpeed,
                    double home,
                    Duration period) {
                this(name, baseFromJoint, joint, 0, limits, maxSpeed, home, period);
            }

            /// How far what stands on it is from where it is while this is at home.
            public Shift shift(double position) {
                if (position == home) {
                    return Shift.NONE;
                }
                double moved = position - home;
                double x = baseFromJoint.x();
                double y = baseFromJoint.y();
                return switch (joint) {
                    case LINEAR -> {
                        double distance = moved * StrictMath.cos(slope);
                        yield new Shift(
                                new Pose2d(
                                        distance * StrictMath.cos(baseFromJoint.theta()),
                                        distance * StrictMath.sin(baseFromJoint.theta()),
                                        0),
                                moved * StrictMath.sin(slope));
                    }
                    case ROTATIONAL -> {
                        double cos = StrictMath.cos(moved);
                        double sin = StrictMath.sin(moved);
                        yield new Shift(new Pose2d(x - cos * x + sin * y, y - sin * x - cos * y, moved), 0);
                    }
                };
            }

            @Override
            public Class<rsal.device.Actuator> makes() {
                return rsal.device.Actuator.class;
            }
        }

        /// A store of energy, and what empties and fills it.
        ///
        /// @param capacity [J]
        /// @param charge what is in it at first [J]
        /// @param idlePower what the robot takes standing still [W]
        /// @param energyPerMeter what it takes besides to drive [J/m]
        /// @param energyPerRadian what it takes besides to turn [J/rad]
        /// @param chargingPower what it can take in at most [W]
        /// @param givingPower what it can give to others at most [W]
        record Battery(
                String name,
                double capacity,
                double charge,
                double idlePower,
                double energyPerMeter,
                double energyPerRadian,
                double chargingPower,
                double givingPower,
                Duration period)
                implements Part {
            @Override
            public Class<rsal.device.Battery> makes() {
                return rsal.device.Battery.class;
            }
        }

        /// A light.
        ///
        /// @param signal what it does at first
        record Light(String name, Pose2d baseFromLight, Rgb color, Signal signal, Duration period) implements Part {
            @Override
            public Class<rsal.device.Light> makes() {
                return rsal.device.Light.class;
            }
        }
    }
}
