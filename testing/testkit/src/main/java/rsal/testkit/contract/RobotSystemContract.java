package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.concurrent.Executor;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.data.Interval;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.device.LaserScanner;
import rsal.device.SonarArray;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Axis;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.OdometryNoise;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.Steering;
import rsal.robot.RobotSpec;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.time.LockstepScheduler;

/// What every robot system owes.
public abstract class RobotSystemContract extends RobotBench {
    @Test
    void isFoundByItsKey() {
        assertThat(ServiceLoader.load(RobotSystemProvider.class))
                .extracting(RobotSystemProvider::key)
                .contains(provider().key());
        assertThat(provider().description()).matches("[A-Z].*\\.");
    }

    @Test
    void itsParametersHaveNamesWordsAndFallbacksThatPass() {
        List<Parameter<?>> parameters = provider().parameters();
        assertThat(parameters)
                .extracting(Parameter::name)
                .doesNotHaveDuplicates()
                .doesNotContain("use");
        assertThat(parameters)
                .extracting(Parameter::description)
                .allSatisfy(d -> assertThat(d).isNotBlank());
        for (Parameter<?> parameter : parameters) {
            parameter
                    .fallback()
                    .ifPresent(
                            fallback -> assertThat(parameter.accept(fallback)).isEqualTo(fallback));
        }
        assertThat(Arguments.of(parameters, settings()).asMap()).hasSameSizeAs(parameters);
    }

    @Test
    void findsTheRobotsThatWereAskedFor() {
        try (RobotSystem two = create(List.of(spec("zoe", WORLD.pose('b', 0)), spec("al", WORLD.pose('c', 90))), 1)) {
            List<Robot> robots = await(two.discover());
            assertThat(robots).extracting(Robot::id).containsExactlyInAnyOrder("zoe", "al");
            assertThat(robots).extracting(Robot::role).containsOnly("tested");
            assertThat(robots).extracting(r -> r.model().name()).containsOnly("pioneer2dx");
        }
    }

    @Test
    void robotsHaveTheDevicesOfTheirModel() {
        assertThat(robot().find(DriveBase.class)).isPresent();
        assertThat(robot().require(LaserScanner.class).info().name()).isEqualTo("laser");
        assertThat(robot().require(SonarArray.class).info().name()).isEqualTo("sonar");
        assertThat(robot().devices())
                .extracting(Device::info)
                .allSatisfy(info -> assertThat(info.robot()).isEqualTo("r1"));
    }

    /// Not every system has every part, but none drops one without a word.
    @ParameterizedTest
    @CsvSource({
        "camera, blob-camera",
        "fiducials, fiducials180",
        "gripper, pioneer-gripper",
        "bumper, pioneer2dx-bumpers",
        "turntable, turntable",
        "battery, pioneer-battery",
        "light, beacon"
    })
    void aPartBecomesADeviceOrTheRobotIsRefused(String device, String part) {
        RobotModel model = model(Map.of(device, part));
        var asked = new RobotSpec("r1", "tested", model, Optional.of(START), "#3366cc");
        try (RobotSystem one = create(List.of(asked), 1)) {
            Part made = java.util.Objects.requireNonNull(model.sensors().get(device));
            assertThat(await(one.discover())
                            .getFirst()
                            .require(made.makes())
                            .info()
                            .name())
                    .isEqualTo(device);
        } catch (RobotSystemProvider.InvalidRobots e) {
            assertThat(e.problems()).hasSize(1);
            assertThat(e.problems().getFirst().setting()).isEqualTo("model");
            assertThat(e.problems().getFirst().message()).contains(part);
        }
    }

    static List<Drive> drives() {
        Axis forward = new Axis(new Interval(-0.2, 1), Interval.around0(1));
        Axis turn = Axis.symmetric(2, 4);
        var noise = new OdometryNoise(0, 0, 0);
        return List.of(
                new Drive(new Steering.Differential(), forward, Axis.NONE, turn, noise),
                new Drive(new Steering.Omnidirectional(), forward, Axis.symmetric(0.5, 1), turn, noise),
                new Drive(new Steering.Car(0.3, 0.5), forward, Axis.NONE, turn, noise));
    }

