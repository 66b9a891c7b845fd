package rsal.ros2.bridge;

import java.io.IOException;
import java.nio.file.Path;
import rsal.system.RobotRecorder;
import rsal.system.RobotRecorderProvider;

/// Records what a run's robots sense as a bag, for `ros2 bag`, RViz and Foxglove.
public final class Ros2RecorderProvider implements RobotRecorderProvider {
    @Override
    public String key() {
        return "ros2";
    }

    @Override
    public String description() {
        return "Records what robots sense as a bag of ROS 2 (MCAP).";
    }

    @Override
    public RobotRecorder begin(Path folder, boolean force, String program) throws IOException {
        return new Ros2Recorder(folder, force, program);
    }
}
