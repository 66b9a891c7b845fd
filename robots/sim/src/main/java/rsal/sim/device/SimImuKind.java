package rsal.sim.device;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import rsal.data.Angles;
import rsal.data.Pose2d;
import rsal.device.DeviceInfo;
import rsal.device.imu.Imu;
import rsal.device.imu.ImuKind;
import rsal.device.imu.ImuReading;
import rsal.robot.RobotModel.Part;
import rsal.settings.Arguments;

/// Makes simulated IMUs. What they measure follows from how the device itself moved, so also where it sits off
/// the robot's center.
public final class SimImuKind implements SimulatedKind {
    @Override
    public Class<Imu> makes() {
        return Imu.class;
    }

    @Override
    public SimulatedSensor<ImuReading> create(DeviceInfo info, Part.Registered part, SimulatedRobot robot) {
        return new SimImu(info, part.arguments(), robot);
    }

    private static final class SimImu extends SimulatedSensor<ImuReading> implements Imu {
        private static final double CARRIED = 100; // m/s; faster ones are put elsewhere

        private final SimulatedRobot robot;
        private final boolean hasCompass;
        private final double compassNoise; // rad
        private final double gyroscopeNoise; // rad/s/√Hz
        private final double accelerometerNoise; // m/s²/√Hz
        private final double gyroscopeBias; // rad/s
        private final double biasX; // m/s²
        private final double biasY; // m/s²
        private @Nullable Pose2d pose; // of the device in the map, after the last step
        private double vx; // m/s, in the map, in the last step
        private double vy;
        private double orientation; // integrated [rad]
        private double time; // since the last reading [s]
        private double turned; // since then [rad]
        private double gainedX; // speed since then, in the device's frame [m/s]
        private double gainedY;

        SimImu(DeviceInfo info, Arguments arguments, SimulatedRobot robot) {
            super(info);
            this.robot = robot;
            this.hasCompass = arguments.get(ImuKind.COMPASS);
            this.compassNoise = robot.noise() * arguments.radians(ImuKind.COMPASS_NOISE);
            this.gyroscopeNoise = robot.noise() * arguments.radians(ImuKind.GYROSCOPE_NOISE);
            this.accelerometerNoise = robot.noise() * arguments.get(ImuKind.ACCELEROMETER_NOISE);
            this.gyroscopeBias = robot.noise() * drawn(arguments.radians(ImuKind.GYROSCOPE_BIAS));
            double bias = arguments.get(ImuKind.ACCELEROMETER_BIAS);
            this.biasX = robot.noise() * drawn(bias);
            this.biasY = robot.noise() * drawn(bias);
        }

        private double drawn(double deviation) {
            return deviation * robot.random().nextGaussian();
        }

        @Override
        public void step(double dt) {
            Pose2d now = robot.mapFromDevice();
            Pose2d last = pose;
            pose = now;
            if (last == null) {
                orientation = now.theta();
                return;
            }
            time += dt;
            if (now.distanceTo(last) > CARRIED * dt) {
                return;
            }
            turned += Angles.difference(last.theta(), now.theta());
            double nextX = (now.x() - last.x()) / dt;
            double nextY = (now.y() - last.y()) / dt;
            double cos = Math.cos(now.theta());
            double sin = Math.sin(now.theta());
            gainedX += cos * (nextX - vx) + sin * (nextY - vy);
            gainedY += cos * (nextY - vy) - sin * (nextX - vx);
            vx = nextX;
            vy = nextY;
        }

        @Override
        public ImuReading measure(Instant now) {
            if (time == 0) {
                return new ImuReading(orientation(), gyroscopeBias, biasX, biasY);
            }
            double root = Math.sqrt(time);
            double angularVelocity = turned / time + gyroscopeBias + drawn(gyroscopeNoise) / root;
            orientation = Angles.wrap(orientation + angularVelocity * time);
            var reading = new ImuReading(
                    orientation(),
                    angularVelocity,
                    gainedX / time + biasX + drawn(accelerometerNoise) / root,
                    gainedY / time + biasY + drawn(accelerometerNoise) / root);
            time = 0;
            turned = 0;
            gainedX = 0;
            gainedY = 0;
            return reading;
        }

        private double orientation() {
            return hasCompass ? Angles.wrap(robot.mapFromDevice().theta() + drawn(compassNoise)) : orientation;
        }
    }
}