    @ParameterizedTest
    @MethodSource("drives")
    void aDriveIsDrivenOrTheRobotIsRefused(Drive drive) {
        var asked = new RobotSpec("r1", "tested", model().with(drive), Optional.of(START), "#3366cc");
        try (RobotSystem one = create(List.of(asked), 1)) {
            DriveBase base = await(one.discover()).getFirst().require(DriveBase.class);
            for (int step = 0; step < 20; step++) {
                base.command(Twist2d.drive(-1, 0));
                run.advance(STEP);
            }
            assertThat(base.latest().orElseThrow().value().velocity().vx()).isCloseTo(-0.2, within(0.02));
        } catch (RobotSystemProvider.InvalidRobots e) {
            assertThat(e.problems()).hasSize(1);
            assertThat(e.problems().getFirst().setting()).isEqualTo("model");
            assertThat(e.problems().getFirst().message()).containsIgnoringCase("drive");
        }
    }

    @Test
    void robotsStartWhereTheyWereAskedTo() {
        assertThat(truth()).isEqualTo(START);
    }

    @Test
    void aRobotInsideAWallIsRefusedBeforeAnythingStarts() {
        needs(Capability.WALLS);
        var inWall = new Pose2d(0.1, 0.1, 0);
        assertThatExceptionOfType(RobotSystemProvider.InvalidRobots.class)
                .isThrownBy(() -> create(List.of(spec("good", START), spec("bad", inWall)), 1))
                .satisfies(e -> {
                    assertThat(e.problems()).hasSize(1);
                    assertThat(e.problems().getFirst().robot()).isEqualTo("bad");
                    assertThat(e.problems().getFirst().setting()).isEqualTo("pose");
                    assertThat(e.problems().getFirst().message()).isNotBlank();
                });
    }

    @Test
    void closedItStopsItsRobotsAndIsSilent() {
        drive(Twist2d.drive(0.4, 0), 2);
        system().close();
        system().close();
        Optional<Pose2d> stopped = system().simulation().flatMap(s -> s.truth("r1"));
        var reported = new ArrayList<Object>();
        robot().require(DriveBase.class).subscribe(reported::add);
        robot().require(LaserScanner.class).subscribe(reported::add);
        advance(2);
        assertThat(reported).isEmpty();
        assertThat(system().simulation().flatMap(s -> s.truth("r1"))).isEqualTo(stopped);
    }

    @Test
    void theSameSeedGivesTheSameReadingsOnOneWorkerOrFour() {
        needs(Capability.REPEATABLE);
        String once = journal(42, Runnable::run);
        assertThat(journal(42, Runnable::run)).isEqualTo(once);
        try (var workers = Executors.newFixedThreadPool(4)) {
            assertThat(journal(42, workers)).isEqualTo(once);
        }
    }

    /// All that two robots sense in ten seconds, bit for bit.
    private String journal(long seed, Executor workers) {
        var scheduler = new LockstepScheduler(java.time.Instant.EPOCH, workers);
        var journal = new StringBuilder();
        try (RobotSystem two =
                create(List.of(spec("r1", WORLD.pose('b', 0)), spec("r2", WORLD.pose('c', 90))), seed, scheduler)) {
            var robots = new ArrayList<Robot>();
            two.discover().thenAccept(robots::addAll);
            scheduler.advance(STEP);
            assertThat(robots).hasSize(2);
            for (Robot each : robots) {
                each.require(DriveBase.class)
                        .subscribe(
                                r -> journal.append(r.time()).append(r.value()).append('\n'));
                each.require(LaserScanner.class)
                        .subscribe(r -> journal.append(Arrays.hashCode(r.value().ranges()))
                                .append('\n'));
                each.require(SonarArray.class)
                        .subscribe(r -> journal.append(Arrays.toString(r.value().ranges()))
                                .append('\n'));
            }
            for (int step = 0; step < 100; step++) {
                robots.get(0).require(DriveBase.class).command(Twist2d.drive(0.3, 0.2));
                robots.get(1).require(DriveBase.class).command(Twist2d.drive(0.4, -0.1));
                scheduler.advance(STEP);
            }
        }
        assertThat(journal).hasSizeGreaterThan(1000);
        return journal.toString();
    }
}
