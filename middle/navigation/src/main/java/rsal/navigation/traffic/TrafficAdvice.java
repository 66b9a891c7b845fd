package rsal.navigation.traffic;

import rsal.data.Point2d;

/// What a robot is to do on its path, as others are near.
public sealed interface TrafficAdvice {
    /// Drive on.
    record Proceed() implements TrafficAdvice {}

    /// Stop where it is.
    record Halt() implements TrafficAdvice {}

    /// Leave the path and wait.
    ///
    /// @param mapFromPlace where to wait
    /// @param mapFromGate what to look at meanwhile
    record WaitAt(Point2d mapFromPlace, Point2d mapFromGate) implements TrafficAdvice {}
}
