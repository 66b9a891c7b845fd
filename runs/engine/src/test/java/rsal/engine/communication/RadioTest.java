package rsal.engine.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.agent.Message;
import rsal.agent.message.Text;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Walls;
import rsal.engine.report.LossReason;
import rsal.scenario.Communication;
import rsal.scenario.fault.Span;

class RadioTest {
    private static final Communication UNLIMITED = new Communication(
            Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, 0, Span.of(0, 0), Optional.empty(), 5);
    private static final int MANY = 20_000;

    private final Map<String, Point2d> places = new HashMap<>(); // of robots, by id
    private int asked;

    /// Robots are called by the first letter of their agents; agents in upper case have none.
    private Radio radio(Communication limits) {
        return new Radio(
                limits, wall(), agent -> Character.isUpperCase(agent.charAt(0)) ? "" : agent.substring(0, 1), robot -> {
                    asked++;
                    return Optional.ofNullable(places.get(robot));
                });
    }

    /// 10 m by 10 m with a wall of 1 m from x = 5 m on, but for its uppermost meter.
    private static OccupancyGrid wall() {
        byte[] cells = new byte[100];
        for (int row = 0; row < 9; row++) {
            cells[row * 10 + 5] = OccupancyGrid.OCCUPIED;
        }
        return new OccupancyGrid(10, 10, 1, 0, 0, cells);
    }

    private static Communication reaching(double range, double behindWalls) {
        return new Communication(range, behindWalls, 0, Span.of(0, 0), Optional.empty(), 5);
    }

    private static Message<Text> from(String sender, Instant time) {
        return new Message<>(Text.TOPIC, sender, "", time, new Text("hi"));
    }

    private static List<Duration> copies(Radio radio) {
        return radio.copies(from("amy", Instant.EPOCH), "bob");
    }

    @Test
    void withoutLimitsAllIsHeardAtOnce() {
        places.put("a", new Point2d(-1000, 0));
        places.put("b", new Point2d(1000, 0));
        assertThat(copies(radio(UNLIMITED))).containsExactly(Duration.ZERO);
        assertThat(asked).isZero();
    }

    /// A message waits until what its sender said before is sent, and is late by the delay besides.
    @Test
    void whatWaitsForBandwidthIsDelayedBesides() {
        Radio radio = radio(new Communication(
                Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, 0, Span.of(0.25, 0.25), Optional.of(2.0), 5));
        for (int said = 0; said < 3; said++) { // two a second
            assertThat(copies(radio)).containsExactly(Duration.ofMillis(500L * said + 250));
        }
    }

    @Test
    void rangeIsShorterBehindWalls() {
        Radio radio = radio(reaching(6, 3));
        var random = new SplittableRandom(8);
        var walls = new Walls(wall());
        int through = 0;
        int far = 0;
        for (int i = 0; i < MANY; i++) {
            var one = new Point2d(random.nextDouble(10), random.nextDouble(10));
            var other = new Point2d(random.nextDouble(10), random.nextDouble(10));
            places.put("a", one);
            places.put("b", other);
            double range = walls.standBetween(one, other) ? 3 : 6;
            boolean hears = Math.sqrt(square(one.x() - other.x()) + square(one.y() - other.y())) <= range;
            Instant now = Instant.ofEpochSecond(i);
            assertThat(radio.copies(from("amy", now), "bob")).hasSize(hears ? 1 : 0);
            assertThat(radio.copies(from("bob", now), "amy")).hasSize(hears ? 1 : 0);
            through += hears && range == 3 ? 1 : 0;
            far += hears && one.distanceTo(other) > 3 ? 1 : 0;
        }
        assertThat(through).isPositive();
        assertThat(far).isPositive();
    }

    private static double square(double x) {
        return x * x;
    }

    @Test
    void eachRobotIsLookedForOnceAtAnInstant() {
        Radio radio = radio(reaching(6, 3));
        for (String robot : List.of("a", "b", "c")) {
            places.put(robot, new Point2d(1, 1));
        }
        for (int i = 0; i < 3; i++) {
            for (String sender : List.of("amy", "bob", "cat")) {
                for (String listener : List.of("amy", "bob", "cat")) {
                    radio.copies(from(sender, Instant.EPOCH), listener);
                }
            }
        }
        assertThat(asked).isEqualTo(3);
        radio.copies(from("amy", Instant.ofEpochSecond(1)), "bob");
        assertThat(asked).isEqualTo(5);
    }

