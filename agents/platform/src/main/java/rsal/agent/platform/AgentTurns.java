package rsal.agent.platform;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;
import rsal.agent.OutsideCode;

/// Which agents are at work, for those on other threads who look whether one never returns. The same agent that is in
/// the same turn whenever somebody looks has not returned meanwhile.
///
/// May be asked on any thread.
public final class AgentTurns {
    private final Map<String, Turn> byAgent = new ConcurrentHashMap<>();

    Turn of(String agent) {
        return byAgent.computeIfAbsent(agent, _ -> new Turn());
    }

    /// The turns of those whose code runs now, by agent.
    public Map<String, Long> inProgress() {
        var numbers = new TreeMap<String, Long>();
        byAgent.forEach((agent, turn) -> {
            long count = turn.count.get();
            if (count % 2 == 1) {
                numbers.put(agent, count);
            }
        });
        return numbers;
    }

    /// On which thread an agent's code runs, or ran last; empty when none ever did.
    public Optional<Thread> thread(String agent) {
        return Optional.ofNullable(byAgent.get(agent)).map(turn -> turn.thread);
    }

    /// An agent's code in another process; empty for one that has none.
    public Optional<OutsideCode> outside(String agent) {
        return Optional.ofNullable(byAgent.get(agent)).map(turn -> turn.outside);
    }

    /// One agent's. Written by its lane alone.
    static final class Turn {
        private final AtomicLong count = new AtomicLong(); // odd while code of the agent runs
        private volatile @Nullable Thread thread; // seldom another than before; to write it each time would cost
        private volatile @Nullable OutsideCode outside;

        void outside(OutsideCode code) {
            outside = code;
        }

        /// @return whether it was not its turn already
        boolean begin() {
            if (!isHere()) {
                thread = Thread.currentThread();
            }
            long before = count.getPlain();
            boolean begins = before % 2 == 0;
            if (begins) {
                count.lazySet(before + 1);
            }
            return begins;
        }

        /// Whether this is the thread on which the agent's code runs, or ran last.
        boolean isHere() {
            return Thread.currentThread().equals(thread);
        }

        void end() {
            count.lazySet(count.getPlain() + 1);
        }
    }
}
