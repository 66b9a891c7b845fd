package rsal.ros2.sqlite;

import java.io.IOException;

/// Takes the rows of a table.
@FunctionalInterface
public interface RowVisitor {
    /// @param row valid until this returns
    void row(SqliteRow row) throws IOException;
}
