package rsal.fault;

/// Something that goes wrong with a robot or with one of its devices, until somebody ends it.
public sealed interface Fault {
    /// Of what a sensor shows. What it does besides (a base drives) goes on.
    sealed interface OfSensor extends Fault {}

    /// No readings come any more. Those who have the sensor see that it is stale, when the next reading is overdue.
    record Dead() implements OfSensor {}

    /// The last reading comes again and again, as if it were new. Nobody is told that anything is wrong.
    record Frozen() implements OfSensor {}

    /// All that is measured is farther away than it is, and more to the left. Of a pose (odometry, localizer): it is
    /// farther ahead, and turned to the left.
    ///
    /// @param range [m]
    /// @param angle [rad]
    record Biased(double range, double angle) implements OfSensor {}

    /// Each single thing that is measured has a Gaussian error besides those that the sensor has anyway. Of a pose:
    /// ahead and to the left as far, and turned.
    ///
    /// @param range standard deviation [m]
    /// @param angle standard deviation [rad]
    record Noisy(double range, double angle) implements OfSensor {}

    /// The motors do less than they are told.
    ///
    /// @param power part of the speeds wanted that is left, 0–1; 0: the base stands still, whatever it is told
    record MotorDead(double power) implements Fault {}

    /// The wheels turn more than the robot moves: what it makes is what it was told, what odometry counts is more.
    ///
    /// @param way part of it that is counted besides; less than 0 when wheels drag
    /// @param turn part of it that is counted besides
    /// @param drift turn to the left that is counted for each meter forward [rad/m]
    record Slip(double way, double turn, double drift) implements Fault {}

    /// The robot is gone and all of its devices are lost; nothing that it is told has an effect.
    ///
    /// @param stays whether it still stands where it was, in the way of others
    record Gone(boolean stays) implements Fault {}
}
