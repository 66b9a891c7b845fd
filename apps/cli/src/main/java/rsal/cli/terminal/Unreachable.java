package rsal.cli.terminal;

/// Something outside cannot be reached or had. The message says what, and what to try.
public final class Unreachable extends RuntimeException {
    private static final long serialVersionUID = 1;

    public Unreachable(String message) {
        super(message);
    }
}
