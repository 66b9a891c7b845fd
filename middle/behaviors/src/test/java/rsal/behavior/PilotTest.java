package rsal.behavior;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.Health;
import rsal.device.LaserScanner;
import rsal.device.SensorCore;
import rsal.device.SonarArray;
import rsal.model.RobotModels;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.settings.FileSource;
import rsal.settings.Location;

/// When a pilot drives, when it stands, and what it says of itself.
class PilotTest {
    private static final Twist2d AHEAD = Twist2d.drive(0.3, 0.1);
    private static final RobotModel PIONEER =
            new RobotModels(FileSource.disk()).read("pioneer2dx", Location.of("here"));

    private Instant now = Instant.EPOCH;
    private final Base base = new Base();
    private final Scanner laser = new Scanner();
    private final Sonars sonars = new Sonars();
    private final List<Decision> decisions = new ArrayList<>();
    private Pilot pilot = pilot(base, laser, sonars);

    private static final class Base extends SensorCore<Odometry> implements DriveBase {
        private final List<Twist2d> commands = new ArrayList<>();
        private boolean enabled = true;

        Base() {
            super(new DeviceInfo("r", "base", "test"));
        }

        @Override
        public void command(Twist2d velocity) {
            commands.add(velocity);
        }

        @Override
        public void enable(boolean on) {
            enabled = on;
        }

        @Override
        public boolean enabled() {
            return enabled;
        }

        @Override
        public void resetOdometry(Pose2d odomFromBase) {}

        void show(Instant now) {
            deliver(new Stamped<>(now, "odom", new Odometry(Pose2d.ORIGIN, Twist2d.STOP, false)));
        }
    }

    private static final class Scanner extends SensorCore<LaserScan> implements LaserScanner {
        Scanner() {
            super(new DeviceInfo("r", "laser", "test"));
        }

        void show(Instant now, float range) {
            float[] ranges = new float[181];
            Arrays.fill(ranges, range);
            deliver(new Stamped<>(
                    now, "r/laser", new LaserScan(Pose2d.ORIGIN, -Math.PI / 2, Math.PI / 180, 0.05, 8, ranges)));
        }
    }

    private static final class Sonars extends SensorCore<RangeArray> implements SonarArray {
        Sonars() {
            super(new DeviceInfo("r", "sonar", "test"));
        }

        void show(Instant now) {
            deliver(new Stamped<>(
                    now, "r/sonar", new RangeArray(List.of(Pose2d.ORIGIN), 0.5, 0.1, 5, new float[] {5})));
        }
    }

    private static Robot robot(Device... devices) {
        return new Robot("r", "robot", PIONEER, OptionalInt.empty(), List.of(devices));
    }

    private Pilot pilot(Device... devices) {
        return new Pilot(new DeviceInfo("r", "pilot", "test"), robot(devices), new SectorFusion(5), () -> now);
    }

    /// One update, a tenth of a second later, with fresh readings of all.
    private void update() {
        now = now.plus(Pilot.PERIOD);
        base.show(now);
        laser.show(now, 5);
        sonars.show(now);
        pilot.update();
    }

    private static Subsumption wants(Twist2d twist) {
        return new Subsumption().layer("go", new SetSpeed(twist));
    }

    @BeforeEach
    void subscribe() {
        pilot.subscribe(decision -> decisions.add(decision.value()));
    }

    @Test
    void drivesAsItsStackWants() {
        pilot.engage(wants(AHEAD));
        assertThat(pilot.engaged()).isTrue();
        update();
        assertThat(base.commands).containsExactly(AHEAD);
        assertThat(decisions).extracting(Decision::twist).containsExactly(AHEAD);
        assertThat(pilot.latest().orElseThrow().time()).isEqualTo(now);
        assertThat(pilot.latest().orElseThrow().frame()).isEqualTo("r/base_link");
    }

    @Test
    void withoutAStackItCommandsNothing() {
        update();
        assertThat(pilot.engaged()).isFalse();
        pilot.release();
        assertThat(base.commands).isEmpty();
        assertThat(decisions).isEmpty();
    }

    @Test
    void releasedItStopsOnce() {
        pilot.engage(wants(AHEAD));
        update();
        pilot.release();
        assertThat(base.commands).containsExactly(AHEAD, Twist2d.STOP);
        assertThat(pilot.engaged()).isFalse();
        update();
        assertThat(base.commands).hasSize(2);
    }

    @Test
    void pausedItStandsAndKeepsItsStack() {
        pilot.engage(wants(AHEAD));
        update();
        pilot.pause();
        pilot.pause();
        assertThat(pilot.paused()).isTrue();
        assertThat(base.commands).containsExactly(AHEAD, Twist2d.STOP);
        update();
        assertThat(base.commands).hasSize(2);
        pilot.resume();
        assertThat(pilot.paused()).isFalse();
        update();
        assertThat(base.commands).endsWith(AHEAD);
    }

    @Test
    void pausedWithoutAStackItLeavesTheBaseAlone() {
        pilot.pause();
        assertThat(base.commands).isEmpty();
    }

