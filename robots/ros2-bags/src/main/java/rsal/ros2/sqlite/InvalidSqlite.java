package rsal.ros2.sqlite;

import java.io.IOException;

/// A file that is no database of SQLite, or a part of one that is damaged.
public final class InvalidSqlite extends IOException {
    private static final long serialVersionUID = 1;

    InvalidSqlite(String message) {
        super(message);
    }
}
