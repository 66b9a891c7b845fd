package rsal.player.wire;

/// What a message is for, with its code.
public enum MessageKind {
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

    private static final MessageKind[] KINDS = values();

    private final int code;

    MessageKind(int code) {
        this.code = code;
    }

    public static MessageKind of(int code) {
        for (MessageKind kind : KINDS) {
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
