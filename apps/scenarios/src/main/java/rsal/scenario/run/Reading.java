package rsal.scenario.run;

import rsal.data.Stamped;

/// The newest that a device of a robot has told.
///
/// @param device its name within the robot (`gripper`)
/// @param value with its time; immutable
public record Reading(String device, Stamped<?> value) {}
