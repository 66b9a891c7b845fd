package rsal.engine.event;

import java.util.LinkedHashMap;
import java.util.Map;
import rsal.agent.protocol.Act;

/// What agents have said to each other, as far as it takes to know what they only say again.
public final class Conversations {
    private static final int MOST = 10_000;

    private final Map<Line, Integer> newest = new LinkedHashMap<>(16, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<Line, Integer> eldest) {
            return size() > MOST;
        }
    };

    /// Whether this is said for the first time.
    public boolean isNew(String sender, String to, Act act) {
        var line = new Line(act.conversation(), sender, to);
        if (act.number() <= newest.getOrDefault(line, 0)) {
            return false;
        }
        newest.put(line, act.number());
        return true;
    }

    private record Line(String conversation, String sender, String to) {}
}
