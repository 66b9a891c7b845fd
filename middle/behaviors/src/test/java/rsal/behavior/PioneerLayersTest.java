package rsal.behavior;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
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
        var body = new BodyOutline(Scene.BODY);
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

    /// v = √(2 a s) with a = 0.4 m/s², s what is left before the stop distance; the body's front is 0.18 m ahead, and
    /// the margin beside it is 0.02 m. Time is looked at in steps of 0.05 s.
    @Test
    void itsSpeedIsThatFromWhichItCanStop() {
        var limit = new LimitSpeed(Scene.BODY, 1, 0.2);
        for (double wanted : new double[] {0.3, 0.6, 1}) {
            for (double wall = 0.45; wall < 2; wall += 0.1) {
                double speed = limit.act(Scene.open().wall(0, wall).percept(), Twist2d.drive(wanted, 0))
                        .vx();
                double way = wall - 0.18 - 0.02 - 0.2;
                double step = 0.05 * wanted; // that the way is known by
                double least = Math.min(wanted, Math.sqrt(2 * 0.4 * Math.max(0, way - 1.1 * step)));
                double most = Math.min(wanted, Math.sqrt(2 * 0.4 * (way + 1e-3)));
                assertThat(speed).as("%s m/s, %s m", wanted, wall).isBetween(least, most);
            }
        }
    }

    @Test
    void itIsSlowedDownSidewaysToo() {
        var limit = new LimitSpeed(Scene.BODY, 0.5, 0.2);
        Twist2d limited = limit.act(Scene.open().percept(), new Twist2d(0.6, 0.8, 0.3));
        assertThat(limited).isEqualTo(new Twist2d(0.3, 0.4, 0.3));
    }

    /// What is mirrored is avoided to the other side.
    @Test
    void avoidsToTheOtherSideWhatIsOnTheOtherSide() {
        var avoid = new AvoidCollision(Scene.BODY);
        for (double degrees = -60; degrees <= 60; degrees += 7.5) {
            for (double omega : new double[] {-0.5, -0.2, 0.2, 0.5}) {
                for (double distance : new double[] {0.3, 0.45, 0.6}) {
                    Twist2d one = avoid.act(
                            Scene.open().thing(degrees + 0.3, distance).percept(), Twist2d.drive(0.4, omega));
                    Twist2d mirrored = avoid.act(
                            Scene.open().thing(-degrees - 0.3, distance).percept(), Twist2d.drive(0.4, -omega));
                    assertThat(mirrored).isEqualTo(Twist2d.drive(one.vx(), 0.0 - one.omega()));
                }
            }
        }
    }

    private static double free(Scene scene, Twist2d twist, double margin, double horizon) {
        return new BodyOutline(Scene.BODY).timeToTouch(scene.percept().surroundings(), twist, margin, horizon);
    }

    private static Scene random(SplittableRandom random) {
        Scene scene = Scene.open();
        for (int i = 0; i < 4; i++) {
            scene.thing(random.nextDouble(-180, 180), random.nextDouble(0.27, 0.8));
        }
        return scene;
    }

    /// Of all speeds and turns the first that is free for a second, fast before slow, straight before turning.
    @Test
    void takesTheFirstFreeWayInOrder() {
        var random = new SplittableRandom(8);
        int turned = 0;
        for (int draw = 0; draw < 400; draw++) {
            Scene scene = random(random);
            Twist2d wanted = Twist2d.drive(0.4, random.nextDouble(-0.5, 0.5));
            double side = wanted.omega() < 0 ? -1 : 1;
            Twist2d expected = Twist2d.drive(0, side * 0.6);
            search:
            for (double speed : new double[] {1, 0.5, 0}) {
                for (double turn : new double[] {0, 0.3, -0.3, 0.6, -0.6, 1, -1}) {
                    Twist2d way = Twist2d.drive(0.4 * speed, wanted.omega() + side * turn);
                    if (!way.equals(Twist2d.STOP) && free(scene, way, 0.05, 1) >= 1) {
                        expected = way;
                        break search;
                    }
                }
            }
            turned += expected.equals(wanted) ? 0 : 1;
            assertThat(new AvoidCollision(Scene.BODY).act(scene.percept(), wanted))
                    .as("draw %d", draw)
                    .isEqualTo(expected);
        }
        assertThat(turned).isGreaterThan(50);
    }

    @Test
    void turnsWhereNothingIsFree() {
        Scene box = Scene.open().wall(0, 0.2).wall(90, 0.21).wall(-90, 0.21).wall(180, 0.28);
        assertThat(new AvoidCollision(Scene.BODY).act(box.percept(), Twist2d.drive(0.4, 0.1)))
                .isEqualTo(Twist2d.drive(0, 0.6));
        assertThat(new AvoidCollision(Scene.BODY).act(box.percept(), Twist2d.drive(0.4, -0.1)))
                .isEqualTo(Twist2d.drive(0, -0.6));
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
    void aRobotThatTurnsIsNotStuckAndOneThatIsAskedToStandNeither() {
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

    /// The wall is searched for again only after a meter of way.
    @Test
    void whoLostTheWallSearchesForAMeterBeforeAnotherBesideCounts() {
        var follow = new FollowLeftWall(Scene.BODY, 0.4, 0.5);
        follow.act(Scene.open().wall(90, 0.5).percept(), Twist2d.STOP);
        assertThat(follow.state()).isEqualTo("following");
        follow.act(Scene.open().at(new Pose2d(0, 0, 0)).percept(), Twist2d.STOP);
        assertThat(follow.state()).isEqualTo("searching");
        for (int i = 1; i <= 9; i++) {
            follow.act(Scene.open().wall(90, 0.7).at(new Pose2d(0.1 * i, 0, 0)).percept(), Twist2d.STOP);
            assertThat(follow.state()).as("after %d dm", i).isEqualTo("searching");
        }
        follow.act(Scene.open().wall(90, 0.7).at(new Pose2d(1.05, 0, 0)).percept(), Twist2d.STOP);
        assertThat(follow.state()).isEqualTo("following");
    }

    /// From half a meter more than its distance on a wall beside counts; it is lost a meter beyond that distance.
    @Test
    void aWallBesideCountsWhenItIsNearEnough() {
        for (double distance : new double[] {0.95, 1.05}) {
            var follow = new FollowLeftWall(Scene.BODY, 0.4, 0.5);
            follow.act(Scene.open().thing(90, distance).percept(), Twist2d.STOP);
            assertThat(follow.state()).isEqualTo(distance < 1 ? "following" : "searching");
        }
        for (double distance : new double[] {1.45, 1.55}) {
            var follow = new FollowLeftWall(Scene.BODY, 0.4, 0.5);
            follow.act(Scene.open().thing(90, 0.6).percept(), Twist2d.STOP);
            follow.act(Scene.open().thing(90, distance).percept(), Twist2d.STOP);
            assertThat(follow.state()).isEqualTo(distance < 1.5 ? "following" : "searching");
        }
    }

    /// Slower the more it has to turn, not at all from 60° on; it turns by 2 rad/s per rad, at most 1 rad/s.
    @Test
    void headsForTheFirstDirectionThatKeepsTheWallsDistance() {
        Scene wall = Scene.open().wall(90, 0.6); // 0.1 m too far: a bit to the left
        double clearance = 0;
        double heading = Math.toRadians(110);
        while (clearance < 0.5) {
            heading -= Math.toRadians(5);
            clearance = wall.percept().surroundings().clearance(heading, 0.8);
        }
        Twist2d twist = followed(wall);
        double expected = twist.omega() / 2;
        assertThat(expected).isBetween(heading - Math.toRadians(5), heading + Math.toRadians(5));
        assertThat(twist.vx()).isCloseTo(0.4 * (1 - expected / Math.toRadians(60)), within(1e-9));
    }

    /// It moves the way that can be held longest, first straight back.
    @Test
    void escapesToWhereThereIsRoom() {
        assertThat(escaped(Scene.open().wall(0, 0.25)).vx()).isEqualTo(-0.1);
        assertThat(escaped(Scene.open().wall(180, 0.27))).isEqualTo(Twist2d.drive(0.1, 0));
    }

    /// Of all ways the first of those that can be held longest, back before forward before turning.
    @Test
    void escapesTheWayThatCanBeHeldLongest() {
        var random = new SplittableRandom(9);
        for (int draw = 0; draw < 100; draw++) {
            Scene scene = random(random).wall(0, 0.3);
            Twist2d expected = Twist2d.STOP;
            double longest = 0;
            for (double speed : new double[] {-0.1, 0.1, 0}) {
                for (double turn : new double[] {0, 0.3, -0.3, 0.6, -0.6}) {
                    Twist2d way = Twist2d.drive(speed, turn);
                    double time = way.equals(Twist2d.STOP) ? 0 : free(scene, way, 0.01, 3);
                    if (time > longest) {
                        longest = time;
                        expected = way;
                    }
                }
            }
            assertThat(escaped(scene)).as("draw %d", draw).isEqualTo(expected);
        }
    }

    private static Twist2d escaped(Scene scene) {
        var escape = new EscapeWhenStuck(Scene.BODY);
        Twist2d last = FAST;
        for (int update = 0; update <= 20; update++) {
            last = escape.act(scene.percept(), FAST);
        }
        assertThat(escape.state()).isEqualTo("escaping");
        return last;
    }

    /// Of all directions, 10° apart, that with most room for the next 0.8 m; of several, that nearest to ahead.
    @Test
    void turnsToWhereThereIsMostRoom() {
        var random = new SplittableRandom(10);
        int turned = 0;
        for (int draw = 0; draw < 200; draw++) {
            Scene scene = random(random).wall(random.nextDouble(-180, 180), random.nextDouble(0.3, 0.7));
            Surroundings around = scene.percept().surroundings();
            double best = Math.PI;
            double widest = -1;
            for (int i = -18; i < 18; i++) {
                double heading = Math.toRadians(10.0 * i);
                double room = Math.min(2, around.clearance(heading, 0.8));
                if (room > widest + 1e-9 || (room > widest - 1e-9 && Math.abs(heading) < Math.abs(best))) {
                    widest = room;
                    best = heading;
                }
            }
            var escape = new EscapeWhenStuck(Scene.BODY);
            Twist2d last = FAST;
            for (int update = 0; update <= 20 + 15; update++) {
                last = escape.act(scene.percept(), FAST);
            }
            if (Math.abs(best) > Math.toRadians(11) && Math.abs(best) < Math.toRadians(175)) {
                assertThat(last).as("draw %d", draw).isEqualTo(Twist2d.drive(0, Math.copySign(0.6, best)));
                turned++;
            }
        }
        assertThat(turned).isGreaterThan(100);
    }

    /// Of all directions from the leftmost thing near it to behind, 5° apart, the first that keeps the wall's distance;
    /// else the widest of the first run that the robot fits through.
    @Test
    void headsForTheLeftmostWayThatIsWideEnough() {
        var random = new SplittableRandom(11);
        double room = Scene.BODY.circumscribedRadius() + 0.05;
        int draws = 0;
        for (int draw = 0; draw < 2000; draw++) {
            Scene scene = random(random).wall(random.nextDouble(-180, 180), random.nextDouble(0.3, 1));
            Surroundings around = scene.percept().surroundings();
            var follow = new FollowLeftWall(Scene.BODY, 0.4, 0.5);
            Twist2d twist = follow.act(scene.percept(), Twist2d.STOP);
            if (follow.state().equals("following")) {
                double heading = leftmost(around, room);
                assertThat(twist.omega()).as("draw %d", draw).isCloseTo(Math.clamp(2 * heading, -1, 1), within(1e-6));
                draws++;
            }
        }
        assertThat(draws).isGreaterThan(500);
    }

    private static double leftmost(Surroundings around, double room) {
        double start = Math.toRadians(110);
        for (double bearing = Math.toRadians(150); bearing > Math.toRadians(-90); bearing -= Surroundings.WIDTH) {
            if (around.range(Surroundings.sector(bearing)) <= 1.5) {
                start = Math.min(start, bearing);
                break;
            }
        }
        double best = Math.toRadians(-180);
        double widest = 0;
        boolean fits = false;
        for (double heading = start; heading >= Math.toRadians(-180); heading -= Math.toRadians(5)) {
            double clearance = around.clearance(heading, 0.8);
            if (clearance >= 0.5) {
                return heading;
            }
            if (clearance < room && fits) {
                return best;
            }
            fits |= clearance >= room;
            if (clearance > widest) {
                widest = clearance;
                best = heading;
            }
        }
        return best;
    }

    /// Then it turns to where there is most room, within 10°, and goes on.
    @Test
    void turnsToTheWayOutAndGoesOn() {
        var escape = new EscapeWhenStuck(Scene.BODY);
        Scene around = Scene.open().wall(0, 0.3).wall(180, 0.3).wall(90, 0.4); // open to the right
        for (int update = 0; update < 20 + 15; update++) {
            escape.act(around.percept(), FAST);
        }
        assertThat(escape.act(around.percept(), FAST)).isEqualTo(Twist2d.drive(0, -0.6));
        Percept halfway = around.at(Pose2d.ofDegrees(0, 0, -60)).percept();
        assertThat(escape.act(halfway, FAST)).isEqualTo(Twist2d.drive(0, -0.6));
        Percept there = around.at(Pose2d.ofDegrees(0, 0, -85)).percept();
        assertThat(escape.act(there, FAST)).isEqualTo(FAST);
        assertThat(escape.state()).isEmpty();
    }

    /// It has moved 0.1 m, or turned by 10°, within two seconds.
    @Test
    void whoMovesABitMoreThanNothingIsNotStuck() {
        for (double way : new double[] {0.09, 0.11}) {
            var escape = new EscapeWhenStuck(Scene.BODY);
            for (int update = 0; update <= 20; update++) {
                escape.act(Scene.open().at(new Pose2d(way * update / 20, 0, 0)).percept(), FAST);
            }
            assertThat(escape.state()).isEqualTo(way < 0.1 ? "escaping" : "");
        }
    }

    private static Twist2d followed(Scene scene) {
        var follow = new FollowLeftWall(Scene.BODY, 0.4, 0.5);
        Twist2d twist = follow.act(scene.percept(), Twist2d.STOP);
        assertThat(follow.state()).isEqualTo("following");
        return twist;
    }
}