    @Test
    void agentsOfOneRobotAndThoseWithoutNeedNoRadio() {
        Radio radio = radio(new Communication(0, 0, 1, Span.of(1, 1), Optional.of(0.01), 5));
        places.put("a", new Point2d(1, 1));
        places.put("b", new Point2d(2, 1));
        for (int i = 0; i < 10; i++) {
            assertThat(radio.copies(from("amy", Instant.EPOCH), "ann")).containsExactly(Duration.ZERO);
            assertThat(radio.copies(from("Base", Instant.EPOCH), "Master")).containsExactly(Duration.ZERO);
            assertThat(radio.copies(from("amy", Instant.EPOCH), "bob")).isEmpty();
        }
    }

    @Test
    void agentsWithoutRobotAndRobotsNobodyKnowsWhereAreInRange() {
        Radio radio = radio(reaching(1, 1));
        places.put("a", new Point2d(1, 1));
        places.put("b", new Point2d(9, 9));
        assertThat(copies(radio)).isEmpty();
        assertThat(radio.copies(from("amy", Instant.EPOCH), "Base")).hasSize(1);
        assertThat(radio.copies(from("Base", Instant.EPOCH), "bob")).hasSize(1);
        assertThat(radio.copies(from("amy", Instant.EPOCH), "zoe")).hasSize(1);
    }

    @Test
    void asManyAreLostAsWereAskedFor() {
        Radio radio = radio(new Communication(9, 9, 0.05, Span.of(0, 0), Optional.empty(), 5));
        int heard = 0;
        for (int i = 0; i < MANY; i++) {
            heard += copies(radio).size();
        }
        assertThat((double) heard).isCloseTo(0.95 * MANY, within(4 * Math.sqrt(MANY * 0.05 * 0.95)));
    }

    @Test
    void allTakeAsLongAsTheyShould() {
        Radio radio = radio(new Communication(9, 9, 0, Span.of(0.5, 1.5), Optional.empty(), 5));
        double sum = 0;
        for (int i = 0; i < MANY; i++) {
            double late = copies(radio).getFirst().toNanos() / 1e9;
            assertThat(late).isBetween(0.5, 1.5);
            sum += late;
        }
        assertThat(sum / MANY).isCloseTo(1, within(4 / Math.sqrt(12.0 * MANY)));
    }

    @Test
    void whatIsSaidTooFastWaitsForItsTurn() {
        for (int seed = 0; seed < 50; seed++) {
            var random = new SplittableRandom(seed);
            int bandwidth = random.nextInt(1, 30);
            Radio radio = radio(new Communication(9, 9, 0, Span.of(0, 0), Optional.of((double) bandwidth), 5));
            long[] free = {0, 0}; // when all was sent that each had said so far [ns]
            long now = 0;
            int lost = 0;
            for (int i = 0; i < 500; i++) {
                now += random.nextInt(3) == 0 ? 0 : random.nextLong(2_000_000_000L / bandwidth);
                int who = random.nextInt(2);
                Message<Text> message = from(who == 0 ? "amy" : "bob", Instant.EPOCH.plusNanos(now));
                List<Duration> expected = List.of();
                if (free[who] <= now + 1_000_000_000L) {
                    expected = List.of(Duration.ofNanos(Math.max(free[who] - now, 0)));
                    free[who] = Math.max(free[who], now) + Math.round(1e9 / bandwidth);
                } else {
                    lost++;
                }
                assertThat(radio.copies(message, "zoe")).isEqualTo(expected);
                assertThat(radio.copies(message, "cat")).isEqualTo(expected);
            }
            assertThat(lost).isLessThan(500);
        }
    }

    @Test
    void aBurstLeavesMessageByMessageAndItsEndIsLost() {
        Radio radio = radio(new Communication(9, 9, 0, Span.of(0, 0), Optional.of(4.0), 5));
        var waits = new ArrayList<Long>();
        for (int i = 0; i < 8; i++) {
            radio.copies(from("amy", Instant.EPOCH), "bob").forEach(late -> waits.add(late.toMillis()));
        }
        assertThat(waits).containsExactly(0L, 250L, 500L, 750L, 1000L);
        assertThat(radio.copies(from("amy", Instant.ofEpochSecond(9)), "bob")).containsExactly(Duration.ZERO);
    }

    @Test
    void saysWhyAMessageWasLost() {
        places.put("a", new Point2d(1, 1));
        places.put("b", new Point2d(4, 1));
        Radio far = radio(reaching(2, 1));
        assertThat(copies(far)).isEmpty();
        assertThat(far.why()).isEqualTo(LossReason.RANGE);
        Radio noisy = radio(new Communication(6, 3, 1, Span.of(0, 0), Optional.empty(), 5));
        assertThat(copies(noisy)).isEmpty();
        assertThat(noisy.why()).isEqualTo(LossReason.CHANCE);
        Radio slow = radio(new Communication(6, 3, 0, Span.of(0, 0), Optional.of(0.5), 5));
        assertThat(copies(slow)).containsExactly(Duration.ZERO);
        assertThat(copies(slow)).isEmpty();
        assertThat(slow.why()).isEqualTo(LossReason.BANDWIDTH);
    }

