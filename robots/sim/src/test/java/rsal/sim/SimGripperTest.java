package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static rsal.sim.SimThings.can;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.GripperState;
import rsal.data.GripperState.Lift;
import rsal.data.GripperState.Paddles;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.GoalHandle;
import rsal.device.Gripper;
import rsal.device.Gripper.Result;
import rsal.device.LaserScanner;
import rsal.device.SimulationControl.Placement;
import rsal.robot.RobotModel.Part;

/// The robot looks along +x; its paddles are open from x = 2.3 to 2.5, y from 1.88 to 2.12.
class SimGripperTest {
    private static SimRun run(double step) {
        return run(step, SimThings.gripper());
    }

    private static SimRun run(double step, Part.Gripper gripper) {
        var model = Models.box(Models.DRIVE, gripper, Models.laser(0, Duration.ofMillis(100)));
        return SimRun.of(SimRun.room(8, 4), Map.of("step", step), SimRun.robot("r1", model, new Pose2d(2, 2, 0)));
    }

    private static Gripper gripper(SimRun run) {
        return run.robot("r1").require(Gripper.class);
    }

    private static GripperState state(SimRun run) {
        return gripper(run).latest().orElseThrow().value();
    }

    private static void put(SimRun run, rsal.device.SimulationControl.Thing thing) {
        assertThat(run.simulation.add(thing)).isEqualTo(new Placement.Placed());
    }

    private static List<Result> endings(GoalHandle<GripperState, Result> goal) {
        var endings = new ArrayList<Result>();
        goal.result().thenAccept(endings::add);
        return endings;
    }

