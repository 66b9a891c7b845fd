package rsal.ros2.cdr;

/// Bytes that are not a message of their type. Its message says at which byte, and what is wrong.
public final class InvalidCdr extends Exception {
    private static final long serialVersionUID = 1;

    public InvalidCdr(String message) {
        super(message);
    }
}
