package rsal.environment;

import rsal.data.Pose2d;

/// The truth of a simulated world, for observations that only a simulation can give. Robots have numbers from 0 on.
public interface Truth {
    /// The number of a robot; −1 when there is no such robot.
    int number(String robot);

    /// Numbers of the robots that have a role; of all robots, if it is empty.
    int[] numbers(String role);

    /// The true pose of a robot in `map`; where it was last when it is gone.
    Pose2d truth(int robot);
}
