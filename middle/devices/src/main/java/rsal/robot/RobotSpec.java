package rsal.robot;

import java.util.Optional;
import java.util.OptionalInt;
import rsal.data.Pose2d;

/// A robot that a scenario asks a robot system for.
///
/// @param model with the sensors that the scenario wants it to have
/// @param mapFromBase where it starts; empty lets the robot system say where it is, or choose
/// @param color for people, `#rrggbb`
/// @param marker id of the marker that it wears, by which fiducial finders know it; not 0
public record RobotSpec(
        String id, String role, RobotModel model, Optional<Pose2d> mapFromBase, String color, OptionalInt marker) {
    /// A robot that wears no marker.
    public RobotSpec(String id, String role, RobotModel model, Optional<Pose2d> mapFromBase, String color) {
        this(id, role, model, mapFromBase, color, OptionalInt.empty());
    }
}
