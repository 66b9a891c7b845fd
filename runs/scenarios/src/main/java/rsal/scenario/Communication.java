package rsal.scenario;

import java.util.Optional;
import rsal.scenario.fault.Span;

/// How far agents of robots are heard by radio, and what gets lost on the way.
///
/// @param range between robots [m]; +∞ where there is no limit
/// @param behindWalls range where the straight line between them crosses a wall of the map [m]; at most `range`
/// @param loss how likely it is for each message and each agent that should hear it, 0–1
/// @param delay of each message, drawn for each agent that hears it
/// @param bandwidth messages a second of each agent; empty where there is no limit
/// @param seed of its random stream
public record Communication(
        double range, double behindWalls, double loss, Span delay, Optional<Double> bandwidth, long seed) {}
