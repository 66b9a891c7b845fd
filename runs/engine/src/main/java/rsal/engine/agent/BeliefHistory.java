package rsal.engine.agent;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import rsal.engine.event.NewestByName;
import rsal.engine.event.RunClock;
import rsal.engine.report.MindChange;
import rsal.engine.report.MindChange.Kind;
import rsal.engine.report.MindWords;
import rsal.engine.report.Words;

/// What agents did, believed and wanted lately, step by step, for people who look into them. What an agent does is
/// always noted. What it believes and wants is noted only while somebody looks into it, as that takes a look at each
/// step; which changes nothing of the run. All calls on the run's thread.
final class BeliefHistory {
    /// How many changes of one belief or goal are kept of an agent, and of what it does.
    static final int MOST_OF_A_NAME = 16;

    /// How many beliefs and goals: those that changed last.
    static final int MOST_NAMES = 64;

    /// How many agents are looked into at a time: those that somebody asked about last.
    static final int MOST_LOOKED_INTO = 16;

    /// For how long an agent is looked into after somebody has asked, in real time [ns].
    static final long PATIENCE = 3_000_000_000L;

    private static final int MOST_AGENTS = 4_000;

    private final RunClock clock;
    private final Map<String, NewestByName<MindChange>> byAgent = NewestByName.touchedLast(MOST_AGENTS);
    private final Map<String, Look> looks = NewestByName.touchedLast(MOST_LOOKED_INTO); // by agent

    /// @param at when somebody asked last, in real time [ns]
    private record Look(MindWords last, long at) {}

    BeliefHistory(RunClock clock) {
        this.clock = clock;
    }

    /// An agent does something else.
    void does(String agent, String words) {
        note(agent, new MindChange(clock.elapsed(), Kind.DOES, "", Words.clipped(words)));
    }

    /// Somebody looks into an agent.
    ///
    /// @param held what it believes and wants now
    /// @param now in real time [ns]
    void look(String agent, MindWords held, long now) {
        Look known = looks.get(agent);
        looks.put(agent, new Look(known == null ? held : known.last(), now));
    }

    /// Notes what is another than after the step before, of those that somebody looks into.
    ///
    /// @param held what an agent believes and wants now; empty when it can't tell
    void step(Function<String, Optional<MindWords>> held) {
        looks.replaceAll((agent, look) -> held.apply(agent)
                .map(now -> {
                    look.last().changesTo(now, clock.elapsed()).forEach(change -> note(agent, change));
                    return new Look(now, look.at());
                })
                .orElse(look));
    }

    private void note(String agent, MindChange change) {
        byAgent.computeIfAbsent(agent, _ -> new NewestByName<>(MOST_OF_A_NAME, MOST_NAMES))
                .add(change.kind() + " " + change.name(), change);
    }

    /// Looks no more into those that nobody asks about.
    ///
    /// @param now in real time [ns]
    void beat(long now) {
        looks.values().removeIf(look -> now - look.at() > PATIENCE);
    }

    /// What changed of an agent, oldest first.
    List<MindChange> of(String agent) {
        NewestByName<MindChange> changes = byAgent.get(agent);
        return changes == null ? List.of() : changes.all();
    }
}
