package rsal.cli;

/// Something outside cannot be reached or had. The message says what, and what to try.
final class Unreachable extends RuntimeException {
    private static final long serialVersionUID = 1;

    Unreachable(String message) {
        super(message);
    }
}
