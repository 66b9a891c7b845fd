package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.Executor;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.Test;
import rsal.data.Fiducials.Fiducial;
import rsal.data.GripperState;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.FiducialFinder;
import rsal.device.Gripper;
import rsal.device.Health;
import rsal.device.LaserScanner;
import rsal.device.SimulationControl.Placement;
import rsal.device.SimulationControl.Standing;
import rsal.device.SimulationControl.Thing;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.scene.Scene;
import rsal.system.RobotSystem.Change;

/// Robots and things come and go while the world goes on.
class SimComingTest {
    private static final OccupancyGrid ROOM = SimRun.room(10, 6);
    private static final RobotModel MODEL =
            Models.box(Models.DRIVE, SimThings.gripper(), Models.laser(0.02, Duration.ofMillis(100)));
    private static final Pose2d THERE = new Pose2d(5, 3, 0);

    private final SimRun run = SimRun.of(
            ROOM, SimRun.robot("a", MODEL, new Pose2d(2, 3, 0)), SimRun.robot("b", MODEL, new Pose2d(2, 5, 0)));
    private final List<Change> changes = new ArrayList<>();

    SimComingTest() {
        run.system.onChange(changes::add);
        run.advance(0.5);
    }

    private static final Placement PLACED = new Placement.Placed();

    @Test
    void aRobotComesWithDevicesOfItsOwnAndIsReported() {
        assertThat(run.simulation.addRobot("c", "a", THERE)).isEqualTo(PLACED);
        assertThat(changes).singleElement().isInstanceOf(Change.Appeared.class);
        Robot came = ((Change.Appeared) changes.getFirst()).robot();
        assertThat(came.id()).isEqualTo("c");
        assertThat(came.role()).isEqualTo("robot");
        assertThat(came.model()).isEqualTo(run.robot("a").model());
        assertThat(run.simulation.entities()).containsExactly("a", "b", "c");
        assertThat(SimRun.ended(run.system.discover())).extracting(Robot::id).containsExactly("a", "b", "c");
        run.advance(0.3);
        assertThat(came.require(LaserScanner.class).latest()).isPresent();
        drive(came, 1);
        assertThat(run.truth("c").x()).isBetween(5.1, 5.6);
        assertThat(run.truth("a").x()).isEqualTo(2);
    }

    @Test
    void whoIsThereSeesAndFeelsWhoComes() {
        double before = ahead("a");
        assertThat(run.simulation.addRobot("c", "b", THERE)).isEqualTo(PLACED);
        run.advance(0.3);
        assertThat(ahead("a")).isLessThan(before - 1);
        assertThat(run.simulation.removeRobot("c")).isTrue();
        run.advance(0.3);
        assertThat(ahead("a")).isEqualTo(before, org.assertj.core.api.Assertions.within(0.1));
    }

    @Test
    void whoComesDoesNotWearTheMarkerOfTheOneThatItIsMadeAfter() {
        var finder = new Part.FiducialFinder("eyes", Pose2d.ORIGIN, 7, 9, 9, 0, true, Duration.ofMillis(100));
        RobotModel model = Models.box(Models.DRIVE, finder);
        var marked = new RobotSpec("b", "robot", model, Optional.of(THERE), "#000000", OptionalInt.of(5));
        var seeing = SimRun.of(ROOM, SimRun.robot("a", model, new Pose2d(2, 3, 0)), marked);
        assertThat(seeing.robot("b").marker()).hasValue(5);
        assertThat(markers(seeing)).containsExactly(OptionalInt.of(5));
        assertThat(seeing.simulation.addRobot("c", "b", new Pose2d(2, 5, 0))).isEqualTo(PLACED);
        assertThat(markers(seeing)).containsExactly(OptionalInt.of(5));
        assertThat(seeing.simulation.removeRobot("b")).isTrue();
        assertThat(markers(seeing)).isEmpty();
    }

    /// That robot `a` sees.
    private static List<OptionalInt> markers(SimRun seeing) {
        seeing.advance(0.3);
        FiducialFinder eyes = seeing.robot("a").require(FiducialFinder.class);
        return eyes.latest().orElseThrow().value().fiducials().stream()
                .map(Fiducial::id)
                .toList();
    }

