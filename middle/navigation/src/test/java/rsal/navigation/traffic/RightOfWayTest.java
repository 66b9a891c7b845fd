package rsal.navigation.traffic;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.navigation.passage.DrawnMaps;
import rsal.navigation.passage.Passages;

/// Points that drive as they are advised, over a radio that loses messages.
class RightOfWayTest {
    private static final Passages PASSAGES = DrawnMaps.passages(DrawnMaps.DOOR);
    private static final Point2d MIDDLE = new Point2d(4.3, 1.8);

    /// One robot, a point that drives to and fro at 0.4 m/s.
    private static final class Driver {
        final RightOfWay rule;
        final Point2d left;
        final Point2d right;
        Point2d place;
        boolean toRight;
        int crossings;

        Driver(LossyLinks radio, String robot, double y, boolean toRight) {
            this(radio, robot, y, toRight, Tickets::new);
        }

        Driver(LossyLinks radio, String robot, double y, boolean toRight, Agreement.Maker how) {
            this.rule = new RightOfWay(
                    new TrafficType.Participant(
                            robot,
                            DrawnMaps.BODY,
                            radio.link(robot),
                            () -> CompletableFuture.completedStage(PASSAGES),
                            Instant.EPOCH),
                    new RightOfWay.Settings(3.5, 3, Duration.ofSeconds(60)),
                    how);
            this.left = new Point2d(0.8, y);
            this.right = new Point2d(7.8, y);
            this.toRight = toRight;
            this.place = toRight ? left : right;
        }

        void step(Instant now) {
            Point2d goal = toRight ? right : left;
            var path = new ArrayList<Point2d>();
            path.add(place);
            if (toRight ? place.x() < MIDDLE.x() : place.x() > MIDDLE.x()) {
                path.add(MIDDLE);
            }
            path.add(goal);
            TrafficAdvice advice = rule.advise(now, new Pose2d(place.x(), place.y(), 0), () -> path);
            switch (advice) {
                case TrafficAdvice.Proceed() -> move(path.get(1));
                case TrafficAdvice.Halt() -> {}
                case TrafficAdvice.WaitAt(Point2d waiting, Point2d _) -> move(waiting);
            }
            if (place.distanceTo(goal) < 0.05) {
                toRight = !toRight;
                crossings++;
            }
        }

        private void move(Point2d to) {
            double distance = place.distanceTo(to);
            double share = distance < 0.04 ? 1 : 0.04 / distance;
            place = new Point2d(place.x() + share * (to.x() - place.x()), place.y() + share * (to.y() - place.y()));
        }

        boolean isInside() {
            return PASSAGES.index(place.x(), place.y()) >= 0;
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void nobodyMeetsAnybodyInADoorAndAllGetThrough(long seed) {
        assertThatNobodyMeets(seed, Tickets::new);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void nobodyMeetsAnybodyWhereOneRobotPlansForAll(long seed) {
        assertThatNobodyMeets(seed, CentralAgreement::new);
    }

    private static void assertThatNobodyMeets(long seed, Agreement.Maker how) {
        var drivers = drivers(new LossyLinks(seed, 0.05 * seed), how);
        for (int step = 0; step < 6000; step++) {
            Instant now = Instant.EPOCH.plusMillis(100L * step);
            drivers.forEach(driver -> driver.step(now));
            assertThat(meetings(drivers)).as("at %d, seed %d", step, seed).isZero();
        }
        assertThat(drivers).allSatisfy(driver -> assertThat(driver.crossings).isGreaterThan(10));
    }

    private static List<Driver> drivers(LossyLinks radio, Agreement.Maker how) {
        var drivers = new ArrayList<Driver>();
        for (int i = 0; i < 5; i++) {
            drivers.add(new Driver(radio, "r" + i, 0.8 + 0.5 * i, i % 2 == 0, how));
        }
        return drivers;
    }

    private static long meetings(List<Driver> drivers) {
        long right = drivers.stream().filter(d -> d.isInside() && d.toRight).count();
        long left = drivers.stream().filter(d -> d.isInside() && !d.toRight).count();
        return Math.min(left, right);
    }

    @Test
    void whereTheRobotThatPlansIsLostTheNextOneDoes() {
        var radio = new LossyLinks(1, 0.1);
        var drivers = drivers(radio, CentralAgreement::new);
        int step = 0;
        while (step < 600 || drivers.getFirst().isInside()) {
            Instant now = Instant.EPOCH.plusMillis(100L * step++);
            drivers.forEach(driver -> driver.step(now));
        }
        radio.silence("r0"); // which nobody misses in the door
        List<Driver> left = drivers.subList(1, drivers.size());
        List<Integer> before = left.stream().map(driver -> driver.crossings).toList();
        for (int end = step + 3000; step < end; step++) {
            Instant now = Instant.EPOCH.plusMillis(100L * step);
            left.forEach(driver -> driver.step(now));
            assertThat(meetings(left)).as("at %d", step).isZero();
        }
        for (int i = 0; i < left.size(); i++) {
            assertThat(left.get(i).crossings - before.get(i)).isGreaterThan(3);
        }
    }

    @Test
    void aRobotThatBreaksDownInADoorClosesIt() {
        var radio = new LossyLinks(1, 0);
        var one = new Driver(radio, "r1", 1.8, true);
        var other = new Driver(radio, "r2", 1.2, false);
        int step = 0;
        while (!one.isInside() && step < 600) {
            Instant now = Instant.EPOCH.plusMillis(100L * step++);
            one.step(now);
            other.step(now);
        }
        assertThat(one.isInside()).isTrue();
        radio.silence("r1"); // it is dead, and says nothing any more
        Instant broken = Instant.EPOCH.plusMillis(100L * step);
        for (int i = 0; i < 590; i++) {
            other.step(broken.plusMillis(100L * i));
        }
        assertThat(other.isInside()).isFalse();
        assertThat(other.rule.closed(broken.plusSeconds(30))).isEmpty();
        assertThat(other.rule.closed(broken.plusSeconds(65))).isNotEmpty();
        other.rule.stands(broken.plusSeconds(66), new Pose2d(MIDDLE.x(), MIDDLE.y(), 0));
        assertThat(other.rule.closed(broken.plusSeconds(66)))
                .as("it must be able to leave where it is")
                .isEmpty();
    }

    @Test
    void aRobotThatIsHeardButHearsNobodyKeepsNobodyOut() {
        var radio = new LossyLinks(1, 0);
        var one = new Driver(radio, "r1", 1.8, true);
        var deaf = new Driver(radio, "r2", 1.2, false);
        radio.silence("r2");
        for (int step = 0; step < 600; step++) {
            Instant now = Instant.EPOCH.plusMillis(100L * step);
            one.step(now);
            deaf.rule.stands(now, new Pose2d(deaf.place.x(), deaf.place.y(), 0));
        }
        assertThat(one.crossings).isPositive();
    }

    @Test
    void aRobotThatNobodyHearsDrivesAtOnce() {
        var radio = new LossyLinks(1, 0);
        var one = new Driver(radio, "r1", 1.8, true);
        for (int step = 0; step < 200; step++) {
            one.step(Instant.EPOCH.plusMillis(100L * step));
        }
        assertThat(one.crossings).isEqualTo(1);
        assertThat(radio.said()).isLessThanOrEqualTo(12);
    }
}
