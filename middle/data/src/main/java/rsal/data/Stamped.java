package rsal.data;

import java.time.Instant;

/// A reading with the time it was taken (not when it arrived) and the frame it is expressed in (REP 105, prefixed
/// with the robot's id: `r1/odom`, `r1/laser0`; the shared frame is just `map`).
public record Stamped<T>(Instant time, String frame, T value) {}
