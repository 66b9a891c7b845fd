package rsal.sim.device;

import java.time.Duration;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.DoubleFunction;
import java.util.random.RandomGenerator;
import rsal.data.Pose2d;
import rsal.robot.DeviceKind;
import rsal.robot.RobotModel.Part;
import rsal.settings.Arguments;

/// A robot whose device is where a formula says.
final class ScriptedRobot implements SimulatedRobot {
    private final DoubleFunction<Pose2d> mapFromDevice;
    private final double noise;
    private final RandomGenerator random;
    private double time; // s

    ScriptedRobot(DoubleFunction<Pose2d> mapFromDevice, double noise, long seed) {
        this.mapFromDevice = mapFromDevice;
        this.noise = noise;
        this.random = new SplittableRandom(seed);
    }

    static Part.Registered part(DeviceKind kind, Map<String, ?> values) {
        return new Part.Registered(
                kind.key(), kind, Pose2d.ORIGIN, Arguments.of(kind.parameters(), values), Duration.ofMillis(100));
    }

    void advance(double dt) {
        time += dt;
    }

    double time() {
        return time;
    }

    @Override
    public Pose2d mapFromDevice() {
        return mapFromDevice.apply(time);
    }

    @Override
    public void paint(int columns, int rows, double focalLength, double reach, int[] colors, float[] depths) {}

    @Override
    public double height() {
        return 0.3;
    }

    @Override
    public RandomGenerator random() {
        return random;
    }

    @Override
    public double noise() {
        return noise;
    }
}
