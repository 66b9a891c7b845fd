package rsal.navigation.log;

import java.io.IOException;

/// A log that can't be read any further. The message says where, why, and what may help.
public final class BrokenLog extends IOException {
    private static final long serialVersionUID = 1;

    private final String file;
    private final int line;
    private final String reason;

    /// @param line where it ends to make sense, from 1; 0 when the whole file does not
    public BrokenLog(String file, int line, String message) {
        super((line == 0 ? file : file + ":" + line) + ": " + message);
        this.file = file;
        this.line = line;
        this.reason = message;
    }

    /// @param line the same
    public BrokenLog(String file, int line, String message, Throwable cause) {
        this(file, line, message);
        initCause(cause);
    }

    public String file() {
        return file;
    }

    /// From 1; 0 for the whole file.
    public int line() {
        return line;
    }

    /// Why, without the place.
    public String reason() {
        return reason;
    }
}
