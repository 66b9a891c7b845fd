package rsal.engine.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.LaserScan;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.device.Mapper;
import rsal.device.RangeSensor;
import rsal.device.SensorCore;
import rsal.device.SimulationControl.Thing;
import rsal.device.SonarArray;
import rsal.engine.event.EventLog;
import rsal.engine.report.RunEvent;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.testkit.DrawnMap;
import rsal.testkit.fake.FakeSystem;
import rsal.time.LockstepScheduler;

class OverlayTest {
    private static final DrawnMap HALL = DrawnMap.grid(1, """
            ####################
            #..................#
            #..................#
            #..................#
            #..................#
            #..................#
            ####################""");
    private static final Pose2d SIMULATED = new Pose2d(15, 3.5, 0);
    private static final Pose2d HERE = new Pose2d(5, 3.5, 0);
    private static final float NOTHING = Float.POSITIVE_INFINITY;

    private final LockstepScheduler time = new LockstepScheduler(Instant.EPOCH, Runnable::run);
    private final EventLog eventLog = new EventLog(() -> Duration.between(Instant.EPOCH, time.instant()), () -> {});
    private final FakeSystem world = FakeSystem.pioneers(time, HALL, SIMULATED);
    private final Beam laser = new Beam();
    private final Ring sonars = new Ring();
    private @Nullable Stamped<Pose2d> believed;
    private Robot real;
    private Robot overlaid;

    /// Looks ahead and to the left.
    private static final class Beam extends SensorCore<LaserScan> implements LaserScanner {
        Beam() {
            super(new DeviceInfo("real", "laser", "test"));
        }

        void show(Instant now, float ahead, float left) {
            var scan = new LaserScan(new Pose2d(0.1, 0, 0), 0, Math.PI / 2, 0.5, 8, new float[] {ahead, left});
            deliver(new Stamped<>(now, "real/laser", scan));
        }

        void blink(Instant now) {
            deliver(new Stamped<>(
                    now, "real/laser", new LaserScan(new Pose2d(0.1, 0, 0), 0, Math.PI / 2, 0.5, 8, new float[0])));
        }

        void fail() {
            health(new Health.Lost("It fell off."));
        }
    }

    /// Two sonars side by side that look ahead.
    private static final class Ring extends SensorCore<RangeArray> implements SonarArray {
        Ring() {
            super(new DeviceInfo("real", "sonar", "test"));
        }

        void show(Instant now, float left, float right) {
            var places = List.of(new Pose2d(0, 1, 0), new Pose2d(0, -1, 0));
            var round = new RangeArray(places, Math.toRadians(30), 0.2, 5, new float[] {left, right});
            deliver(new Stamped<>(now, "real/base_link", round));
        }
    }

    @BeforeEach
    void begin() {
        Robot like = world.robots().getFirst();
        real = new Robot("real", "rover", like.model(), List.of(laser, sonars));
        var spec = new RobotSpec("real", "rover", like.model(), Optional.of(HERE), "#808080");
        var overlay = new Overlay(
                spec, () -> Optional.ofNullable(believed), world::simulation, () -> Set.of("stand-in"), eventLog);
        overlaid = overlay.over(real);
        believe(HERE);
    }

    private void believe(Pose2d mapFromBase) {
        believed = new Stamped<>(time.instant(), "map", mapFromBase);
    }

    private void put(String name, double x, double y) {
        put(name, x, y, 0.5);
    }

    private void put(String name, double x, double y, double height) {
        world.simulation()
                .orElseThrow()
                .addAnyway(Thing.of(
                        name,
                        new Pose2d(x, y, 0),
                        Solid.standing(new Shape.Disc(new Point2d(0, 0), 0.2), height),
                        new Rgb(0, 0, 0)));
    }

    private float[] seen(float ahead, float left) {
        laser.show(time.instant(), ahead, left);
        return overlaid.require(LaserScanner.class)
                .latest()
                .orElseThrow()
                .value()
                .ranges();
    }

    @Test
    void aScanWithoutBeamsIsNotItsLast() {
        laser.blink(time.instant());
        put("box", 7.3, 3.5);
        assertThat(seen(NOTHING, NOTHING)[0]).isCloseTo(2.0f, within(0.01f));
    }

    private float[] heard(float left, float right) {
        sonars.show(time.instant(), left, right);
        return overlaid.require(SonarArray.class).latest().orElseThrow().value().ranges();
    }

    private List<String> reported() {
        return eventLog.after(0).stream().map(RunEvent::toString).toList();
    }

    @Test
    void seesNoWallsOfTheSimulatedWorld() {
        assertThat(seen(NOTHING, 4)).containsExactly(NOTHING, 4);
        assertThat(heard(NOTHING, 4)).containsExactly(NOTHING, 4);
    }

