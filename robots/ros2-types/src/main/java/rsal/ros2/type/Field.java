package rsal.ros2.type;

/// A field of a message.
///
/// @param fallback its default as the definition writes it; empty without one
public record Field(String name, FieldType type, String fallback) {}