    @ParameterizedTest
    @CsvSource({"0.01, 0.05", "0.03, 0.05", "0.1, 0.05", "0.2, 0.05", "0.1, 0.119", "0.2, 0.01"})
    void closesToTheWidthOfWhatItGripsWhateverTheStep(double step, double radius) {
        var run = run(step);
        put(run, can("can", 2.4, 2, radius, 0.3).asGrippable());
        List<Result> endings = endings(gripper(run).close());
        run.advance(2.2);
        assertThat(endings).hasSize(1);
        assertThat(state(run).closed()).isCloseTo(1 - 2 * radius / 0.24, within(1e-9));
        assertThat(state(run).holding()).isTrue();
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.06, -0.01, 0, 0.03, 0.069})
    void slidesWhatItGripsToTheMiddle(double aside) {
        var run = run(0.1);
        put(run, can("can", 2.4, 2 + aside, 0.05, 0.3).asGrippable());
        gripper(run).close();
        run.advance(2.2);
        assertThat(run.truth("can").x()).isCloseTo(2.4, within(1e-9));
        assertThat(run.truth("can").y()).isCloseTo(2, within(1e-9));
    }

    @Test
    void feelsOneSideFirstWhenSomethingIsNotInTheMiddle() {
        var run = run(0.1);
        put(run, can("can", 2.4, 2.06, 0.05, 0.3).asGrippable());
        gripper(run).close();
        run.advance(0.5);
        assertThat(state(run).leftContact()).isTrue();
        assertThat(state(run).rightContact()).isFalse();
        assertThat(state(run).holding()).isFalse();
    }

    @ParameterizedTest
    @CsvSource({"2.1, 2", "2.56, 2", "2.4, 2.1", "2.4, 2.2"})
    void doesNotGripWhatIsNotBetweenItsPaddles(double x, double y) {
        var run = run(0.1);
        put(run, can("can", x, y, 0.05, 0.3).asGrippable());
        gripper(run).close();
        run.advance(3);
        assertThat(state(run).holding()).isFalse();
        assertThat(state(run).closed()).isEqualTo(1);
    }

    @Test
    void doesNotGripWhatIsTooLowForIt() {
        var run = run(0.1); // its underside is at half the height of the body, 0.125 m
        put(run, can("flat", 2.4, 2, 0.05, 0.12).asGrippable());
        gripper(run).close();
        run.advance(3);
        assertThat(state(run).holding()).isFalse();
    }

    @Test
    void beginsAsItsModelSays() {
        var run = run(0.1, SimThings.gripper(true, true, false));
        run.advance(0.1);
        assertThat(state(run).paddles()).isEqualTo(Paddles.CLOSED);
        assertThat(state(run).lift()).isEqualTo(Lift.UP);
        List<Result> endings = endings(gripper(run).open());
        gripper(run).lower();
        run.advance(2.2);
        assertThat(endings).hasSize(1).first().isInstanceOf(Result.Reached.class);
        assertThat(state(run).paddles()).isEqualTo(Paddles.OPEN);
        assertThat(state(run).lift()).isEqualTo(Lift.DOWN);
    }

    @Test
    void snatchesWhatComesAndNotWhatItPutDown() {
        var run = run(0.1, SimThings.gripper(false, false, true));
        run.advance(1);
        assertThat(state(run).paddles()).isEqualTo(Paddles.OPEN);
        put(run, can("can", 2.42, 2, 0.05, 0.3).asGrippable());
        run.advance(3);
        assertThat(state(run).holding()).as("not in as far as the inner beam").isFalse();
        for (int i = 0; i < 20; i++) {
            run.base("r1").command(Twist2d.drive(0.1, 0));
            run.advance(0.1);
        }
        run.advance(3);
        assertThat(state(run).holding()).isTrue();
        gripper(run).open();
        run.advance(3);
        assertThat(state(run).holding()).isFalse();
        assertThat(state(run).paddles()).isEqualTo(Paddles.OPEN);
        assertThat(run.simulation.remove("can")).isTrue();
        run.advance(0.2);
        Pose2d ahead = run.truth("r1").compose(new Pose2d(0.35, 0, 0));
        put(run, can("other", ahead.x(), ahead.y(), 0.05, 0.3).asGrippable());
        run.advance(3);
        assertThat(state(run).holding()).isTrue();
    }

    @Test
    void doesNotSnatchUnlessItIsMadeFor() {
        var run = run(0.1);
        put(run, can("can", 2.35, 2, 0.05, 0.3).asGrippable());
        run.advance(3);
        assertThat(state(run).innerBeamBroken()).isTrue();
        assertThat(state(run).paddles()).isEqualTo(Paddles.OPEN);
    }

    @Test
    void whatItHoldsIsInNobodysWayAndHiddenFromItsOwnSensors() {
        var run = run(0.1);
        put(run, can("can", 2.4, 2, 0.05, 0.3).asObstacle().asGrippable());
        run.advance(0.1);
        LaserScanner laser = run.robot("r1").require(LaserScanner.class);
        assertThat(laser.latest().orElseThrow().value().ranges()[90]).isCloseTo(0.25f, within(1e-6f));
        gripper(run).close();
        run.advance(3);
        assertThat(laser.latest().orElseThrow().value().ranges()[90]).isCloseTo(5.8f, within(1e-6f));
        for (int i = 0; i < 30; i++) {
            run.base("r1").command(Twist2d.drive(0.4, 0));
            run.advance(0.1);
        }
        assertThat(run.truth("r1").x()).isGreaterThan(2.8);
        assertThat(run.truth("can").x() - run.truth("r1").x()).isCloseTo(0.4, within(1e-9));
        assertThat(run.simulation.contacts()).isEmpty();
    }

    @Test
    void doesNotOpenWhereWhatItHoldsHasNoRoom() {
        var run = run(0.1);
        put(run, can("can", 2.4, 2, 0.05, 0.3).asObstacle().asGrippable());
        gripper(run).close();
        run.advance(3);
        run.simulation.place("r1", new Pose2d(7.55, 2, 0)); // its paddles reach into the wall at 7.9
        List<Result> open = endings(gripper(run).open());
        run.advance(1);
        assertThat(open)
                .hasSize(1)
                .first()
                .isInstanceOfSatisfying(
                        Result.Stuck.class, stuck -> assertThat(stuck.why()).contains("no room for 'can'", "'wall'"));
        assertThat(state(run).holding()).isTrue();
        run.simulation.place("r1", new Pose2d(5, 2, 0));
        List<Result> again = endings(gripper(run).open());
        run.advance(3);
        assertThat(again).hasSize(1).first().isInstanceOf(Result.Reached.class);
        assertThat(run.truth("can").x()).isCloseTo(5.4, within(1e-9));
        assertThat(run.simulation.place("r1", new Pose2d(5.3, 2, 0))).isInstanceOf(Placement.Refused.class);
    }

    @Test
    void whoTakesAThingOutOfItHasIt() {
        var run = run(0.1);
        put(run, can("can", 2.4, 2, 0.05, 0.3).asObstacle().asGrippable());
        gripper(run).close();
        run.advance(3);
        assertThat(run.simulation.place("can", new Pose2d(-1, 2, 0))).isInstanceOf(Placement.Refused.class);
        assertThat(run.simulation.place("can", new Pose2d(0.1, 2, 0))).isInstanceOf(Placement.Refused.class);
        run.advance(0.1);
        assertThat(state(run).holding()).isTrue();
        assertThat(run.simulation.place("can", new Pose2d(6, 3, 0))).isEqualTo(new Placement.Placed());
        run.advance(0.1);
        assertThat(state(run).holding()).isFalse();
        assertThat(state(run).paddles()).isEqualTo(Paddles.STOPPED);
        run.base("r1").command(Twist2d.drive(0.4, 0));
        run.advance(0.5);
        assertThat(run.truth("can")).isEqualTo(new Pose2d(6, 3, 0));
    }

    @Test
    void whatIsTakenOutOfTheWorldIsNotHeldAnyMore() {
        var run = run(0.1);
        put(run, can("can", 2.4, 2, 0.05, 0.3).asGrippable());
        gripper(run).close();
        run.advance(3);
        assertThat(run.simulation.remove("can")).isTrue();
        run.advance(0.1);
        assertThat(state(run).holding()).isFalse();
        assertThat(state(run).innerBeamBroken()).isFalse();
    }

    /// Whatever it is told, in whatever order: against the rules, not against another program.
    @Test
    void keepsItsRulesWhateverItIsAsked() {
        int held = 0;
        for (long seed = 0; seed < 60; seed++) {
            var random = new SplittableRandom(seed);
            double dt = random.nextDouble(0.01, 0.2);
            var run = run(dt);
            put(
                    run,
                    can("can", 2.4, 2 + random.nextDouble(-0.05, 0.05), 0.05, 0.3)
                            .asGrippable());
            var endings = new ArrayList<List<Result>>();
            GripperState before = state(run, dt);
            Pose2d baseFromCan = Pose2d.ORIGIN;
            boolean opened = false;
            for (int i = 0; i < 400; i++) {
                boolean closing = before.paddles() == Paddles.CLOSING;
                opened = false;
                if (random.nextInt(15) == 0) {
                    int what = random.nextInt(5);
                    GoalHandle<GripperState, Result> goal = switch (what) {
                        case 0 -> gripper(run).open();
                        case 1, 2 -> gripper(run).close();
                        case 3 -> gripper(run).lift();
                        default -> gripper(run).lower();
                    };
                    opened = what == 0;
                    closing = closing || what == 1 || what == 2;
                    if (random.nextInt(8) == 0) {
                        goal.cancel();
                        closing = true;
                    }
                    endings.add(endings(goal));
                }
                run.base("r1").command(Twist2d.drive(random.nextDouble(-0.2, 0.2), random.nextDouble(-1, 1)));
                GripperState now = state(run, dt);
                String where = "seed %d, step %d".formatted(seed, i);
                assertThat(now.closed()).as(where).isBetween(0.0, 1.0);
                assertThat(Math.abs(now.closed() - before.closed())).as(where).isLessThanOrEqualTo(dt / 2 + 1e-9);
                assertThat(Math.abs(now.raised() - before.raised())).as(where).isLessThanOrEqualTo(dt / 2 + 1e-9);
                assertThat(now.paddles() == Paddles.OPEN && now.closed() != 0)
                        .as(where)
                        .isFalse();
                assertThat(now.lift() == Lift.UP && now.raised() != 1).as(where).isFalse();
                assertThat(now.holding() && !before.holding() && !closing)
                        .as(where)
                        .isFalse();
                assertThat(before.holding() && !now.holding() && !opened)
                        .as(where)
                        .isFalse();
                Pose2d at = run.truth("r1").inverse().compose(run.truth("can"));
                if (now.holding()) {
                    held++;
                    assertThat(now.closed()).as(where).isCloseTo(1 - 0.1 / 0.24, within(1e-9));
                    assertThat(before.holding() && at.distanceTo(baseFromCan) > 1e-9)
                            .as(where)
                            .isFalse();
                }
                baseFromCan = at;
                before = now;
            }
            assertThat(endings)
                    .as("seed %d", seed)
                    .allSatisfy(ends -> assertThat(ends).hasSizeLessThanOrEqualTo(1));
            run.system.close();
            assertThat(endings)
                    .as("seed %d", seed)
                    .allSatisfy(ends -> assertThat(ends).hasSize(1));
        }
        assertThat(held).isGreaterThan(1000);
    }

    private static GripperState state(SimRun run, double dt) {
        run.advance(dt);
        return gripper(run).latest().map(reading -> reading.value()).orElseThrow();
    }
}
