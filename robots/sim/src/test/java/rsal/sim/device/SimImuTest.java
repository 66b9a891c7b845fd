package rsal.sim.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleFunction;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import rsal.data.Angles;
import rsal.data.Pose2d;
import rsal.device.DeviceInfo;
import rsal.device.imu.ImuKind;
import rsal.device.imu.ImuReading;

class SimImuTest {
    private static final double STEP = 0.01; // s
    private static final int STEPS = 10; // a reading

    private final Map<String, Object> values = new HashMap<>();

    private List<ImuReading> readings(DoubleFunction<Pose2d> mapFromDevice, double noise, int count, long seed) {
        var robot = new ScriptedRobot(mapFromDevice, noise, seed);
        SimulatedSensor<ImuReading> imu = new SimImuKind()
                .create(new DeviceInfo("r1", "imu", "sim"), ScriptedRobot.part(new ImuKind(), values), robot);
        var readings = new ArrayList<ImuReading>();
        imu.step(STEP);
        imu.measure(Instant.EPOCH);
        for (int i = 0; i < count; i++) {
            for (int step = 0; step < STEPS; step++) {
                robot.advance(STEP);
                imu.step(STEP);
            }
            readings.add(imu.measure(Instant.EPOCH));
        }
        return readings;
    }

    private static Pose2d circle(double radius, double omega, double time) {
        double angle = omega * time;
        return new Pose2d(radius * Math.sin(angle), radius * (1 - Math.cos(angle)), Angles.wrap(angle));
    }

    @Test
    void aRobotThatStandsFeelsNothing() {
        assertThat(readings(_ -> new Pose2d(3, 2, 1), 0, 5, 1)).containsOnly(new ImuReading(1, 0, 0, 0));
    }

    /// On a circle the acceleration is ω² r, to its middle.
    @Test
    void feelsTheCircleThatItDrives() {
        for (double omega : new double[] {0.5, -0.5}) {
            double radius = 2 * Math.signum(omega);
            List<ImuReading> readings = readings(t -> circle(radius, omega, t), 0, 100, 1);
            ImuReading last = readings.getLast();
            assertThat(last.angularVelocity()).isCloseTo(omega, within(1e-6));
            assertThat(last.accelerationX()).isCloseTo(0, within(0.01));
            assertThat(last.accelerationY()).isCloseTo(omega * omega * radius, within(0.01));
            assertThat(last.orientation()).isCloseTo(Angles.wrap(10 * omega), within(1e-6));
        }
    }

    @Test
    void feelsSpeedingUpAheadWhereverThatIs() {
        double heading = 2.5;
        List<ImuReading> readings = readings(
                t -> new Pose2d(0.4 * t * t / 2 * Math.cos(heading), 0.4 * t * t / 2 * Math.sin(heading), heading),
                0,
                20,
                1);
        assertThat(readings.getLast().accelerationX()).isCloseTo(0.4, within(1e-6));
        assertThat(readings.getLast().accelerationY()).isCloseTo(0, within(1e-6));
    }

    /// White noise of density σ over Δt deviates by σ / √Δt.
    @Test
    void itsNoiseIsThatOfItsDensity() {
        values.putAll(
                Map.of("gyroscopeNoise", 0.5, "gyroscopeBias", 0, "accelerometerNoise", 0.02, "accelerometerBias", 0));
        List<ImuReading> readings = readings(_ -> Pose2d.ORIGIN, 1, 4000, 7);
        double root = Math.sqrt(STEP * STEPS);
        assertThat(deviation(readings.stream().mapToDouble(ImuReading::angularVelocity)))
                .isCloseTo(Math.toRadians(0.5) / root, within(0.05 * Math.toRadians(0.5) / root));
        assertThat(deviation(readings.stream().mapToDouble(ImuReading::accelerationX)))
                .isCloseTo(0.02 / root, within(0.05 * 0.02 / root));
        assertThat(deviation(readings.stream().mapToDouble(ImuReading::accelerationY)))
                .isCloseTo(0.02 / root, within(0.05 * 0.02 / root));
    }

    private static double deviation(DoubleStream values) {
        double[] all = values.toArray();
        double mean = DoubleStream.of(all).average().orElseThrow();
        return Math.sqrt(DoubleStream.of(all)
                .map(value -> (value - mean) * (value - mean))
                .average()
                .orElseThrow());
    }

    @Test
    void withoutACompassItsOrientationDriftsByItsOffset() {
        values.putAll(Map.of("gyroscopeNoise", 0, "gyroscopeBias", 1));
        List<ImuReading> readings = readings(_ -> new Pose2d(0, 0, 0.5), 1, 100, 3);
        double offset = readings.getFirst().angularVelocity();
        assertThat(Math.abs(offset)).isBetween(1e-4, Math.toRadians(4));
        assertThat(readings.getLast().orientation()).isCloseTo(0.5 + 10 * offset, within(1e-9));
    }

    @Test
    void withACompassItDoesNot() {
        values.putAll(Map.of("gyroscopeBias", 5, "compass", true, "compassNoise", 2));
        List<ImuReading> readings = readings(_ -> new Pose2d(0, 0, 0.5), 1, 2000, 3);
        assertThat(readings.stream().mapToDouble(ImuReading::orientation).average())
                .hasValueCloseTo(0.5, within(0.01));
        assertThat(deviation(readings.stream().mapToDouble(ImuReading::orientation)))
                .isCloseTo(Math.toRadians(2), within(0.003));
    }

    @Test
    void feelsNothingOfBeingPutElsewhere() {
        List<ImuReading> readings = readings(t -> new Pose2d(t < 0.5 ? 0 : 50, 0, t < 0.5 ? 0 : 2), 0, 20, 1);
        assertThat(readings).allMatch(r -> r.accelerationX() == 0 && r.angularVelocity() == 0);
    }
}
