package rsal.engine;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import rsal.agent.bdi.Mind;
import rsal.engine.MindChange.Kind;

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

    private final InstantSource clock;
    private final Instant began;
    private final Map<String, NewestByName<MindChange>> byAgent = NewestByName.touchedLast(MOST_AGENTS);
    private final Map<String, Look> looks = NewestByName.touchedLast(MOST_LOOKED_INTO); // by agent

    /// What an agent believes and wants, in words by name.
    record Held(Map<String, String> beliefs, Map<String, String> goals) {
        /// @param beliefs as it shows them
        /// @param goals several of a name are one, as a plan may want the same twice
        static Held of(Map<String, String> beliefs, List<Mind.GoalView> goals) {
            var wanted = new LinkedHashMap<String, String>();
            goals.forEach(goal -> wanted.merge(goal.name(), words(goal), (one, more) -> one + "; " + more));
            return new Held(beliefs, wanted);
        }

        private static String words(Mind.GoalView goal) {
            String state = goal.state().name().toLowerCase(Locale.ROOT).replace('_', ' ');
            String steps = goal.steps().isEmpty() ? "" : ": " + String.join(" > ", goal.steps());
            return state + steps;
        }
    }

    /// @param at when somebody asked last, in real time [ns]
    private record Look(Held last, long at) {}

    /// @param clock the run's, which begins now
    BeliefHistory(InstantSource clock) {
        this.clock = clock;
        this.began = clock.instant();
    }

    /// An agent does something else.
    void does(String agent, String words) {
        note(agent, new MindChange(time(), Kind.DOES, "", Words.clipped(words)));
    }

    /// Somebody looks into an agent.
    ///
    /// @param held what it believes and wants now
    /// @param now in real time [ns]
    void look(String agent, Held held, long now) {
        Look known = looks.get(agent);
        looks.put(agent, new Look(known == null ? held : known.last(), now));
    }

    /// Notes what is another than after the step before, of those that somebody looks into.
    ///
    /// @param held what an agent believes and wants now; empty when it can't tell
    void step(Function<String, Optional<Held>> held) {
        looks.replaceAll((agent, look) -> held.apply(agent)
                .map(now -> {
                    changes(look.last(), now, time()).forEach(change -> note(agent, change));
                    return new Look(now, look.at());
                })
                .orElse(look));
    }

    /// What is another one now.
    static List<MindChange> changes(Held before, Held now, Duration time) {
        var changes = new ArrayList<MindChange>();
        change(changes, Kind.BELIEVES, before.beliefs(), now.beliefs(), time);
        change(changes, Kind.WANTS, before.goals(), now.goals(), time);
        return changes;
    }

    private static void change(
            List<MindChange> changes, Kind kind, Map<String, String> before, Map<String, String> now, Duration time) {
        now.forEach((name, words) -> {
            if (!words.equals(before.get(name))) {
                changes.add(new MindChange(time, kind, name, Words.clipped(words)));
            }
        });
        before.keySet().stream()
                .filter(name -> !now.containsKey(name))
                .forEach(name -> changes.add(new MindChange(time, kind, name, "")));
    }

    private Duration time() {
        return Duration.between(began, clock.instant());
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
