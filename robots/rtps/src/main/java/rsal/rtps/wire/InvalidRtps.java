package rsal.rtps.wire;

/// Bytes are no RTPS. The message says which ones, for people.
public final class InvalidRtps extends Exception {
    private static final long serialVersionUID = 1;

    public InvalidRtps(String message) {
        super(message, null, false, false); // a flood of these must not cost stack traces
    }
}
