package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import rsal.data.Fan;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.SimulationControl.Contact;
import rsal.device.SimulationControl.Placement;
import rsal.device.SimulationControl.Thing;

/// What every [rsal.device.SimulationControl] owes. A system without a simulated world does not extend this.
public abstract class SimulationControlContract extends RobotBench {
    @Test
    void knowsWhereTheRobotsAre() {
        assertThat(simulation().entities()).contains("r1");
        assertThat(truth()).isEqualTo(START);
        assertThat(simulation().truth("nobody")).isEmpty();
    }

    @Test
    void theTruthMovesWithTheRobot() {
        drive(Twist2d.drive(0.4, 0), 4);
        Pose2d startFromNow = START.inverse().compose(truth());
        assertThat(startFromNow.x()).isBetween(1.2, 1.7);
        assertThat(Math.abs(startFromNow.y())).isLessThan(0.01);
    }

    @Test
    void placesARobotStandingStillAndOdometryDoesNotNotice() {
        drive(Twist2d.drive(0.4, 0), 2);
        Pose2d odomBefore = odom();
        Pose2d there = WORLD.pose('b', 45);
        assertThat(simulation().place("r1", there)).isEqualTo(new Placement.Placed());
        assertThat(truth()).isEqualTo(there);
        advance(1);
        assertThat(truth()).isEqualTo(there);
        assertThat(odom().isNear(odomBefore, 0.05, 0.05)).isTrue();
    }

    @Test
    void refusesToPlaceARobotInAWallOrOutside() {
        assertRefused("r1", new Pose2d(WORLD.grid().width() * 0.25 - 0.1, 4, 0));
        assertRefused("r1", new Pose2d(-3, 4, 0));
        assertRefused("r1", new Pose2d(Double.NaN, 4, 0));
        assertThat(truth()).isEqualTo(START);
    }

    @Test
    void refusesToPlaceNobody() {
        assertRefused("nobody", START);
    }

    @Test
    void whatReallyIsSomewhereIsPlacedThereAlsoWhereThereIsNoRoom() {
        Pose2d inWall = new Pose2d(0.1, 4, 0);
        assertThat(simulation().placeAnyway("r1", inWall)).isEqualTo(new Placement.Placed());
        assertThat(truth()).isEqualTo(inWall);
        assertThat(simulation().addAnyway(thing("box", inWall).asObstacle())).isEqualTo(new Placement.Placed());
        assertThat(simulation().truth("box")).contains(inWall);
        Pose2d inRobot = START.compose(new Pose2d(0.05, 0, 0));
        simulation().placeAnyway("r1", START);
        assertThat(simulation().placeAnyway("box", inRobot)).isEqualTo(new Placement.Placed());
        assertThat(simulation().truth("box")).contains(inRobot);
        drive(Twist2d.drive(0.4, 0), 2);
        assertThat(truth()).as("stuck").isEqualTo(START);
        simulation().placeAnyway("box", inWall);
        drive(Twist2d.drive(0.4, 0), 2);
        assertThat(START.inverse().compose(truth()).x()).isGreaterThan(0.4);
    }

    @Test
    void whoOverlapsWhatWasPlacedAnywayDrivesOutAndNotInAgain() {
        Pose2d atTheBack = START.compose(new Pose2d(-0.15, 0, 0));
        assertThat(simulation().addAnyway(thing("box", atTheBack).asObstacle())).isEqualTo(new Placement.Placed());
        drive(Twist2d.drive(-0.4, 0), 2);
        assertThat(truth()).as("not through it").isEqualTo(START);
        drive(Twist2d.drive(0.4, 0), 3);
        assertThat(START.inverse().compose(truth()).x()).isGreaterThan(0.7);
        drive(Twist2d.drive(-0.4, 0), 5);
        assertThat(START.inverse().compose(truth()).x()).as("not in again").isBetween(0.05, 0.4);
    }

    @Test
    void whatIsCarriedElsewhereIsPlacedAboveTheFloor() {
        Pose2d ahead = START.compose(new Pose2d(1, 0, 0));
        put(thing("box", ahead));
        Pose2d further = START.compose(new Pose2d(2, 0, 0));
        assertThat(simulation().placeAnyway("box", further, 0.3)).isEqualTo(new Placement.Placed());
        assertThat(simulation().truth("box")).contains(further);
        assertThat(simulation().placeAnyway("nothing", further, 0.3)).isInstanceOf(Placement.Refused.class);
        assertThat(simulation().placeAnyway("r1", further, 0.3))
                .as("robots stay on it")
                .isInstanceOf(Placement.Refused.class);
    }

    @Test
    void refusesToPlaceAnywayWhatIsNotThereOrNowhere() {
        assertThat(simulation().placeAnyway("nobody", START)).isInstanceOf(Placement.Refused.class);
        assertThat(simulation().placeAnyway("r1", new Pose2d(-3, 4, 0))).isInstanceOf(Placement.Refused.class);
        assertThat(simulation().placeAnyway("r1", new Pose2d(Double.NaN, 4, 0))).isInstanceOf(Placement.Refused.class);
        assertThat(simulation().addAnyway(thing("r1", START))).isInstanceOf(Placement.Refused.class);
        assertThat(simulation().addAnyway(thing("box", new Pose2d(-3, 4, 0)))).isInstanceOf(Placement.Refused.class);
        assertThat(simulation().entities()).containsExactly("r1");
        assertThat(truth()).isEqualTo(START);
    }

