package rsal.engine;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import rsal.agent.OutsideCode;
import rsal.agent.platform.AgentTurns;

/// Finds out which agent never returns, and so holds up all others on its thread. Counts how often it is seen in one
/// turn instead of measuring time: while a machine sleeps nobody is late. Of one thread.
final class Watchdog {
    private final AgentTurns turns;
    private final int patience;
    private Map<String, Watched> seen = Map.of(); // by agent

    private record Watched(long turn, int looks) {}

    /// @param patience in how many looks running an agent may be seen in one turn
    Watchdog(AgentTurns turns, int patience) {
        this.turns = turns;
        this.patience = patience;
    }

    /// @return the agent that was seen in one turn too often; of several the first by name
    Optional<String> look() {
        var now = new HashMap<String, Watched>();
        turns.inProgress().forEach((agent, turn) -> {
            if (turns.outside(agent).filter(OutsideCode::isDebugged).isPresent()) {
                return; // a person looks into it
            }
            Watched before = seen.get(agent);
            now.put(agent, new Watched(turn, before != null && before.turn == turn ? before.looks + 1 : 1));
        });
        seen = now;
        return now.entrySet().stream()
                .filter(sight -> sight.getValue().looks > patience)
                .map(Map.Entry::getKey)
                .min(String::compareTo);
    }
}
