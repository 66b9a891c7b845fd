package rsal.ros2.type;

/// A definition that can't be read. Its message says where, what, and which value.
public final class InvalidDefinition extends RuntimeException {
    private static final long serialVersionUID = 1;

    public InvalidDefinition(String message) {
        super(message);
    }
}
