package rsal.settings;

/// One mistake in a file: where, what was read and expected, and what to try.
///
/// @param message a sentence naming the thing and its value
/// @param remedy what to try; empty when nobody can tell
public record Problem(Location location, String message, String remedy) {
    @Override
    public String toString() {
        return location + ": " + message + (remedy.isEmpty() ? "" : "\n    " + remedy);
    }
}