    @Test
    void seesRobotsAndThingsFromWhereItBelievesToBe() {
        put("box", 8, 3.5);
        assertThat(seen(NOTHING, NOTHING)[0]).isCloseTo(2.7f, within(0.01f));
        assertThat(seen(NOTHING, NOTHING)[1]).isEqualTo(NOTHING);
        believe(new Pose2d(8.5, 1.5, 0));
        assertThat(seen(NOTHING, NOTHING)[1]).isEqualTo(NOTHING);
        believe(new Pose2d(7.9, 1.5, 0));
        assertThat(seen(NOTHING, NOTHING)[1]).isCloseTo(1.8f, within(0.01f));
        believe(new Pose2d(10, 3.5, 0));
        assertThat(seen(NOTHING, NOTHING)[0]).as("the robot").isBetween(4.6f, 4.8f);
    }

    @Test
    void whatStandsForWhatIsRealIsNotSeen() {
        put("stand-in", 5, 3.5);
        assertThat(seen(NOTHING, NOTHING)).containsExactly(NOTHING, NOTHING);
        assertThat(heard(NOTHING, NOTHING)).containsExactly(NOTHING, NOTHING);
    }

    @Test
    void looksOverWhatIsLower() {
        put("can", 8, 3.5, 0.1);
        assertThat(seen(NOTHING, NOTHING)).containsExactly(NOTHING, NOTHING);
    }

    @Test
    void aSonarHearsWhatIsNearestInItsCone() {
        put("beside", 8, 5.2);
        assertThat(heard(NOTHING, NOTHING)[0]).as("not on its axis").isBetween(2.9f, 3.1f);
        assertThat(heard(NOTHING, NOTHING)[1]).isEqualTo(NOTHING);
        assertThat(heard(2, 2)).containsExactly(2, 2);
        put("nearer", 7, 4.5);
        assertThat(heard(NOTHING, NOTHING)[0]).isBetween(1.79f, 1.82f);
    }

    @ParameterizedTest
    @CsvSource({
        "3, 2, 2",
        "2, 3, 2",
        "Infinity, 2, 2",
        "NaN, 2, NaN",
        "-Infinity, 2, -Infinity",
        "3, 0.4, -Infinity",
        "3, 0.5, 0.5",
        "Infinity, 8, 8",
        "Infinity, 8.1, Infinity",
        "Infinity, Infinity, Infinity"
    })
    void theNearestCounts(float real, double simulated, float shown) {
        assertThat(Overlay.nearer(real, simulated, 0.5, 8)).isEqualTo(Float.valueOf(shown));
    }

    @Test
    void seesWhatIsRealAloneAfterASecondWithoutAPoseAndSaysSoOnce() {
        put("box", 8, 3.5);
        time.advance(Duration.ofSeconds(1));
        assertThat(seen(NOTHING, 4)[0]).isLessThan(3);
        time.advance(Duration.ofMillis(100));
        assertThat(seen(NOTHING, 4)).containsExactly(NOTHING, 4);
        assertThat(heard(NOTHING, 4)).containsExactly(NOTHING, 4);
        assertThat(reported())
                .singleElement()
                .asString()
                .contains("real")
                .contains("sees nothing that is simulated: for more than 1 s nobody has told where it is");
        believe(HERE);
        assertThat(seen(NOTHING, 4)[0]).isLessThan(3);
        assertThat(reported()).hasSize(2).last().asString().contains("sees what is simulated again");
    }

    @Test
    void seesWhatIsRealAloneWhereNobodyCanBe() {
        put("box", 8, 3.5);
        believe(new Pose2d(Double.NaN, 3.5, 0));
        assertThat(seen(NOTHING, 4)).containsExactly(NOTHING, 4);
        assertThat(heard(NOTHING, 4)).containsExactly(NOTHING, 4);
    }

    @Test
    void whoNeverKnewWhereItIsSaysSoAfterASecond() {
        put("box", 8, 3.5);
        believed = null;
        assertThat(seen(NOTHING, 4)).containsExactly(NOTHING, 4);
        time.advance(Duration.ofSeconds(1));
        assertThat(seen(NOTHING, 4)).containsExactly(NOTHING, 4);
        assertThat(reported()).isEmpty();
        time.advance(Duration.ofMillis(100));
        assertThat(seen(NOTHING, 4)).containsExactly(NOTHING, 4);
        assertThat(reported()).hasSize(1);
    }

    @Test
    void isAsWellAsTheSensorInWhosePlaceItStands() {
        LaserScanner shown = overlaid.require(LaserScanner.class);
        assertThat(shown.info()).isEqualTo(laser.info());
        laser.fail();
        assertThat(shown.health()).isEqualTo(new Health.Lost("It fell off."));
        assertThat(seen(1, 1)).containsExactly(1, 1);
        assertThat(shown.health()).isEqualTo(Health.ok());
    }

    @Test
    void whoMatchesScansWithTheMapSeesWhatIsRealAlone() {
        var matching = ServiceLoader.load(DeviceDriver.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(driver -> driver.needs().stream().anyMatch(RangeSensor.class::isAssignableFrom))
                .filter(driver -> Overlay.asSeenBy(driver, overlaid).equals(real))
                .toList();
        assertThat(matching)
                .extracting(DeviceDriver::key)
                .contains("amcl", "slam")
                .doesNotContain("navigator", "pilot");
        assertThat(matching).extracting(DeviceDriver::makes).containsOnly(Localizer.class, Mapper.class);
    }
}
