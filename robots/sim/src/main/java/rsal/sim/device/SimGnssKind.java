package rsal.sim.device;

import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;
import rsal.data.Point2d;
import rsal.device.DeviceInfo;
import rsal.device.gnss.Gnss;
import rsal.device.gnss.GnssFix;
import rsal.device.gnss.GnssKind;
import rsal.robot.RobotModel.Part;
import rsal.settings.Arguments;

/// Makes simulated receivers of satellite navigation. They see the sky everywhere, indoors too.
public final class SimGnssKind implements SimulatedKind {
    @Override
    public Class<Gnss> makes() {
        return Gnss.class;
    }

    @Override
    public SimulatedSensor<GnssFix> create(DeviceInfo info, Part.Registered part, SimulatedRobot robot) {
        return new SimGnss(info, part.arguments(), robot);
    }

    private static final class SimGnss extends SimulatedSensor<GnssFix> implements Gnss {
        private final SimulatedRobot robot;
        private final double deviation; // m
        private final double correlationTime; // s
        private final double noise; // m
        private final double latitude; // deg
        private final double longitude; // deg
        private double errorX; // that changes slowly [m]
        private double errorY;
        private @Nullable Instant last; // reading

        SimGnss(DeviceInfo info, Arguments arguments, SimulatedRobot robot) {
            super(info, "map");
            this.robot = robot;
            this.deviation = robot.noise() * arguments.get(GnssKind.DEVIATION);
            this.correlationTime = arguments.get(GnssKind.CORRELATION_TIME);
            this.noise = robot.noise() * arguments.get(GnssKind.NOISE);
            this.latitude = arguments.get(GnssKind.LATITUDE);
            this.longitude = arguments.get(GnssKind.LONGITUDE);
        }

        @Override
        public GnssFix measure(Instant now) {
            double kept = last == null ? 0 : Math.exp(-seconds(last, now) / correlationTime);
            last = now;
            double fresh = deviation * Math.sqrt(1 - kept * kept);
            errorX = kept * errorX + drawn(fresh);
            errorY = kept * errorY + drawn(fresh);
            Point2d place = robot.mapFromDevice().position();
            var measured = new Point2d(place.x() + errorX + drawn(noise), place.y() + errorY + drawn(noise));
            return GnssFix.of(measured, latitude, longitude, Math.hypot(deviation, noise));
        }

        private double drawn(double deviation) {
            return deviation * robot.random().nextGaussian();
        }

        private static double seconds(Instant from, Instant to) {
            return Duration.between(from, to).toNanos() * 1e-9;
        }
    }
}