    @Test
    void asksNobodyWhileMotorsAreOff() {
        pilot.engage(new Subsumption().layer("never", (_, _) -> {
            throw new IllegalStateException("asked");
        }));
        base.enable(false);
        update();
        assertThat(base.commands).isEmpty();
        assertThat(pilot.health().isOk()).isTrue();
    }

    /// Half a second is still fresh, more is not; of any of the three.
    @Test
    void standsWhileASensorIsSilent() {
        for (SensorCore<?> silent : List.of(base, laser, sonars)) {
            pilot.engage(wants(AHEAD));
            update();
            for (int tenths = 1; tenths <= 6; tenths++) {
                base.commands.clear();
                now = now.plus(Pilot.PERIOD);
                if (!silent.equals(base)) {
                    base.show(now);
                }
                if (!silent.equals(laser)) {
                    laser.show(now, 5);
                }
                if (!silent.equals(sonars)) {
                    sonars.show(now);
                }
                pilot.update();
                assertThat(base.commands)
                        .as("%s, %d", silent.info().id(), tenths)
                        .containsExactly(tenths <= 5 ? AHEAD : Twist2d.STOP);
            }
            assertThat(pilot.health())
                    .isEqualTo(new Health.Stale(
                            "No reading of '%s'.".formatted(silent.info().id())));
            pilot.release();
            update();
            assertThat(pilot.health().isOk()).as("back again").isTrue();
        }
    }

    @Test
    void standsUntilThereAreReadings() {
        pilot.engage(wants(AHEAD));
        pilot.update();
        assertThat(base.commands).containsExactly(Twist2d.STOP);
    }

    @Test
    void needsNoRangeSensors() {
        pilot = pilot(base);
        pilot.engage(wants(AHEAD));
        update();
        assertThat(base.commands).containsExactly(AHEAD);
    }

    @Test
    void standsForGoodWhenABehaviorFails() {
        pilot.engage(new Subsumption().layer("odd", (_, _) -> {
            throw new IllegalStateException("odd");
        }));
        update();
        assertThat(base.commands).containsExactly(Twist2d.STOP);
        assertThat(pilot.engaged()).isFalse();
        assertThat(pilot.health())
                .isInstanceOfSatisfying(
                        Health.Lost.class, lost -> assertThat(lost.reason()).contains("odd"));
        update();
        assertThat(pilot.health()).isInstanceOf(Health.Lost.class);
        pilot.engage(wants(AHEAD));
        assertThat(pilot.health().isOk()).isTrue();
    }

    @Test
    void doesNotCommandWhatIsNotFinite() {
        pilot.engage(wants(Twist2d.drive(Double.NaN, 0)));
        update();
        assertThat(base.commands).containsExactly(Twist2d.STOP);
        assertThat(pilot.health()).isInstanceOf(Health.Lost.class);
    }

    /// What it decided counts no more then.
    @Test
    void aBehaviorMayReleaseOrPauseIt() {
        pilot.engage(new Subsumption().layer("enough", (_, _) -> {
            pilot.release();
            return AHEAD;
        }));
        update();
        assertThat(base.commands).containsExactly(Twist2d.STOP);
        pilot.engage(new Subsumption().layer("wait", (_, _) -> {
            pilot.pause();
            return AHEAD;
        }));
        update();
        assertThat(base.commands).containsExactly(Twist2d.STOP, Twist2d.STOP);
        assertThat(decisions).isEmpty();
    }

    /// So that the next stack knows what is beside the tail.
    @Test
    void looksAroundWithoutAStack() {
        now = now.plus(Pilot.PERIOD);
        base.show(now);
        sonars.show(now);
        laser.show(now, 1);
        pilot.update();
        var seen = new ArrayList<Double>();
        pilot.engage(new Subsumption().layer("look", (percept, below) -> {
            seen.add(percept.surroundings().nearest(-1, 1));
            return below;
        }));
        now = now.plus(Pilot.PERIOD);
        base.show(now);
        sonars.show(now);
        laser.show(now, Float.NaN); // it sees nothing now
        pilot.update();
        assertThat(seen.getFirst()).isCloseTo(1, within(0.01));
    }

    @Test
    void itsDriverSaysWhatItNeeds() {
        var driver = new PilotDriver();
        assertThat(driver.key()).isEqualTo("pilot");
        assertThat(driver.description()).startsWith("Drives the robot by layers");
        assertThat(driver.makes()).isEqualTo(Pilot.class);
        assertThat(driver.needs()).containsExactly(DriveBase.class);
        assertThat(driver.parameters()).singleElement().extracting("name").isEqualTo("maxRange");
        assertThat(driver.refusal(PIONEER)).isEmpty();
        RobotModel car = PIONEER.with(new RobotModel.Drive(
                new RobotModel.Steering.Car(0.5, 0.5),
                PIONEER.drive().forward(),
                PIONEER.drive().sideways(),
                PIONEER.drive().turn(),
                PIONEER.drive().odometryNoise()));
        assertThat(driver.refusal(car))
                .hasValueSatisfying(why -> assertThat(why).contains("car 'pioneer2dx'"));
    }
}
