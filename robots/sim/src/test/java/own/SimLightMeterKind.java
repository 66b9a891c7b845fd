package own;

import java.time.Instant;
import rsal.data.Point2d;
import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.Part;
import rsal.sim.device.SimulatedKind;
import rsal.sim.device.SimulatedRobot;
import rsal.sim.device.SimulatedSensor;

/// Makes simulated light meters. Each lamp has 1,000 cd and hangs 3 m high; walls cast no shadow.
public final class SimLightMeterKind implements SimulatedKind {
    @Override
    public Class<LightMeter> makes() {
        return LightMeter.class;
    }

    @Override
    public SimulatedSensor<Illuminance> create(DeviceInfo info, Part.Registered part, SimulatedRobot robot) {
        return new SimLightMeter(info, part, robot);
    }

    private static final class SimLightMeter extends SimulatedSensor<Illuminance> implements LightMeter {
        private static final double INTENSITY = 1000; // cd
        private static final double LAMP_HEIGHT = 3; // m

        private final Part.Registered part;
        private final SimulatedRobot robot;

        SimLightMeter(DeviceInfo info, Part.Registered part, SimulatedRobot robot) {
            super(info);
            this.part = part;
            this.robot = robot;
        }

        @Override
        public Illuminance measure(Instant now) {
            double noise = robot.noise() * part.arguments().get(LightMeterKind.NOISE);
            double sum = noise * robot.random().nextGaussian();
            for (Point2d lamp : part.arguments().get(LightMeterKind.LAMP)) {
                double up = LAMP_HEIGHT - robot.height();
                double distance =
                        Math.hypot(up, robot.mapFromDevice().position().distanceTo(lamp));
                sum += INTENSITY * up / (distance * distance * distance); // E = I cos(angle) / r²
            }
            return new Illuminance(Math.max(0, sum));
        }
    }
}