    /// Bounds of ranges belong to them: 3 m are within 3 m, with a wall between and without.
    @Test
    void whoIsAsFarAwayAsTheRangeIsInRange() {
        places.put("a", new Point2d(1, 1));
        places.put("b", new Point2d(4, 1));
        assertThat(copies(radio(reaching(3, 1)))).containsExactly(Duration.ZERO);
        assertThat(copies(radio(reaching(2.999, 1)))).isEmpty();
        places.put("a", new Point2d(4, 1));
        places.put("b", new Point2d(7, 1)); // behind the wall
        assertThat(copies(radio(reaching(6, 3)))).containsExactly(Duration.ZERO);
        assertThat(copies(radio(reaching(6, 2.999)))).isEmpty();
    }

    @Test
    void withoutLossDelaysTakeTheFirstNumbersOfTheStream() {
        Span delay = Span.of(0.1, 0.9);
        Radio radio = radio(
                new Communication(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, 0, delay, Optional.empty(), 5));
        var stream = new SplittableRandom(5);
        for (int i = 0; i < 5; i++) {
            assertThat(copies(radio)).containsExactly(delay.draw(stream));
        }
    }

    @Test
    void lossAndDelayTakeTheirNumbersInTurn() {
        Span delay = Span.of(0.1, 0.9);
        Radio radio = radio(
                new Communication(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, 0.5, delay, Optional.empty(), 5));
        var stream = new SplittableRandom(5);
        for (int i = 0; i < 20; i++) {
            boolean lost = stream.nextDouble() < 0.5;
            assertThat(copies(radio)).isEqualTo(lost ? List.of() : List.of(delay.draw(stream)));
        }
    }

    /// What is between two robots is looked at once, for messages both ways.
    @Test
    void wallsStandInTheWayOfBoth() {
        places.put("a", new Point2d(4, 1));
        places.put("b", new Point2d(7, 1));
        Radio radio = radio(reaching(6, 2));
        assertThat(radio.copies(from("amy", Instant.EPOCH), "bob")).isEmpty();
        assertThat(radio.copies(from("bob", Instant.EPOCH), "amy")).isEmpty();
        places.put("b", new Point2d(3, 1)); // has moved, and is seen at the next instant only
        assertThat(radio.copies(from("bob", Instant.EPOCH), "amy")).isEmpty();
        assertThat(radio.copies(from("bob", Instant.EPOCH.plusMillis(100)), "amy"))
                .containsExactly(Duration.ZERO);
    }

    @Test
    void sendsWhatCanLeaveWithinASecond() {
        Radio radio = radio(new Communication(6, 3, 0.9, Span.of(0, 0), Optional.of(1.0), 5));
        assertThat(radio.sends("amy", Instant.EPOCH)).as("it said nothing yet").isTrue();
        copies(radio);
        assertThat(radio.sends("amy", Instant.EPOCH)).as("it waits for 1 s").isTrue();
        copies(radio);
        assertThat(radio.sends("amy", Instant.EPOCH))
                .as("it would wait for 2 s")
                .isFalse();
        assertThat(radio.sends("amy", Instant.EPOCH.plusMillis(999))).isFalse();
        assertThat(radio.sends("amy", Instant.EPOCH.plusMillis(1000))).isTrue();
        assertThat(radio.sends("bob", Instant.EPOCH))
                .as("it has a radio of its own")
                .isTrue();
        Radio dead = radio(new Communication(6, 3, 1, Span.of(0, 0), Optional.empty(), 5));
        assertThat(dead.sends("amy", Instant.EPOCH)).as("all is lost").isFalse();
    }

    @Test
    void reachesAsFarAsMessagesDoAndRemembersNothing() {
        Radio radio = radio(reaching(6, 2));
        Optional<Point2d> here = Optional.of(new Point2d(4, 1));
        Optional<Point2d> behind = Optional.of(new Point2d(7, 1));
        assertThat(radio.reaches(here, behind)).isFalse();
        assertThat(radio.reaches(here, Optional.of(new Point2d(1, 1)))).isTrue();
        assertThat(radio.reaches(Optional.of(new Point2d(4, 9.5)), Optional.of(new Point2d(7, 9.5))))
                .as("past the wall's end")
                .isTrue();
        assertThat(radio.reaches(Optional.empty(), behind)).isTrue();
        assertThat(radio.reaches(here, Optional.empty())).isTrue();
        assertThat(radio.reaches(here, Optional.of(new Point2d(4, -6)))).isFalse();
        assertThat(asked).isZero();
    }
}
