package rsal.agent;

import java.util.List;
import java.util.Objects;
import rsal.settings.Location;

/// What stands in the file of an agent, for people who look at it before it runs.
///
/// @param goals that it begins with
/// @param plans in the order in which they are tried
/// @param hears names of the topics that it listens to
/// @param says where it says something to others
public record AgentOutline(List<Line> goals, List<Line> plans, List<String> hears, List<Line> says) {
    /// @param text as its author wrote it, more or less
    public record Line(String text, Location at) {
        public Line {
            Objects.requireNonNull(text, "A line must have a text.");
            Objects.requireNonNull(at, "A line must be somewhere.");
        }
    }

    public AgentOutline {
        goals = List.copyOf(goals);
        plans = List.copyOf(plans);
        hears = List.copyOf(hears);
        says = List.copyOf(says);
    }
}
