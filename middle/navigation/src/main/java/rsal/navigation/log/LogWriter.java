package rsal.navigation.log;

import java.io.IOException;
import java.nio.file.Path;

/// Writes logs in a format, for other programs to read. Has no state, and may be called on any thread.
public interface LogWriter {
    /// What it writes, with examples of names, for people: `a log of CARMEN (OUT.log)`.
    String description();

    /// Whether such a name is one of its logs.
    ///
    /// @param name of a file, or of a folder if it ends in `/`
    boolean accepts(String name);

    /// Writes a log.
    ///
    /// @param target a file, or a folder, which is to be made
    /// @param force whether a log that is there may be lost
    /// @return what was written
    /// @throws java.nio.file.FileAlreadyExistsException when it is there and may not
    /// @throws IOException when it can't be written; what was written until then is left for the caller to delete
    Written write(RobotLog log, Path target, boolean force) throws IOException;

    /// What was written.
    ///
    /// @param scans of the log
    /// @param motions messages of odometry
    /// @param leftOut scans that the format can't have, as nothing tells where the robot was
    record Written(int scans, int motions, int leftOut) {}
}
