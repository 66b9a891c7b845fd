package rsal.engine.agent;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import rsal.agent.platform.AgentPlatform;
import rsal.engine.event.EventLog;

/// Goals for which agents had no plan at all. All calls on the run's thread.
final class UnhandledGoals {
    private static final int MOST = 10; // of an agent that are kept

    private final EventLog eventLog;
    private final Map<String, List<String>> byAgent = new TreeMap<>();

    UnhandledGoals(EventLog eventLog) {
        this.eventLog = eventLog;
    }

    /// The first time of each goal is an event.
    void note(AgentPlatform.Unhandled goal) {
        List<String> all = byAgent.computeIfAbsent(goal.agent(), _ -> new ArrayList<>());
        if (all.contains(goal.goal())) {
            return;
        }
        if (all.size() < MOST) {
            all.add(goal.goal());
        }
        String where = goal.where().isEmpty() ? "" : " at " + goal.where();
        eventLog.event("fault", goal.agent(), "has no plan for goal '%s'%s".formatted(goal.goal(), where));
    }

    Map<String, List<String>> byAgent() {
        return byAgent;
    }
}
