package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static rsal.sim.SimRun.anywhere;
import static rsal.sim.SimRun.robot;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.Executor;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.device.Health;
import rsal.device.LaserScanner;
import rsal.device.SimulationControl.Contact;
import rsal.device.SimulationControl.Placement;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotSpec;
import rsal.testkit.DrawnMap;

class SimSystemTest {
    @Test
    void runsAreTheSameOnOneWorkerOrTwo() {
        List<Object> once = journal(Runnable::run);
        assertThat(journal(Runnable::run)).isEqualTo(once);
        try (var workers = Executors.newFixedThreadPool(2)) {
            assertThat(journal(workers)).isEqualTo(once);
        }
    }

    /// Where twelve robots are that drive about the office, and what they see, bit for bit.
    private static List<Object> journal(Executor workers) {
        RobotModel model = Models.box(
                new Drive(0.8, 2, 0.5, 3, new RobotModel.OdometryNoise(0.02, 0.02, 0.02)),
                Models.laser(0.01, Duration.ofMillis(100)),
                Models.SONARS);
        var specs = new ArrayList<RobotSpec>();
        for (int i = 0; i < 12; i++) {
            specs.add(anywhere("r" + i, model));
        }
        var run = SimRun.seeded(SimProviderTest.OFFICE, 5, workers, specs);
        var journal = new ArrayList<Object>();
        var random = new SplittableRandom(1);
        for (RobotSpec spec : specs) {
            run.base(spec.id()).subscribe(journal::add);
            run.robot(spec.id()).require(LaserScanner.class).subscribe(scan -> {
                journal.add(Arrays.hashCode(scan.value().ranges()));
                // what listeners do is not seen before the next step, even if others are still looking
                run.simulation.place("r0", run.truth("r0"));
            });
        }
        for (int step = 0; step < 100; step++) {
            for (RobotSpec spec : specs) {
                run.base(spec.id()).command(Twist2d.drive(random.nextDouble(-0.3, 1), random.nextDouble(-1, 1)));
            }
            run.advance(0.1);
            specs.forEach(spec -> journal.add(run.truth(spec.id())));
        }
        journal.addAll(run.simulation.contacts());
        return journal;
    }

    @ParameterizedTest
    @CsvSource({"0.01, 1", "0.2, 1", "0.1, 5", "0.2, 40"})
    void nobodyGetsThroughAWallAtAnySpeedOrStep(double step, double speed) {
        var map = DrawnMap.grid(0.05, """
                #########################################
                #...................#...................#
                """ + "#...................#...................#\n".repeat(30) + """
                #########################################""")
                .grid();
        RobotModel model = Models.box(new Drive(speed, 6, 10 * speed, 60, Models.NO_NOISE));
        var run = SimRun.of(
                map,
                Map.of("step", step),
                robot("r1", model, new Pose2d(0.5, 0.5, 0)),
                robot("r2", model, new Pose2d(1.5, 0.5, 0)),
                robot("r3", model, new Pose2d(0.5, 1.2, 0)));
        var random = new SplittableRandom(1);
        for (int i = 0; i < 400; i++) {
            for (String id : run.simulation.entities()) {
                run.base(id).command(Twist2d.drive(random.nextDouble(-speed, speed), random.nextDouble(-6, 6)));
            }
            run.advance(0.2);
            assertThat(run.truth("r1").x()).isBetween(0.05, 1.0);
            assertThat(run.truth("r2").x()).isBetween(1.05, 2.0);
            assertThat(run.truth("r3").x()).isBetween(0.05, 1.0);
        }
        assertThat(run.simulation.contacts()).isNotEmpty();
    }

    @Test
    void robotsThatMeetTouchOnce() {
        var run = SimRun.of(
                SimRun.room(8, 4),
                robot("r1", Models.box(), new Pose2d(2, 2, 0)),
                robot("r2", Models.box(), new Pose2d(5, 2, Math.PI)));
        for (int i = 0; i < 80; i++) {
            run.base("r1").command(Twist2d.drive(0.4, 0));
            run.base("r2").command(Twist2d.drive(0.4, 0));
            run.advance(0.1);
        }
        assertThat(run.simulation.contacts()).hasSize(1);
        Contact contact = run.simulation.contacts().getFirst();
        assertThat(List.of(contact.robot(), contact.other())).containsExactlyInAnyOrder("r1", "r2");
        assertThat(run.truth("r2").x() - run.truth("r1").x()).isBetween(0.5, 0.51);
    }

    @Test
    void placingOntoAnotherRobotIsRefusedWithItsName() {
        var run = SimRun.of(
                SimRun.room(8, 4),
                robot("r1", Models.box(), new Pose2d(2, 2, 0)),
                robot("r2", Models.box(), new Pose2d(5, 2, 0)));
        assertThat(run.simulation.place("r1", new Pose2d(5.2, 2, 0)))
                .isInstanceOfSatisfying(
                        Placement.Refused.class, r -> assertThat(r.why()).contains("'r2' is in the way"));
        assertThat(run.simulation.place("r1", new Pose2d(5.6, 2, 0))).isEqualTo(new Placement.Placed());
    }

    @Test
    void whoeverHoldsADeviceIsInformedWhenTheSimulationCloses() {
        var run = SimRun.of(SimRun.room(8, 4), robot("r1", Models.box(), new Pose2d(2, 2, 0)));
        run.advance(1);
        var reported = new ArrayList<Health>();
        run.robot("r1").devices().forEach(device -> device.onHealth(reported::add));
        run.simulation.onHealth(reported::add);
        run.system.close();
        assertThat(reported).hasSize(4).containsOnly(new Health.Lost("The simulation was closed."));
        assertThat(run.system.discover().toCompletableFuture()).isCompletedExceptionally();
    }

    @Test
    void aListenerMayCloseTheSimulation() {
        var run = SimRun.of(
                SimRun.room(8, 4),
                robot("r1", Models.box(), new Pose2d(2, 2, 0)),
                robot("r2", Models.box(), new Pose2d(5, 2, 0)));
        run.base("r1").subscribe(_ -> run.system.close());
        run.advance(1);
        assertThat(run.base("r2").latest()).isEmpty();
        assertThat(run.base("r2").health().isOk()).isFalse();
        assertThat(run.robot("r1").require(LaserScanner.class).latest()).isEmpty();
        assertThat(run.robot("r1").devices())
                .extracting(Device::health)
                .containsOnly(new Health.Lost("The simulation was closed."));
    }
}
