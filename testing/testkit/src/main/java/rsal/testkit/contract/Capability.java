package rsal.testkit.contract;

/// What a robot system may be unable to do. Its contract tests skip what needs it; all else it owes.
public enum Capability {
    /// [rsal.system.RobotSystem#simulation] tells and changes the truth.
    TRUTH,
    /// Things can be put into the simulated world.
    THINGS,
    /// Robots know walls and stop at them.
    WALLS,
    /// The motors can be switched off.
    ENABLE,
    /// Odometry can be set.
    RESET_ODOMETRY,
    /// The same seed gives the same readings.
    REPEATABLE
}
