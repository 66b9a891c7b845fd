package rsal.data;

import java.util.List;
import java.util.OptionalInt;

/// Markers that a robot sees at once (Player `fiducial`).
///
/// @param baseFromFinder mount of the detector, which looks along its x axis
/// @param fieldOfView [rad]
/// @param rangeMax maximum range at which it detects markers [m]
/// @param fiducials the nearest first
public record Fiducials(Pose2d baseFromFinder, double fieldOfView, double rangeMax, List<Fiducial> fiducials) {
    public Fiducials {
        fiducials = List.copyOf(fiducials);
    }

    /// A marker.
    ///
    /// @param id what is written on it; empty when it is too far away to be read
    /// @param baseFromFiducial where it is and which way it faces, in the robot's base frame
    public record Fiducial(OptionalInt id, Pose2d baseFromFiducial) {}
}