    @Test
    void raysMeetRobotsAndThingsAndPassThroughWallsAndWhomTheyShall() {
        put(thing("box", START.compose(new Pose2d(3, 0, 0))));
        advance(1);
        Pose2d behind = START.compose(new Pose2d(-1, 0, 0));
        var fans = List.of(new Fan(Pose2d.ORIGIN, -0.7, 0.7, 3), new Fan(new Pose2d(2, 0, Math.PI), 0, 1, 1));
        double[] all = simulation().ranges(fans, behind, 0.2, 30, Set.of());
        assertThat(all).hasSize(4);
        assertThat(all[0]).as("past it, through walls").isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(all[1]).as("the robot's back").isBetween(0.6, 0.9);
        assertThat(all[2]).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(all[3]).as("its front").isBetween(0.6, 0.9);
        double[] others = simulation().ranges(fans, behind, 0.2, 30, Set.of("r1"));
        assertThat(others[1]).as("the box behind it").isCloseTo(3.9, within(0.01));
        assertThat(others[3]).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(simulation().ranges(fans, behind, 0.2, 3.8, Set.of("r1"))[1])
                .as("beyond reach")
                .isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(simulation().ranges(fans, behind, 0.6, 30, Set.of("r1"))[1])
                .as("over it")
                .isEqualTo(Double.POSITIVE_INFINITY);
    }

    @Test
    void countsATouchOnceUntilItIsOver() {
        needs(Capability.WALLS);
        simulation()
                .place(
                        "r1",
                        new Pose2d(WORLD.place('w').x() - 1, WORLD.place('w').y(), 0));
        assertThat(simulation().contacts()).isEmpty();
        drive(Twist2d.drive(0.4, 0), 6);
        assertThat(simulation().contacts()).hasSize(1);
        Contact contact = simulation().contacts().getFirst();
        assertThat(contact.robot()).isEqualTo("r1");
        assertThat(contact.other()).isEqualTo("wall");
        assertThat(contact.time()).isBetween(run.instant().minusSeconds(6), run.instant());
        drive(Twist2d.drive(-0.4, 0), 3);
        drive(Twist2d.drive(0.4, 0), 6);
        assertThat(simulation().contacts()).hasSize(2);
    }

    @Test
    void thingsComeMoveAndGo() {
        Pose2d here = WORLD.pose('b', 30);
        put(thing("box", here));
        assertThat(simulation().entities()).contains("r1", "box");
        assertThat(simulation().truth("box")).contains(here);
        Pose2d there = WORLD.pose('c', -90);
        assertThat(simulation().place("box", there)).isEqualTo(new Placement.Placed());
        advance(1);
        assertThat(simulation().truth("box")).contains(there);
        assertThat(simulation().remove("box")).isTrue();
        assertThat(simulation().remove("box")).isFalse();
        assertThat(simulation().entities()).doesNotContain("box");
        assertThat(simulation().truth("box")).isEmpty();
        assertRefused("box", here);
        put(thing("box", here));
    }

    @Test
    void refusesThingsThatAreCalledLikeOthersOrHaveNoRoom() {
        needs(Capability.THINGS);
        put(thing("box", WORLD.pose('b', 0)));
        assertRefused(thing("box", WORLD.pose('c', 0)));
        assertRefused(thing("r1", WORLD.pose('c', 0)));
        assertRefused(thing("far", new Pose2d(-3, 4, 0)));
        assertRefused(thing("broken", new Pose2d(Double.NaN, 4, 0)));
        assertThat(simulation().entities()).containsExactlyInAnyOrder("r1", "box");
        assertThat(simulation().remove("r1")).as("robots stay").isFalse();
    }

    @Test
    void robotsRunIntoObstaclesAndDriveThroughOtherThings() {
        put(thing("paper", START.compose(new Pose2d(1, 0, 0))));
        drive(Twist2d.drive(0.4, 0), 5);
        assertThat(START.inverse().compose(truth()).x()).isGreaterThan(1.5);
        simulation().place("r1", START);
        put(thing("box", START.compose(new Pose2d(1, 0, 0))).asObstacle());
        drive(Twist2d.drive(0.4, 0), 5);
        assertThat(START.inverse().compose(truth()).x()).isLessThan(0.9);
        assertThat(robot().require(DriveBase.class)
                        .latest()
                        .orElseThrow()
                        .value()
                        .stalled())
                .isTrue();
        simulation().remove("box");
        drive(Twist2d.drive(0.4, 0), 5);
        assertThat(START.inverse().compose(truth()).x()).isGreaterThan(1.5);
    }

    private static Thing thing(String name, Pose2d mapFromThing) {
        return Thing.of(
                name, mapFromThing, Solid.standing(new Shape.Disc(new Point2d(0, 0), 0.1), 0.5), new Rgb(200, 100, 0));
    }

    private void assertRefused(Thing thing) {
        assertThat(simulation().add(thing))
                .isInstanceOfSatisfying(
                        Placement.Refused.class,
                        refused -> assertThat(refused.why()).isNotBlank());
    }

    private void assertRefused(String entity, Pose2d place) {
        assertThat(simulation().place(entity, place))
                .isInstanceOfSatisfying(
                        Placement.Refused.class,
                        refused -> assertThat(refused.why()).isNotBlank());
    }

    private Pose2d odom() {
        return robot().require(DriveBase.class).latest().orElseThrow().value().odomFromBase();
    }
}
