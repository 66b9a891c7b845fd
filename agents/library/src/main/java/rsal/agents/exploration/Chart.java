package rsal.agents.exploration;

import rsal.agent.team.Job;
import rsal.agents.parts.AgentWords;
import rsal.data.Point2d;

/// Go where the map ends, so that it goes on.
public record Chart(Point2d mapFromEnd) implements Job {
    @Override
    public String name() {
        return "map from " + AgentWords.place(AgentWords.pose(mapFromEnd));
    }
}
