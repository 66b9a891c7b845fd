package rsal.behavior;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.data.Twist2d;

/// A percept in, a twist out, layer by layer.
class PioneerLayersTest {
    private static final Twist2d FAST = Twist2d.drive(0.4, 0);

    @Test
    void withoutAWallItGoesStraightAndSearches() {
        var follow = new FollowLeftWall(Scene.BODY, 0.4, 0.5);
        assertThat(follow.act(Scene.open().percept(), Twist2d.STOP)).isEqualTo(FAST);
        assertThat(follow.state()).isEqualTo("searching");
    }

    @Test
    void besideAWallAtItsDistanceItGoesStraight() {
        Twist2d twist = followed(Scene.open().wall(90, 0.51));
        assertThat(twist.vx()).isGreaterThan(0.3);
        assertThat(Math.abs(twist.omega())).isLessThan(0.25);
    }

    @Test
    void tooNearItTurnsAwayTooFarItTurnsThere() {
        assertThat(followed(Scene.open().wall(90, 0.4)).omega()).isNegative();
        assertThat(followed(Scene.open().wall(90, 0.7)).omega()).isPositive();
    }

    @Test
    void aWallAheadTurnsItRight() {
        Twist2d twist = followed(Scene.open().wall(90, 0.5).wall(0, 0.8));
        assertThat(twist.omega()).isLessThan(-0.5);
    }

    @Test
    void aDoorOnTheLeftIsTaken() {
        Scene scene = Scene.open().wall(90, 0.5).gap(48, 132); // 0.9 m wide
        Twist2d twist = followed(scene);
        assertThat(twist.omega()).isGreaterThan(0.5);
        assertThat(twist.vx()).isZero();
    }

    @Test
    void aDoorTooNarrowIsPassedBy() {
        Twist2d twist = followed(Scene.open().wall(90, 0.51).gap(63, 117)); // 0.5 m wide
        assertThat(Math.abs(twist.omega())).isLessThan(0.25);
    }

    @Test
    void aDeadEndIsLeftBackwards() {
        Twist2d twist = followed(Scene.open().wall(90, 0.5).wall(0, 0.5).wall(-90, 0.5));
        assertThat(twist.vx()).isZero();
        assertThat(twist.omega()).isNegative();
    }

    @Test
    void whereNobodyLooksIsNoWay() {
        Twist2d twist = followed(Scene.open().wall(90, 0.5).unseen(60, 180));
        assertThat(twist.omega()).isLessThanOrEqualTo(0.25);
    }

    @Test
    void anIslandIsLeftAfterMoreThanATurn() {
        var follow = new FollowLeftWall(Scene.BODY, 0.4, 0.5);
        double turned = 0;
        while (turned < 2.6 * Math.PI) {
            follow.act(Scene.open().thing(90, 0.6).at(new Pose2d(0, 0, turned)).percept(), Twist2d.STOP);
            turned += 0.1;
        }
        assertThat(follow.state()).isEqualTo("searching");
        Twist2d twist = follow.act(
                Scene.open().thing(90, 0.6).at(new Pose2d(0, 0, turned)).percept(), Twist2d.STOP);
        assertThat(twist).isEqualTo(FAST);
    }

    @Test
    void aFreeWayIsLeftAlone() {
        Percept percept = Scene.open().wall(90, 0.4).percept();
        assertThat(new AvoidCollision(Scene.BODY).act(percept, FAST)).isSameAs(FAST);
        assertThat(new LimitSpeed(Scene.BODY, 0.4, 0.2).act(percept, FAST)).isSameAs(FAST);
        assertThat(new LimitTurnRate(Scene.BODY, 1).act(percept, FAST)).isSameAs(FAST);
    }

    @Test
    void aThingInTheWayIsDrivenAround() {
        Twist2d twist =
                new AvoidCollision(Scene.BODY).act(Scene.open().thing(3, 0.5).percept(), FAST);
        assertThat(twist).isNotEqualTo(FAST);
        assertThat(twist.omega() != 0 || twist.vx() < FAST.vx()).isTrue();
        var body = new Body(Scene.BODY);
        assertThat(body.timeToTouch(Scene.open().thing(3, 0.5).percept().surroundings(), twist, 0.05, 1))
                .isGreaterThanOrEqualTo(1);
    }

    @Test
    void facingAWallItTurns() {
        Twist2d twist =
                new AvoidCollision(Scene.BODY).act(Scene.open().wall(0, 0.4).percept(), FAST);
        assertThat(twist.omega()).isNotZero();
    }

