package rsal.engine.communication;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import rsal.agent.ChannelModel;
import rsal.agent.Message;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Walls;
import rsal.engine.report.LossReason;
import rsal.scenario.Communication;
import rsal.scenario.fault.Span;

/// Carries messages between robots as far as their radio reaches.
///
/// Agents of one robot need none, and neither do those without a robot among themselves: they hear each other at once.
/// An agent without a robot is in range of all, like a base station with antennas everywhere; so is a robot of which
/// nobody knows where it is. Who is in range is decided when a message is said. What an agent says faster than the
/// bandwidth allows waits for its turn. All calls on the run's thread.
public final class Radio implements ChannelModel {
    /// How long a message waits for its turn before it is dropped.
    static final Duration PATIENCE = Duration.ofSeconds(1);

    private final Communication limits;
    private final Walls walls;
    private final UnaryOperator<String> robotOf;
    private final Function<String, Optional<Point2d>> placeOf;
    private final SplittableRandom random;
    private final Map<String, Instant> free = new HashMap<>(); // when the radio of an agent is, by its name
    private final Map<String, Optional<Point2d>> places = new HashMap<>(); // of robots at an instant
    private final Map<Pair, Boolean> sights = new HashMap<>(); // whether no wall is between, at that instant
    private Instant instant = Instant.MIN;
    private @Nullable Message<?> newest;
    private Optional<Duration> turn = Optional.empty(); // how long the newest waits for it
    private LossReason why = LossReason.CHANCE;

    private record Pair(String one, String other) {
        static Pair of(String one, String other) {
            return one.compareTo(other) <= 0 ? new Pair(one, other) : new Pair(other, one);
        }
    }

    /// @param robotOf the robot of an agent; empty when it has none
    /// @param placeOf where a robot is, in the map frame
    public Radio(
            Communication limits,
            OccupancyGrid map,
            UnaryOperator<String> robotOf,
            Function<String, Optional<Point2d>> placeOf) {
        this.limits = limits;
        this.walls = new Walls(map);
        this.robotOf = robotOf;
        this.placeOf = placeOf;
        this.random = new SplittableRandom(limits.seed());
    }

    @Override
    public List<Duration> copies(Message<?> message, String listener) {
        String from = robotOf.apply(message.sender());
        String to = robotOf.apply(listener);
        if (from.equals(to)) {
            return AT_ONCE;
        }
        Optional<Duration> waits = turn(message);
        if (waits.isEmpty()) {
            return lost(LossReason.BANDWIDTH);
        }
        if (!isInRange(from, to, message.time())) {
            return lost(LossReason.RANGE);
        }
        if (isLost()) {
            return lost(LossReason.CHANCE);
        }
        Span delay = limits.delay();
        Duration late = delay.most().isZero() ? waits.get() : waits.get().plus(delay.draw(random));
        return late.isZero() ? AT_ONCE : List.of(late);
    }

    private List<Duration> lost(LossReason cause) {
        why = cause;
        return List.of();
    }

    /// Why the message was lost that was lost last.
    public LossReason why() {
        return why;
    }

    private boolean isLost() {
        return limits.loss() > 0 && random.nextDouble() < limits.loss();
    }

    /// Whether what an agent says now would be sent in time, and reach somebody who is in range, but for chance.
    /// Remembers nothing, so that who looks changes nothing.
    public boolean sends(String agent, Instant now) {
        Instant ready = free.getOrDefault(agent, now);
        return limits.loss() < 1 && Duration.between(now, ready).compareTo(PATIENCE) <= 0;
    }

    /// Whether robots are in range of each other; empty where nobody knows where one is. Remembers nothing, either.
    public boolean reaches(Optional<Point2d> one, Optional<Point2d> other) {
        return one.isEmpty()
                || other.isEmpty()
                || isNear(one.get(), other.get(), () -> !walls.standBetween(one.get(), other.get()));
    }

    /// @param sight whether no wall is between them; takes a while
    private boolean isNear(Point2d one, Point2d other, BooleanSupplier sight) {
        double distance = one.distanceTo(other);
        return distance <= limits.behindWalls() || (distance <= limits.range() && sight.getAsBoolean());
    }

    /// How long a message waits until its sender has sent what it said before; empty when that is too long. The same
    /// for all who listen, who are asked for one after the other.
    @SuppressWarnings("ReferenceEquality") // two may say the same
    private Optional<Duration> turn(Message<?> message) {
        if (limits.bandwidth().isEmpty()) {
            return Optional.of(Duration.ZERO);
        }
        if (message != newest) {
            newest = message;
            turn = queue(message, limits.bandwidth().get());
        }
        return turn;
    }

    private Optional<Duration> queue(Message<?> message, double bandwidth) {
        Instant now = message.time();
        Instant ready = free.getOrDefault(message.sender(), now);
        Instant leaves = ready.isAfter(now) ? ready : now;
        Duration waits = Duration.between(now, leaves);
        if (waits.compareTo(PATIENCE) > 0) {
            return Optional.empty();
        }
        free.put(message.sender(), leaves.plusNanos(Math.round(1e9 / bandwidth)));
        return Optional.of(waits);
    }

    private boolean isInRange(String from, String to, Instant now) {
        if (from.isEmpty() || to.isEmpty() || limits.behindWalls() == Double.POSITIVE_INFINITY) {
            return true;
        }
        if (!now.equals(instant)) {
            instant = now;
            places.clear();
            sights.clear();
        }
        Optional<Point2d> one = places.computeIfAbsent(from, placeOf);
        Optional<Point2d> other = places.computeIfAbsent(to, placeOf);
        if (one.isEmpty() || other.isEmpty()) {
            return true;
        }
        return isNear(
                one.get(),
                other.get(),
                () -> sights.computeIfAbsent(Pair.of(from, to), _ -> !walls.standBetween(one.get(), other.get())));
    }
}
