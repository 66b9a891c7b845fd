package rsal.scenario.run;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import rsal.agent.Message;

/// Which robots' agents hear each other, for people who look. What was heard lately is noted only while somebody does:
/// until nobody has for [#PATIENCE], in real time and in that of the run.
/// Draws nothing at random, and changes nothing of the run. All calls on the run's thread, or on that of an agent while
/// it is that one's turn.
final class Links {
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
    private boolean looked;
    private long lookedAt; // [ns]
    private Instant lookedThen = Instant.MIN; // in time of the run
    private Instant second = Instant.MIN; // of the run, in which they were looked for last
    private List<Link> inSecond = List.of();

    /// From one robot to another.
    private record Pair(String from, String to) {}

    /// @param clock the run's
    /// @param robotOf the robot of an agent; empty when it has none
    Links(InstantSource clock, UnaryOperator<String> robotOf) {
        this.clock = clock;
        this.robotOf = robotOf;
    }

    /// An agent hears a message.
    void heard(Message<?> message, String listener) {
        if (!looked) {
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

    /// Stops noting what nobody looks at.
    ///
    /// @param now [ns]
    void beat(long now) {
        if (looked && now - lookedAt > PATIENCE.toNanos() && clock.instant().isAfter(lookedThen.plus(PATIENCE))) {
            looked = false;
            lately.clear();
        }
    }

    /// Looked for once in each second of the run, however often that is asked.
    List<Link> inThisSecond(Supplier<Answer.Linked> look) {
        Instant now = clock.instant().truncatedTo(ChronoUnit.SECONDS);
        if (!now.equals(second)) {
            second = now;
            inSecond = look.get().links();
        }
        return inSecond;
    }

    /// Those of all robots, or, where these are too many, of one.
    ///
    /// @param robots ids of those that have agents
    /// @param chosen id of that one; maybe of none
    /// @param hears whether what agents of one robot say is heard by those of another; asked in both directions
    /// @param now in real time [ns]
    Answer.Linked look(Set<String> robots, String chosen, BiPredicate<String, String> hears, long now) {
        looked = true;
        lookedAt = now;
        lookedThen = clock.instant();
        forget();
        var ids = List.copyOf(robots);
        boolean ofChosen = ids.size() > MOST_ROBOTS;
        var links = new ArrayList<Link>();
        if (ofChosen) {
            ids.stream()
                    .filter(other -> robots.contains(chosen) && !other.equals(chosen))
                    .forEach(other -> link(chosen, other, hears).ifPresent(links::add));
        } else {
            for (int i = 0; i < ids.size(); i++) {
                for (String other : ids.subList(i + 1, ids.size())) {
                    link(ids.get(i), other, hears).ifPresent(links::add);
                }
            }
        }
        return new Answer.Linked(links, ofChosen);
    }

    private Optional<Link> link(String one, String other, BiPredicate<String, String> hears) {
        var there = new Link.Way(hears.test(one, other), lately.containsKey(new Pair(one, other)));
        var back = new Link.Way(hears.test(other, one), lately.containsKey(new Pair(other, one)));
        return there.isWorthTelling() || back.isWorthTelling()
                ? Optional.of(new Link(one, other, there, back))
                : Optional.empty();
    }
}
