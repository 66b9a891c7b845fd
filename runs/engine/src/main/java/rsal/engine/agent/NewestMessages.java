package rsal.engine.agent;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/// The newest messages of each agent, in words for people. All calls on the run's thread.
final class NewestMessages {
    /// How many of an agent are kept.
    static final int MOST = 5;

    private final Map<String, Sent> byAgent = new HashMap<>();

    private static final class Sent {
        private final Deque<String> words = new ArrayDeque<>(MOST + 1);
        private Duration at = Duration.ZERO;
    }

    /// An agent has sent a message.
    ///
    /// @param at since the run's start
    void sent(String agent, String words, Duration at) {
        Sent its = byAgent.computeIfAbsent(agent, _ -> new Sent());
        its.at = at;
        its.words.addLast(words);
        if (its.words.size() > MOST) {
            its.words.removeFirst();
        }
    }

    /// Oldest first.
    List<String> of(String agent) {
        return Optional.ofNullable(byAgent.get(agent))
                .map(its -> List.copyOf(its.words))
                .orElse(List.of());
    }

    /// When an agent sent its newest one, since the run's start; empty when it has sent none.
    Optional<Duration> newest(String agent) {
        return Optional.ofNullable(byAgent.get(agent)).map(its -> its.at);
    }
}
