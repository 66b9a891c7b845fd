package rsal.engine.communication;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.function.UnaryOperator;
import rsal.agent.Message;
import rsal.engine.report.Answer;
import rsal.engine.report.Link;

/// Which robots' agents hear each other, for people who look, now or later. What was heard lately is noted only while
/// somebody does: until nobody has for [#PATIENCE], in real time and in that of the run. Draws nothing at random, and
/// changes nothing of the run. All calls on the run's thread, or on that of an agent while it is that one's turn.
public final class Links {
    /// Of more robots, those of one are told: all would be half a million.
    static final int MOST_ROBOTS = 50;

    /// For how long something counts as said lately, in time of the run.
    static final Duration LATELY = Duration.ofSeconds(1);

    /// For how long it is noted after somebody has looked.
    static final Duration PATIENCE = Duration.ofSeconds(3);

    /// A fast team says more within [#LATELY] than can be seen.
    private static final int MOST_NOTED = 20_000;

    private final InstantSource clock;
    private final UnaryOperator<String> robotOf;
    private final LinkedHashMap<Pair, Instant> lately = new LinkedHashMap<>(); // the newest last
    private boolean noting;
    private long lookedAt; // [ns]
    private Instant lookedThen = Instant.MIN; // in time of the run

    /// From one robot to another.
    private record Pair(String from, String to) {}

    /// Who is asked how robots hear each other.
    ///
    /// @param sends whether what agents of one robot say would be heard by those of another, were they near;
    /// asked in both directions
    /// @param reaches whether they are near enough; the same in both directions, and slow to tell
    public record Air(BiPredicate<String, String> sends, BiPredicate<String, String> reaches) {}

    /// @param clock the run's
    /// @param robotOf the robot of an agent; empty when it has none
    public Links(InstantSource clock, UnaryOperator<String> robotOf) {
        this.clock = clock;
        this.robotOf = robotOf;
    }

    /// An agent hears a message.
    void heard(Message<?> message, String listener) {
        if (!noting) {
            return;
        }
        var pair = new Pair(robotOf.apply(message.sender()), robotOf.apply(listener));
        if (!pair.from().isEmpty() && !pair.to().isEmpty() && !pair.from().equals(pair.to())) {
            lately.putLast(pair, clock.instant());
            forget();
        }
    }

    private void forget() {
        Instant from = clock.instant().minus(LATELY);
        while (!lately.isEmpty()
                && (lately.size() > MOST_NOTED || lately.firstEntry().getValue().isBefore(from))) {
            lately.pollFirstEntry();
        }
    }

    /// Notes from now on what is heard.
    ///
    /// @param now in real time [ns]
    public void note(long now) {
        noting = true;
        lookedAt = now;
        lookedThen = clock.instant();
    }

    /// Stops noting what nobody looks at.
    ///
    /// @param now in real time [ns]
    public void beat(long now) {
        boolean patient =
                now - lookedAt <= PATIENCE.toNanos() || !clock.instant().isAfter(lookedThen.plus(PATIENCE));
        if (noting && !patient) {
            noting = false;
            lately.clear();
        }
    }

    /// Those of all robots, or, where these are too many, of one.
    ///
    /// @param robots ids of those that have agents
    /// @param chosen id of that one; maybe of none
    /// @param now in real time [ns]
    public Answer.Linked look(Set<String> robots, String chosen, Air air, long now) {
        boolean ofChosen = robots.size() > MOST_ROBOTS;
        if (ofChosen && !robots.contains(chosen)) {
            return new Answer.Linked(List.of(), true);
        }
        note(now);
        forget();
        var ids = List.copyOf(robots);
        var links = new ArrayList<Link>();
        if (ofChosen) {
            ids.stream()
                    .filter(other -> !other.equals(chosen))
                    .forEach(other -> link(chosen, other, air).ifPresent(links::add));
        } else {
            for (int i = 0; i < ids.size(); i++) {
                for (String other : ids.subList(i + 1, ids.size())) {
                    link(ids.get(i), other, air).ifPresent(links::add);
                }
            }
        }
        return new Answer.Linked(links, ofChosen);
    }

    private Optional<Link> link(String one, String other, Air air) {
        boolean sends = air.sends.test(one, other);
        boolean sendsBack = air.sends.test(other, one);
        boolean near = (sends || sendsBack) && air.reaches.test(one, other);
        var there = new Link.Way(sends && near, lately.containsKey(new Pair(one, other)));
        var back = new Link.Way(sendsBack && near, lately.containsKey(new Pair(other, one)));
        return there.isWorthTelling() || back.isWorthTelling()
                ? Optional.of(new Link(one, other, there, back))
                : Optional.empty();
    }
}
