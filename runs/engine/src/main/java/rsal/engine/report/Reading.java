package rsal.engine.report;

import java.time.Duration;
import rsal.data.Stamped;

/// The newest that a device of a robot has told.
///
/// @param device its name within the robot (`gripper`)
/// @param value with its time; immutable
/// @param age how long ago it was taken, by the run's clock; below zero when a robot's clock is ahead of that
public record Reading(String device, Stamped<?> value, Duration age) {}
