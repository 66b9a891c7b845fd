package rsal.python;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rsal.agent.AgentContext;
import rsal.agent.bdi.Mind;
import rsal.python.PythonRequests.Request;

/// Beliefs and goals that an agent in Python shows, as the page has them of other agents. On the agent's lane.
final class PythonMind {
    private final AgentContext self;
    private final Map<String, String> beliefs = new LinkedHashMap<>();
    private final Map<String, Shown> goals = new LinkedHashMap<>();
    private boolean revealed;

    /// A goal.
    ///
    /// @param step what is done for it; empty when that is not known
    private record Shown(Mind.GoalState state, String step) {}

    PythonMind(AgentContext self) {
        this.self = self;
    }

    void perform(Request asked) {
        if (!revealed) {
            revealed = true;
            self.reveal(Mind.View.class, this::view);
        }
        String name = asked.text(0);
        switch (asked.verb()) {
            case "believe" -> {
                beliefs.put(name, asked.text(1));
                self.show(name, asked.text(1));
            }
            case "forget" -> beliefs.remove(name);
            case "pursue" -> {
                goals.replaceAll((_, goal) ->
                        goal.state == Mind.GoalState.PURSUED ? new Shown(Mind.GoalState.SUSPENDED, goal.step) : goal);
                goals.put(name, new Shown(Mind.GoalState.PURSUED, asked.text(1)));
            }
            case "reached" -> goals.put(name, new Shown(Mind.GoalState.REACHED, ""));
            default -> goals.remove(name);
        }
    }

    private Mind.View view() {
        var wanted = new ArrayList<Mind.GoalView>();
        goals.forEach((name, goal) -> wanted.add(new Mind.GoalView(
                name, goal.state, 0, List.of(), goal.step.isEmpty() ? List.of() : List.of(goal.step), "")));
        return new Mind.View(new LinkedHashMap<>(beliefs), wanted);
    }
}
