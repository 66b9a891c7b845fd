package rsal.scenario;

/// A variant of a scenario.
///
/// @param name `advanced`
/// @param title for people; empty when it has none
public record Configuration(String name, String title) {}
