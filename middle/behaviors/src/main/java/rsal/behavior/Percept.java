package rsal.behavior;

import java.time.Instant;
import rsal.data.Odometry;

/// What a robot senses at one moment.
///
/// @param time when the layers are asked
public record Percept(Instant time, Odometry odometry, Surroundings surroundings) {}
