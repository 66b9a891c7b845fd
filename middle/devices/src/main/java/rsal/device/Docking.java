package rsal.device;

import java.time.Duration;
import rsal.data.Pose2d;

/// Drives its robot onto docks, such as charging stations, and off them again. It looks for the dock by the robot's
/// sensors, so that the robot stands more exactly than a [Navigator] would have it.
///
/// There is one goal at a time: a new one ends the present one as cancelled. A cancelled robot stands where it is,
/// which may be close to the dock. While the [motors of its robot][DriveBase#enable] are off, goals fail; switching
/// them off cancels the present one.
public interface Docking extends Device {
    /// Drives to a dock that the robot knows, and onto it.
    ///
    /// @param dock as the robot calls it
    GoalHandle<Progress, Result> dock(String dock);

    /// Drives to a dock at a place, and onto it.
    ///
    /// @param mapFromDock where it is; its x axis points out of it
    /// @param type of the dock, as the robot calls it; empty when the robot knows one type only
    /// @throws IllegalArgumentException when the place is not finite
    GoalHandle<Progress, Result> dock(Pose2d mapFromDock, String type);

    /// Drives off the dock on which it is.
    GoalHandle<Progress, Result> undock();

    /// What it does about a goal.
    enum Stage {
        /// It has the goal, and has not told more.
        BEGINNING,
        /// It drives to a place in front of the dock.
        APPROACHING,
        /// It looks for the dock by its sensors.
        DETECTING,
        /// It drives onto the dock, or off it.
        MOVING,
        /// It stands on the dock and waits until that charges it.
        WAITING,
        /// It drives back to try once more.
        RETRYING
    }

    /// How far a goal has got.
    ///
    /// @param retries how many times it has tried again
    /// @param working since the goal was given
    record Progress(Stage stage, int retries, Duration working) {}

    sealed interface Result {
        /// It is on the dock, or off it, as was wanted.
        record Reached() implements Result {}

        /// The goal was cancelled, or another one took its place.
        ///
        /// @param why for people
        record Cancelled(String why) implements Result {}

        /// It gave up.
        record Failed(String why) implements Result {}
    }
}