    @Test
    void aRobotThatGoesIsReportedAndItsDevicesAreLost() {
        Robot b = run.robot("b");
        assertThat(run.simulation.removeRobot("b")).isTrue();
        assertThat(changes).containsExactly(new Change.Removed("b"));
        assertThat(b.devices()).allSatisfy(device -> assertThat(device.health()).isInstanceOf(Health.Lost.class));
        assertThat(run.simulation.entities()).containsExactly("a");
        assertThat(run.simulation.truth("b")).isEmpty();
        assertThat(run.simulation.body("b")).isEmpty();
        assertThat(run.simulation.removeRobot("b")).isFalse();
        var reported = new ArrayList<Object>();
        b.require(DriveBase.class).subscribe(reported::add);
        b.require(DriveBase.class).command(Twist2d.drive(0.3, 0));
        drive(run.robot("a"), 1);
        assertThat(reported).isEmpty();
        assertThat(run.truth("a").x()).isGreaterThan(2.1);
    }

    @Test
    void aRobotMayComeAfterOneThatIsGoneButNotAsThatOne() {
        run.simulation.removeRobot("b");
        changes.clear();
        refuses("b", "a", THERE, "A robot was called 'b' before");
        assertThat(run.simulation.addRobot("c", "b", THERE)).isEqualTo(PLACED);
        run.simulation.removeRobot("a");
        assertThat(run.simulation.addRobot("d", "a", new Pose2d(2, 3, 0))).isEqualTo(PLACED);
        assertThat(run.simulation.entities()).containsExactly("c", "d");
    }

    @Test
    void aRobotOfAnyModelComesIntoAWorldWithoutAny() {
        SimRun empty = SimRun.of(ROOM);
        empty.system.onChange(changes::add);
        assertThat(empty.simulation.addRobot("c", "a", THERE))
                .isEqualTo(
                        new Placement.Refused("There never was a robot 'a' to add one like. Nothing is known here."));
        assertThat(empty.system.addRobot(SimRun.robot("c", MODEL, THERE))).isEqualTo(PLACED);
        Robot came = ((Change.Appeared) changes.getFirst()).robot();
        assertThat(came.model()).isEqualTo(MODEL);
        empty.advance(0.3);
        assertThat(came.require(LaserScanner.class).latest()).isPresent();
        assertThat(empty.truth("c")).isEqualTo(THERE);
        assertThat(empty.simulation.addRobot("d", "c", new Pose2d(7, 3, 0))).isEqualTo(PLACED);
        assertThat(empty.system.addRobot(SimRun.robot("e", MODEL, THERE)))
                .isEqualTo(new Placement.Refused("'e' does not fit at (5.00, 3.00): 'c' is in the way."));
        assertThat(empty.system.addRobot(SimRun.robot("c", MODEL, new Pose2d(2, 3, 0))))
                .isInstanceOf(Placement.Refused.class);
        assertThat(empty.system.addRobot(SimRun.anywhere("e", MODEL)))
                .isEqualTo(new Placement.Refused("Robot 'e' has no pose."));
    }

    @Test
    void saysWhyARobotCantCome() {
        refuses("a", "b", THERE, "Something else is called 'a'");
        refuses("wall", "b", THERE, "Something else is called 'wall'");
        refuses(" ", "b", THERE, "from 1 to 100 letters");
        refuses("x".repeat(101), "b", THERE, "from 1 to 100 letters");
        refuses("c/d", "b", THERE, "slash");
        refuses("c", "z", THERE, "There never was a robot 'z'");
        refuses("c", "a", new Pose2d(2.1, 3, 0), "'a' is in the way");
        refuses("c", "a", new Pose2d(0.1, 3, 0), "'wall' is in the way");
        refuses(
                "c",
                "a",
                new Pose2d(-3, 3, 0),
                "outside of the world, which reaches from (0.00, 0.00) to (10.00, 6.00)");
        refuses("c", "a", new Pose2d(Double.NaN, 3, 0), "finite");
        assertThat(changes).isEmpty();
        assertThat(run.simulation.entities()).containsExactly("a", "b");
        run.system.close();
        refuses("c", "a", THERE, "closed");
        assertThat(run.simulation.removeRobot("a")).isFalse();
    }

