package rsal.engine;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import rsal.agent.platform.AgentTurns;

/// Finds agents that never return in stepped runs, whose own threads they hold up. May be used on any thread;
/// one thread looks.
public final class SteppedWatch {
    private static final int USUAL_PATIENCE = 20;

    private final int patience;
    private final Map<AgentTurns, AgentWatch> watched = new ConcurrentHashMap<>();

    public SteppedWatch() {
        this(USUAL_PATIENCE);
    }

    /// @param patience in how many looks running an agent may be seen in one turn
    public SteppedWatch(int patience) {
        this.patience = patience;
    }

    void add(AgentTurns turns) {
        watched.put(turns, new AgentWatch(turns, patience));
    }

    void remove(AgentTurns turns) {
        watched.remove(turns);
    }

    /// Looks at all runs. To be called once a second.
    ///
    /// @return which agent has not returned and where it is, in a sentence for people; of several the first by name
    public Optional<String> look() {
        return watched.values().stream()
                .flatMap(each -> each.look().stream())
                .map(broken -> String.valueOf(broken.getMessage()))
                .min(String::compareTo);
    }
}
