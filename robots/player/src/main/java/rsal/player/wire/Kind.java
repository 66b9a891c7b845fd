package rsal.player.wire;

/// What a message is for, with its code.
public enum Kind {
    /// None that is known.
    UNKNOWN(0),
    DATA(1),
    COMMAND(2),
    REQUEST(3),
    /// Answers a request.
    ACK(4),
    /// Ends a round of data.
    SYNCH(5),
    /// Refuses a request.
    NACK(6);

    private static final Kind[] KINDS = values();

    private final int code;

    Kind(int code) {
        this.code = code;
    }

    public static Kind of(int code) {
        for (Kind kind : KINDS) {
            if (kind.code == code) {
                return kind;
            }
        }
        return UNKNOWN;
    }

    public int code() {
        return code;
    }
}
