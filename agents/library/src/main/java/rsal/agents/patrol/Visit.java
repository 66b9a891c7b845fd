package rsal.agents.patrol;

import java.time.Duration;
import java.util.Optional;
import rsal.agent.team.Job;
import rsal.data.Pose2d;

/// Be at a place for a while.
///
/// @param robot id of the one that shall do it; empty when any may
/// @param stay how long to stand there
public record Visit(String name, Pose2d mapFromPlace, Duration stay, Optional<String> robot) implements Job {}