    @Test
    void whatComesOrIsPutIntoAWorldWithoutAFenceMayStandFarFromAllElse() {
        RobotSpec a = SimRun.robot("a", MODEL, new Pose2d(9, 3, 0));
        Scene walled = Scene.of(ROOM);
        var open = SimRun.in(
                new Scene(
                        "",
                        ROOM,
                        Optional.empty(),
                        Optional.empty(),
                        walled.touch(),
                        List.of(),
                        List.of(),
                        List.of(),
                        Map.of(),
                        Map.of(),
                        Map.of(),
                        walled.contents(),
                        List.of(),
                        List.of()),
                a,
                SimRun.robot("far", MODEL, new Pose2d(0, 100, 0)));
        assertThat(open.truth("far").y()).isEqualTo(100);
        for (int i = 0; i < 40; i++) {
            open.base("a").command(Twist2d.drive(0.5, 0));
            open.advance(0.1);
        }
        Pose2d there = open.truth("a");
        assertThat(there.x()).isGreaterThan(10.2); // beyond its map

        assertThat(open.simulation.place("a", there)).isEqualTo(PLACED);
        assertThat(open.simulation.place("a", new Pose2d(-500, 3, 0))).isEqualTo(PLACED);
        assertThat(open.simulation.addRobot("b", "a", new Pose2d(500, -500, 1))).isEqualTo(PLACED);
        assertThat(open.simulation.add(SimThings.can("can", -498, 3, 0.2, 0.5))).isEqualTo(PLACED);
        open.advance(0.3);
        assertThat(ahead(open, "a")).isLessThan(2);
        assertThat(open.simulation.place("a", new Pose2d(1.1e6, 0, 0)))
                .isEqualTo(new Placement.Refused("(1100000.00, 0.00) is outside of the world, which reaches from "
                        + "(-1000000.00, -1000000.00) to (1000000.00, 1000000.00)."));
    }

    private void refuses(String id, String like, Pose2d pose, String why) {
        assertThat(run.simulation.addRobot(id, like, pose))
                .isInstanceOfSatisfying(
                        Placement.Refused.class,
                        refused -> assertThat(refused.why()).contains(why));
    }

    @Test
    void contactsOfThoseWhoComeAreMeasuredAndEndWithThoseWhoGo() {
        run.simulation.addRobot("c", "a", new Pose2d(3.2, 3, 0));
        drive(run.robot("a"), 5);
        assertThat(run.simulation.contacts())
                .singleElement()
                .satisfies(contact ->
                        assertThat(List.of(contact.robot(), contact.other())).containsExactly("a", "c"));
        run.simulation.removeRobot("c");
        drive(run.robot("a"), 2);
        assertThat(run.truth("a").x()).isGreaterThan(3);
        assertThat(run.simulation.contacts()).hasSize(1);
    }

    @Test
    void aRobotLeavesWhatItHeldWhereItIs() {
        Robot a = run.robot("a");
        run.simulation.add(SimThings.can("can", 2.4, 3, 0.05, 0.15).asObstacle().asGrippable());
        a.require(Gripper.class).closeAndLift();
        run.advance(9);
        assertThat(a.require(Gripper.class).latest().orElseThrow().value())
                .extracting(GripperState::holding)
                .isEqualTo(true);
        assertThat(standing("can").height()).isPositive();
        Pose2d held = run.truth("can");
        run.simulation.removeRobot("a");
        run.advance(1);
        assertThat(standing("can").mapFromThing()).isEqualTo(held);
        assertThat(standing("can").height()).isZero();
        drive(run.robot("b"), 1);
        run.simulation.place("b", new Pose2d(1.5, 3, 0));
        drive(run.robot("b"), 5);
        assertThat(run.simulation.contacts().getLast().other()).isEqualTo("can");
    }

    @Test
    void whoHearsOfARobotMayTakeItAndOthersOut() {
        run.robot("a").require(DriveBase.class).subscribe(_ -> {
            run.simulation.removeRobot("b");
            run.simulation.removeRobot("a");
        });
        run.advance(1);
        assertThat(run.simulation.entities()).isEmpty();
        assertThat(changes).hasSize(2);
    }

