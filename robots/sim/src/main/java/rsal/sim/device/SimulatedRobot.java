package rsal.sim.device;

import java.util.random.RandomGenerator;
import rsal.data.Pose2d;

/// What a simulated device may know of its robot: what is true, whatever the robot itself knows.
public interface SimulatedRobot {
    /// Where the device is now, carried by actuators that it stands on. All devices are level.
    Pose2d mapFromDevice();

    /// How high above the floor the device is [m].
    double height();

    /// Paints what a camera without distortion sees that looks along the device's x axis. The ray of column c and row
    /// r goes (columns / 2 - c - 1/2) / f to the left and (rows / 2 - r - 1/2) / f upwards for each meter ahead.
    /// Pixels that show neither a wall nor a thing nor a robot stay as they are. Only for a sensor that casts rays
    /// ([SimulatedSensor#rays]).
    ///
    /// @param focalLength f [px]
    /// @param reach how far away things are seen, as seen from above [m]
    /// @param colors by pixel, row by row: 0xRRGGBB
    /// @param depths by pixel, along the optical axis [m]
    void paint(int columns, int rows, double focalLength, double reach, int[] colors, float[] depths);

    /// What is to be random about the device. A stream of its own, the same in each run of one seed.
    RandomGenerator random();

    /// What errors are multiplied by: the simulator's option `sensorNoise`, usually 1.
    double noise();
}
