package rsal.device;

import rsal.data.Sketch;

/// A drawing surface for people who watch a robot's world, such as the window of a simulator.
public interface Canvas extends Device {
    /// Shows this sketch instead of the previous one. It moves along with the robot.
    ///
    /// @param sketch in the robot's base frame
    void show(Sketch sketch);
}
