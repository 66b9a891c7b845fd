package rsal.agent;

import java.util.Optional;
import rsal.robot.Robot;
import rsal.settings.Arguments;

/// An agent to start.
///
/// @param name unique in a run
/// @param seed of its random stream
public record AgentSpec(
        String name, String role, AgentType type, Arguments arguments, Optional<Robot> robot, long seed) {}
