package rsal.device;

import rsal.data.Sketch;

/// Where a robot can draw for people who look at its world, as into the window of a simulator.
public interface Canvas extends Device {
    /// Shows this, and nothing that was drawn before. It moves along with the robot.
    ///
    /// @param sketch in the robot's base frame
    void show(Sketch sketch);
}
