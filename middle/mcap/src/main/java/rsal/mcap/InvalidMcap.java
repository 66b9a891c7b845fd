package rsal.mcap;

import java.io.IOException;

/// A file that is not an MCAP file, or one that can't be read at all.
public final class InvalidMcap extends IOException {
    private static final long serialVersionUID = 1;

    InvalidMcap(String message) {
        super(message);
    }
}
