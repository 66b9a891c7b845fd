package rsal.system;

import java.io.IOException;
import java.nio.file.Path;

/// A way to record the robots of a run, whatever robot system they are of, for programs of another one. Found by
/// [java.util.ServiceLoader] and named by its key (`rsal run --record-ros2`).
public interface RobotRecorderProvider {
    /// `ros2`
    String key();

    /// For people: a sentence.
    String description();

    /// Begins a recording.
    ///
    /// @param folder which is made
    /// @param force whether a recording that is there may be lost
    /// @param program that writes, for people
    /// @throws java.nio.file.FileAlreadyExistsException when it is there and may not
    /// @throws IOException when it can't be written
    RobotRecorder begin(Path folder, boolean force, String program) throws IOException;
}
