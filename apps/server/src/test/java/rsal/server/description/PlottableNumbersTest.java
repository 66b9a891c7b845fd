package rsal.server.description;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.data.ActuatorState;
import rsal.data.BatteryState;
import rsal.data.Covariance2d;
import rsal.data.Interval;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.engine.report.Answer;
import rsal.engine.report.Reading;
import rsal.server.message.Messages.DeviceNumbers;
import rsal.server.message.Messages.NumberInfo;

class PlottableNumbersTest {
    /// Of a device that nobody here knows.
    public record Weather(Wind wind, double pressure, String words, List<String> clouds) {}

    public record Wind(double speed, int gusts, double angle) {}

    public record Nested(Object inner) {}

    private static List<String> words(Object value) {
        return PlottableNumbers.of(value).stream()
                .map(number -> number.name() + " "
                        + number.value().map(String::valueOf).orElse("none"))
                .toList();
    }

    @Test
    void recordsAreLookedThroughInTheirOrderAndAnglesAreInDegrees() {
        assertThat(words(new Odometry(new Pose2d(1, 2, Math.PI / 2), new Twist2d(0.5, 0, -Math.PI), true)))
                .containsExactly(
                        "odomFromBase.x 1.0",
                        "odomFromBase.y 2.0",
                        "odomFromBase.theta 90.0",
                        "velocity.vx 0.5",
                        "velocity.vy 0.0",
                        "velocity.omega -180.0",
                        "stalled 1.0");
    }

    @Test
    void theyHaveTheNamesAndUnitsThatPeopleUse() {
        assertThat(titles(new Odometry(new Pose2d(1, 2, 3), new Twist2d(0.5, 0, -1), true)))
                .containsExactly(
                        "odometry x [m]",
                        "odometry y [m]",
                        "odometry heading [°]",
                        "speed ahead [m/s]",
                        "speed to the left [m/s]",
                        "turn [°/s]",
                        "stalled []");
        assertThat(titles(new LaserScan(Pose2d.ORIGIN, -1, 0.5, 0.02, 5, new float[] {1})))
                .as("how it is made and mounted stays the same")
                .containsExactly("distance, least [m]", "distance, mean [m]", "distance, greatest [m]");
        assertThat(titles(BatteryState.of(10, 100, -2, BatteryState.Charging.DISCHARGING)))
                .contains("charge [J]", "power [W]", "voltage [V]", "level []");
        assertThat(PlottableNumbers.of(new OccupancyGrid(2, 1, 0.5, 0, 0, new byte[2])))
                .isEmpty();
    }

    /// A square of degrees is nobody's unit, and would have to be computed.
    @Test
    void variancesStayInRadians() {
        var covariance = new Covariance2d(1, 0, 0.5, 1, 0.5, 2);
        assertThat(PlottableNumbers.of(covariance))
                .contains(
                        new NumberInfo("xTheta", "covariance of x and heading", "m·rad", Optional.of(0.5)),
                        new NumberInfo("thetaTheta", "variance of the heading", "rad²", Optional.of(2.0)));
    }

    @Test
    void whatTurnsIsAnAngleAndWhatSlidesALength() {
        var limits = new Interval(0, Math.PI);
        assertThat(titles(
                        new ActuatorState(ActuatorState.Joint.ROTATIONAL, 1, 0.5, limits, ActuatorState.Motion.MOVING)))
                .containsExactly("position [°]", "speed [°/s]");
        assertThat(titles(new ActuatorState(ActuatorState.Joint.LINEAR, 1, 0.5, limits, ActuatorState.Motion.MOVING)))
                .containsExactly("position [m]", "speed [m/s]");
    }

    private static List<String> titles(Object value) {
        return PlottableNumbers.of(value).stream()
                .map(number -> "%s [%s]".formatted(number.title(), number.unit()))
                .toList();
    }

    @Test
    void whatNobodyKnowsIsReportedAsWell() {
        var weather = new Weather(new Wind(3.5, 7, Math.PI), Double.NaN, "fair", List.of("cirrus", "cumulus"));
        assertThat(words(weather))
                .containsExactly(
                        "wind.speed 3.5", "wind.gusts 7.0", "wind.angle 180.0", "pressure none", "clouds.count 2.0");
    }

    @Test
    void ofManyTheLeastTheMeanAndTheGreatestOfThoseThatAreFinite() {
        float[] ranges = {1, Float.POSITIVE_INFINITY, 3, Float.NaN};
        assertThat(words(new LaserScan(Pose2d.ORIGIN, -1, 0.5, 0.02, 5, ranges)))
                .containsExactly("ranges.least 1.0", "ranges.mean 2.0", "ranges.greatest 3.0");
        assertThat(words(new LaserScan(Pose2d.ORIGIN, -1, 0.5, 0.02, 5, new float[] {Float.NaN})))
                .contains("ranges.least none", "ranges.mean none");
    }

    @Test
    void whatIsDeepOrMuchIsBounded() {
        Object deep = 1.0;
        for (int i = 0; i < 100; i++) {
            deep = new Nested(deep);
        }
        assertThat(PlottableNumbers.of(deep)).isEmpty();
        assertThat(PlottableNumbers.of("words")).isEmpty();
    }

    @Test
    void devicesWithoutANumberAreLeftOut() {
        assertThat(PlottableNumbers.of(new Answer.Read(
                                Duration.ofMillis(1500), List.of(reading("speech", "hello"), reading("scale", 3))))
                        .devices())
                .containsExactly(new DeviceNumbers("scale", List.of(new NumberInfo("", "", "", Optional.of(3.0)))));
    }

    private static Reading reading(String device, Object value) {
        return new Reading(device, new Stamped<>(Instant.EPOCH, "r1/" + device, value), Duration.ZERO);
    }
}
