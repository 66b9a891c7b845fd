package rsal.metric;

import java.util.OptionalInt;
import rsal.data.Pose2d;

/// A thing in the simulated world.
///
/// @param name unique, as `victim-2`
/// @param group as the scenario calls it, `victim`; empty for what the scenario did not put there
/// @param marker what the marker says that it wears; empty for none
/// @param mapFromThing where it truly is
public record ThingState(String name, String group, OptionalInt marker, Pose2d mapFromThing) {}
