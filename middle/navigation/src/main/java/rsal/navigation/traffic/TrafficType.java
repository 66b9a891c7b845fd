package rsal.navigation.traffic;

import java.time.Instant;
import java.util.concurrent.CompletionStage;
import java.util.function.Supplier;
import rsal.navigation.passage.Passages;
import rsal.robot.TeamLink;
import rsal.settings.Arguments;
import rsal.settings.Plugin;

/// A kind of traffic rules. Found by [java.util.ServiceLoader], or a Java file that a scenario names:
/// `navigator: {traffic: Mine.java}`.
public interface TrafficType extends Plugin {
    /// One for each robot.
    ///
    /// @param arguments for [#parameters]
    TrafficRule create(Arguments arguments, Participant participant);

    /// The robot for which a rule decides.
    ///
    /// @param robot its id
    /// @param radius of the circle that it turns in [m]
    /// @param link to the other robots
    /// @param passages of the map for such a robot; computed when they are first asked for
    /// @param start time at which the rule is made
    record Participant(
            String robot, double radius, TeamLink link, Supplier<CompletionStage<Passages>> passages, Instant start) {}
}
