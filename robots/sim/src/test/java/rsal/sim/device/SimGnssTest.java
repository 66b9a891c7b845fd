package rsal.sim.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.DeviceInfo;
import rsal.device.gnss.GnssFix;
import rsal.device.gnss.GnssKind;

class SimGnssTest {
    private static List<GnssFix> fixes(Map<String, ?> values, double noise, int count, long seed) {
        var robot = new ScriptedRobot(_ -> new Pose2d(30, -20, 1), noise, seed);
        SimulatedSensor<GnssFix> gnss = new SimGnssKind()
                .create(new DeviceInfo("r1", "gnss", "sim"), ScriptedRobot.part(new GnssKind(), values), robot);
        var fixes = new ArrayList<GnssFix>();
        for (int i = 0; i < count; i++) {
            fixes.add(gnss.measure(Instant.EPOCH.plusSeconds(i)));
        }
        return fixes;
    }

    @Test
    void withoutErrorsItIsWhereTheDeviceIs() {
        assertThat(fixes(Map.of(), 0, 3, 1)).allSatisfy(fix -> {
            assertThat(fix.position()).isEqualTo(new Point2d(30, -20));
            assertThat(fix.deviation()).isZero();
        });
    }

    /// A degree of latitude is 110,574 m long at the equator and 111,694 m at a pole, a degree of longitude
    /// 111,320 m at the equator (WGS 84).
    @Test
    void degreesAreAsLongAsOnEarth() {
        assertThat(GnssFix.of(new Point2d(0, 110_574.3), 0, 0, 1).latitude()).isCloseTo(1, within(1e-4));
        assertThat(GnssFix.of(new Point2d(0, 111_693.9), 89.999, 0, 1).latitude())
                .isCloseTo(90.999, within(1e-4));
        assertThat(GnssFix.of(new Point2d(111_319.5, 0), 0, 7, 1).longitude()).isCloseTo(8, within(1e-4));
        assertThat(GnssFix.of(new Point2d(-1000, 0), 60, 0, 1).longitude()).isCloseTo(-0.017_92, within(1e-4));
    }

    /// The error stays by e^(-Δt/τ), and deviates by σ.
    @Test
    void itsErrorChangesSlowly() {
        double deviation = 2;
        List<GnssFix> fixes = fixes(Map.of("deviation", deviation, "correlationTime", 5, "noise", 0), 1, 20_000, 2);
        double[] errors = fixes.stream().mapToDouble(fix -> fix.x() - 30).toArray();
        assertThat(correlation(errors, 0)).isCloseTo(deviation * deviation, within(0.5));
        assertThat(correlation(errors, 1) / correlation(errors, 0)).isCloseTo(Math.exp(-0.2), within(0.02));
        assertThat(correlation(errors, 5) / correlation(errors, 0)).isCloseTo(Math.exp(-1), within(0.05));
    }

    private static double correlation(double[] values, int lag) {
        return IntStream.range(0, values.length - lag)
                .mapToDouble(i -> values[i] * values[i + lag])
                .average()
                .orElseThrow();
    }

    @Test
    void itsNoiseIsNewInEachFix() {
        List<GnssFix> fixes = fixes(Map.of("deviation", 0, "noise", 0.5), 1, 4000, 2);
        double[] errors = fixes.stream().mapToDouble(fix -> fix.y() + 20).toArray();
        assertThat(Math.sqrt(correlation(errors, 0))).isCloseTo(0.5, within(0.03));
        assertThat(correlation(errors, 1)).isCloseTo(0, within(0.02));
        assertThat(fixes.getFirst().deviation()).isEqualTo(0.5);
    }

    @Test
    void anErrorMovesItInTheMapAndOnEarth() {
        GnssFix right = GnssFix.of(new Point2d(10, 5), 53.6, 9.9, 1);
        GnssFix wrong = right.withError(3, -2, 0.5);
        GnssFix there = GnssFix.of(new Point2d(13, 3), 53.6, 9.9, 1);
        assertThat(wrong.position()).isEqualTo(there.position());
        assertThat(wrong.latitude()).isCloseTo(there.latitude(), within(1e-9));
        assertThat(wrong.longitude()).isCloseTo(there.longitude(), within(1e-9));
    }
}