    @Test
    void thingsKeepTheirNumbersAndStayTheSameUntilTheyMove() {
        run.simulation.add(SimThings.can("can", 5, 3, 0.1, 0.3));
        var box = new Solid(List.of(
                new Prism(new Shape.Disc(new Point2d(0, 0), 0.2), 0, 0.1, java.util.Optional.of(SimThings.RED)),
                Prism.standing(new Shape.Disc(new Point2d(0.3, 0), 0.2), 0.1)));
        run.simulation.add(Thing.of("box", THERE, box, new rsal.data.Rgb(1, 2, 3)));
        List<Standing> before = run.simulation.things();
        assertThat(before).extracting(Standing::name).containsExactly("can", "box");
        assertThat(before).extracting(Standing::number).containsExactly(1, 2);
        assertThat(before.getLast().body().pieces())
                .extracting(piece -> piece.color().orElseThrow())
                .containsExactly(SimThings.RED, new rsal.data.Rgb(1, 2, 3));
        assertThat(run.simulation.body("box")).contains(before.getLast().body());
        run.simulation.place("box", new Pose2d(7, 3, 1));
        List<Standing> after = run.simulation.things();
        assertThat(after.getFirst()).isSameAs(before.getFirst());
        assertThat(after.getLast().mapFromThing()).isEqualTo(new Pose2d(7, 3, 1));
        assertThat(after.getLast().body()).isSameAs(before.getLast().body());
        run.simulation.remove("can");
        run.simulation.add(SimThings.can("can", 5, 3, 0.1, 0.3));
        assertThat(run.simulation.things()).extracting(Standing::number).containsExactly(2, 3);
    }

    @Test
    void goesOnAlikeOnOneCoreAndOnTwo() {
        String once = journal(Runnable::run);
        assertThat(journal(Runnable::run)).isEqualTo(once);
        try (var workers = Executors.newFixedThreadPool(2)) {
            assertThat(journal(workers)).isEqualTo(once);
        }
    }

    /// Where all are and what the newest sees, in a world where somebody comes and somebody goes, time and again.
    private static String journal(Executor workers) {
        var robots = new ArrayList<RobotSpec>();
        for (int i = 0; i < 6; i++) {
            robots.add(SimRun.robot("r" + i, MODEL, new Pose2d(2 + 3.0 * i, 2, 1)));
        }
        SimRun run = SimRun.seeded(SimRun.room(30, 20), 3, workers, robots);
        var present = new ArrayList<>(run.robots);
        run.system.onChange(change -> {
            switch (change) {
                case Change.Appeared(Robot robot) -> present.add(robot);
                case Change.Gone _ -> throw new AssertionError(change);
                case Change.Removed(String id) ->
                    present.removeIf(robot -> robot.id().equals(id));
            }
        });
        var journal = new StringBuilder();
        for (int round = 0; round < 30; round++) {
            run.simulation.addRobot("n" + round, "r" + round % 6, new Pose2d(2 + round % 9 * 3, 10, round));
            if (round % 2 == 1) {
                run.simulation.removeRobot(
                        present.get(round * 7 % present.size()).id());
            }
            run.simulation.add(SimThings.can("can" + round, 2 + round % 14 * 2, 15, 0.1, 0.3)
                    .asObstacle());
            for (int step = 0; step < 5; step++) {
                present.forEach(robot -> robot.require(DriveBase.class).command(Twist2d.drive(0.4, 0.1)));
                run.advance(0.1);
            }
            for (Robot robot : present) {
                journal.append(robot.id())
                        .append(run.truth(robot.id()))
                        .append(java.util.Arrays.hashCode(robot.require(LaserScanner.class)
                                .latest()
                                .orElseThrow()
                                .value()
                                .ranges()));
            }
        }
        assertThat(present.size()).isGreaterThan(15);
        return journal.append(run.simulation.contacts()).toString();
    }

    private void drive(Robot robot, double seconds) {
        for (int step = 0; step < seconds * 10; step++) {
            robot.require(DriveBase.class).command(Twist2d.drive(0.4, 0));
            run.advance(0.1);
        }
    }

    private Standing standing(String name) {
        return run.simulation.things().stream()
                .filter(thing -> thing.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    /// What a robot's laser measures straight ahead [m].
    private double ahead(String robot) {
        return ahead(run, robot);
    }

    private static double ahead(SimRun run, String robot) {
        var scan = run.robot(robot)
                .require(LaserScanner.class)
                .latest()
                .orElseThrow()
                .value();
        return Math.min(scan.ranges()[scan.count() / 2], scan.rangeMax());
    }
}
