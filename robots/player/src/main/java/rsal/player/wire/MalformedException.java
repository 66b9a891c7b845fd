package rsal.player.wire;

import java.io.IOException;

/// What came is not a message of Player's.
public final class MalformedException extends IOException {
    private static final long serialVersionUID = 1;

    public MalformedException(String message) {
        super(message);
    }
}
