package rsal.robot;

import rsal.data.Pose2d;

/// How far something on a robot is from where its model tells it to be, as an actuator has carried it along.
///
/// @param baseFromMoved where the base would be if all of the robot had moved like that
/// @param rise [m]
public record Shift(Pose2d baseFromMoved, double rise) {
    /// It is where it was told.
    public static final Shift NONE = new Shift(Pose2d.ORIGIN, 0);

    /// This shift of what the next one has shifted already: actuators are named from the base outwards.
    public Shift compose(Shift next) {
        return isNone() ? next : next.isNone() ? this : new Shift(moved(next.baseFromMoved), rise + next.rise);
    }

    /// Where something is now.
    ///
    /// @param baseFromDevice where it was told to be; the same comes back when it has not moved
    public Pose2d moved(Pose2d baseFromDevice) {
        return isNone() ? baseFromDevice : baseFromMoved.compose(baseFromDevice);
    }

    public boolean isNone() {
        return equals(NONE);
    }
}
