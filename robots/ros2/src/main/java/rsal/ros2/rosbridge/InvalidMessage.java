package rsal.ros2.rosbridge;

/// What a server sent is not JSON, not CBOR, or no message of its type.
final class InvalidMessage extends Exception {
    private static final long serialVersionUID = 1;

    InvalidMessage(String message) {
        super(message);
    }

    InvalidMessage(String message, Throwable cause) {
        super(message, cause);
    }
}
