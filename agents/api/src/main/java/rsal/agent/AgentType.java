package rsal.agent;

import java.util.List;
import java.util.Optional;
import rsal.device.Device;
import rsal.device.Locomotion;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.settings.Problem;

/// A kind of agent, found by [java.util.ServiceLoader] and named by its key in a scenario.
public interface AgentType {
    /// What scenarios call it, as `follow`; unique in an installation.
    String key();

    /// A sentence about what it does.
    String description();

    default List<Parameter<?>> parameters() {
        return List.of();
    }

    /// Types of devices without which it can't work, whatever its arguments; none for agents without a robot.
    default List<Class<? extends Device>> needs() {
        return List.of();
    }

    /// The same for one with such arguments, which may need more.
    default List<Class<? extends Device>> needs(Arguments arguments) {
        return needs();
    }

    /// Whether one with such arguments drives its robot. Two of these on one robot would take it from each
    /// other again and again, so scenarios refuse them. As long as it says nothing else, an agent drives that
    /// needs a device for [Locomotion].
    default boolean drives(Arguments arguments) {
        return needs(arguments).stream().anyMatch(Locomotion.class::isAssignableFrom);
    }

    /// Key of an agent type without which one with such arguments has nothing to do, as the one that gives it tasks;
    /// empty when it needs none. Scenarios without an agent of that type refuse it. Agents in
    /// files count as one.
    default Optional<String> needsAgent(Arguments arguments) {
        return Optional.empty();
    }

    /// Whether it leaves its robot to another agent as long as that drives it.
    default boolean yields() {
        return false;
    }

    /// What stands in its file; empty for one in Java.
    default Optional<AgentOutline> outline() {
        return Optional.empty();
    }

    /// What in its file may not be meant; none for one in Java.
    default List<Problem> warnings() {
        return List.of();
    }

    /// @param arguments for [#parameters]
    Agent create(Arguments arguments);
}
