package rsal.recording;

/// A number in what a device tells.
///
/// @param name where in it that is: `velocity.vx`
/// @param title what people call it, a few words; empty where its device says it all
/// @param unit of SI, with angles in rad; empty where it has none, or nobody knows
/// @param value NaN when it is none now
public record RecordedQuantity(String name, String title, String unit, double value) {}
