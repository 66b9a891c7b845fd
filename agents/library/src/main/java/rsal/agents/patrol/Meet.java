package rsal.agents.patrol;

import rsal.agent.team.Job;
import rsal.data.Point2d;

/// Go where an intruder is, until it has been met.
///
/// @param mapFromIntruder where it was when the alarm was raised
public record Meet(String name, Point2d mapFromIntruder) implements Job {}
