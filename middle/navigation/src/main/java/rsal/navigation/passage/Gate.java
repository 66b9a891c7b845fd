package rsal.navigation.passage;

import java.util.List;
import rsal.data.Point2d;

/// Where a passage opens into a wide place.
///
/// @param mapFromGate the nearest place at which two robots can pass each other
/// @param heading out of the passage [rad], map frame
/// @param waitingPlaces where robots can wait while others leave the passage, the nearest first; a robot
/// that stands at one of them does not block the gate
public record Gate(Point2d mapFromGate, double heading, List<Point2d> waitingPlaces) {
    public Gate {
        waitingPlaces = List.copyOf(waitingPlaces);
    }
}
