package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static rsal.sim.SimRun.robot;
import static rsal.sim.SimRun.room;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.data.Perturbable;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.device.Health;
import rsal.device.Sensor;
import rsal.fault.Fault;
import rsal.fault.FaultInjection;
import rsal.robot.DeviceKind;
import rsal.robot.DeviceKinds;
import rsal.robot.RobotModel.Part;
import rsal.settings.Arguments;

/// What each registered kind of devices owes in the simulator.
class RegisteredDevicesTest {
    static Stream<DeviceKind> kinds() {
        return DeviceKinds.all().stream();
    }

    private static SimRun with(DeviceKind kind) {
        var part = new Part.Registered(
                "it", kind, new Pose2d(0.1, 0, 0), Arguments.defaults(kind.parameters()), Duration.ofMillis(200));
        return SimRun.of(room(8, 4), robot("r1", Models.box(Models.DRIVE, part), new Pose2d(2, 2, 0)));
    }

    private static Sensor<?> device(SimRun run, DeviceKind kind) {
        return (Sensor<?>) run.robot("r1").require(kind.makes().asSubclass(Device.class));
    }

    private static List<Stamped<?>> readings(SimRun run, DeviceKind kind, double seconds) {
        var readings = new ArrayList<Stamped<?>>();
        device(run, kind).subscribe(readings::add);
        run.base("r1").command(Twist2d.drive(0.3, 0.4));
        run.advance(seconds);
        return readings;
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void readsOnceAPeriodInAFrame(DeviceKind kind) {
        SimRun run = with(kind);
        List<Stamped<?>> readings = readings(run, kind, 2);
        assertThat(readings).hasSizeBetween(10, 11);
        assertThat(readings).allSatisfy(reading -> {
            assertThat(reading.value()).isInstanceOf(kind.reads());
            assertThat(reading.frame()).matches("map|r1/.*");
        });
        for (int i = 1; i < readings.size(); i++) {
            Instant before = readings.get(i - 1).time();
            assertThat(readings.get(i).time()).isEqualTo(before.plusMillis(200));
        }
        assertThat((Object) device(run, kind).latest().orElseThrow()).isEqualTo(readings.getLast());
        assertThat(device(run, kind).health().isOk()).isTrue();
        assertThat(device(run, kind).info().id()).isEqualTo("r1/it");
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void equalSeedsGiveEqualReadings(DeviceKind kind) {
        assertThat(readings(with(kind), kind, 1)).usingRecursiveComparison().isEqualTo(readings(with(kind), kind, 1));
    }

    private static FaultInjection faults(SimRun run) {
        return run.system.faults().orElseThrow();
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void canBeDeadAndFrozen(DeviceKind kind) {
        SimRun run = with(kind);
        run.advance(1);
        Object last = device(run, kind).latest().orElseThrow().value();
        var frozen = faults(run).begin("r1", "it", new Fault.Frozen(), new SplittableRandom(3));
        assertThat(readings(run, kind, 1))
                .isNotEmpty()
                .allSatisfy(reading -> assertThat((Object) reading.value()).isEqualTo(last));
        frozen.cancel();
        var dead = faults(run).begin("r1", "it", new Fault.Dead(), new SplittableRandom(3));
        assertThat(readings(run, kind, 1)).isEmpty();
        assertThat(device(run, kind).health()).isInstanceOf(Health.Stale.class);
        dead.cancel();
        assertThat(readings(run, kind, 1)).isNotEmpty();
        assertThat(device(run, kind).health().isOk()).isTrue();
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void errorsAreAddedWhereReadingsCanErr(DeviceKind kind) {
        SimRun run = with(kind);
        var bias = new Fault.Biased(0.5, 0.2);
        if (Perturbable.class.isAssignableFrom(kind.reads())) {
            faults(run).begin("r1", "it", bias, new SplittableRandom(3));
            Object biased = readings(run, kind, 1).getLast().value();
            assertThat(biased)
                    .isNotEqualTo(readings(with(kind), kind, 1).getLast().value());
        } else {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> faults(run).begin("r1", "it", bias, new SplittableRandom(3)));
        }
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void isLostWithItsRobot(DeviceKind kind) {
        SimRun run = with(kind);
        run.advance(1);
        Sensor<?> device = device(run, kind);
        run.system.close();
        assertThat(device.health()).isInstanceOf(Health.Lost.class);
    }
}