    @Test
    void whoWandersTurnsToWhereThereIsRoomAndOnUntilTheWayIsFree() {
        var wander = new Wander(Scene.BODY, 0.4);
        assertThat(wander.act(Scene.open().percept(), Twist2d.STOP)).isEqualTo(Twist2d.drive(0.4, 0));
        Scene corner = Scene.open().wall(0, 0.5).wall(90, 0.5);
        assertThat(wander.act(corner.percept(), Twist2d.STOP)).isEqualTo(Twist2d.drive(0, -0.8));
        assertThat(wander.state()).isEqualTo("turning");
        Scene other = Scene.open().wall(0, 0.5).wall(-90, 0.5);
        assertThat(wander.act(other.percept(), Twist2d.STOP))
                .as("does not change its mind")
                .isEqualTo(Twist2d.drive(0, -0.8));
        assertThat(wander.act(Scene.open().wall(90, 0.5).percept(), Twist2d.STOP))
                .isEqualTo(Twist2d.drive(0.4, 0));
        assertThat(wander.state()).isEmpty();
    }

    @Test
    void whereNothingIsFreeItDoesNotDrive() {
        Scene box = Scene.open().wall(0, 0.2).wall(90, 0.21).wall(-90, 0.21).wall(180, 0.28);
        assertThat(new AvoidCollision(Scene.BODY).act(box.percept(), FAST).vx()).isZero();
    }

    @Test
    void itSlowsDownTowardsAWallAndStopsAtTheStopDistance() {
        var limit = new LimitSpeed(Scene.BODY, 0.4, 0.2);
        double far = limit.act(Scene.open().wall(0, 1.5).percept(), FAST).vx();
        double near = limit.act(Scene.open().wall(0, 0.6).percept(), FAST).vx();
        double there = limit.act(Scene.open().wall(0, 0.37).percept(), FAST).vx();
        assertThat(far).isEqualTo(0.4);
        assertThat(near).isBetween(0.1, 0.39);
        assertThat(there).isZero();
    }

    @Test
    void itNeverDrivesFasterThanIsSafeInEitherDirection() {
        var limit = new LimitSpeed(Scene.BODY, 0.4, 0.2);
        assertThat(limit.act(Scene.open().percept(), Twist2d.drive(3, 0.2))).isEqualTo(Twist2d.drive(0.4, 0.2));
        assertThat(limit.act(Scene.open().percept(), Twist2d.drive(-3, 0))).isEqualTo(Twist2d.drive(-0.4, 0));
    }

    @Test
    void itNeverTurnsFasterThanIsSafe() {
        var limit = new LimitTurnRate(Scene.BODY, 1);
        assertThat(limit.act(Scene.open().percept(), Twist2d.drive(0.1, -5))).isEqualTo(Twist2d.drive(0.1, -1));
    }

    @Test
    void itDoesNotTurnItsTailIntoAThing() {
        Percept percept = Scene.open().thing(150, 0.3).percept(); // beside the left rear corner
        Twist2d twist = new LimitTurnRate(Scene.BODY, 1).act(percept, Twist2d.drive(0, 1));
        assertThat(twist.omega()).isZero();
    }

    @Test
    void aRobotThatGetsOnIsNotStuck() {
        var escape = new EscapeWhenStuck(Scene.BODY);
        for (int update = 0; update < 100; update++) {
            Percept percept = Scene.open().at(new Pose2d(0.01 * update, 0, 0)).percept();
            assertThat(escape.act(percept, FAST)).isSameAs(FAST);
        }
    }

    @Test
    void aRobotThatTurnsIsNotStuckAndOneThatIsToldToStandNeither() {
        var escape = new EscapeWhenStuck(Scene.BODY);
        for (int update = 0; update < 100; update++) {
            Percept percept = Scene.open().at(Pose2d.ofDegrees(0, 0, update)).percept();
            assertThat(escape.act(percept, FAST)).isSameAs(FAST);
        }
        for (int update = 0; update < 100; update++) {
            assertThat(escape.act(Scene.open().percept(), Twist2d.STOP)).isSameAs(Twist2d.STOP);
        }
    }

    @Test
    void afterTwentyUpdatesInOnePlaceItBacksAndThenTurnsToWhereThereIsRoom() {
        var escape = new EscapeWhenStuck(Scene.BODY);
        Percept percept = Scene.open().wall(0, 0.25).wall(90, 0.4).percept();
        for (int update = 0; update < 20; update++) {
            assertThat(escape.act(percept, FAST)).isSameAs(FAST);
        }
        assertThat(escape.act(percept, FAST).vx()).isNegative();
        assertThat(escape.state()).isEqualTo("escaping");
        Twist2d last = Twist2d.STOP;
        for (int update = 0; update < 15; update++) {
            last = escape.act(percept, FAST);
        }
        assertThat(last.vx()).isZero();
        assertThat(last.omega()).isNegative(); // away from the wall on the left
    }

    private static Twist2d followed(Scene scene) {
        var follow = new FollowLeftWall(Scene.BODY, 0.4, 0.5);
        Twist2d twist = follow.act(scene.percept(), Twist2d.STOP);
        assertThat(follow.state()).isEqualTo("following");
        return twist;
    }
}
