package rsal.agent;

import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;

/// Which agents are at work, for those on other threads who look whether one never returns. The same agent that is in
/// the same turn whenever somebody looks has not returned meanwhile.
///
/// May be asked on any thread.
public final class Turns {
    private final Map<String, Turn> byAgent = new ConcurrentHashMap<>();

    Turn of(String agent) {
        return byAgent.computeIfAbsent(agent, _ -> new Turn());
    }

    /// The turns of those whose code runs now, by agent.
    public Map<String, Long> underWay() {
        var numbers = new TreeMap<String, Long>();
        byAgent.forEach((agent, turn) -> {
            long count = turn.count.get();
            if (count % 2 == 1) {
                numbers.put(agent, count);
            }
        });
        return numbers;
    }

    /// One agent's. Written by its lane alone.
    static final class Turn {
        private final AtomicLong count = new AtomicLong(); // odd while code of the agent runs

        /// @return whether it was not its turn already
        boolean begin() {
            long before = count.getPlain();
            boolean begins = before % 2 == 0;
            if (begins) {
                count.lazySet(before + 1);
            }
            return begins;
        }

        void end() {
            count.lazySet(count.getPlain() + 1);
        }
    }
}
