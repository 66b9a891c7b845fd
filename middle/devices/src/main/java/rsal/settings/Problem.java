package rsal.settings;

import java.util.regex.Pattern;

/// One mistake in a file: where, what was read and expected, and what to try.
///
/// @param message a sentence naming the thing and its value
/// @param remedy what to try; empty when nobody can tell
public record Problem(Location location, String message, String remedy) {
    private static final Pattern CONTROL = Pattern.compile("[\\p{Cc}&&[^\n]]");

    /// For people: what a file has of control characters is written out, as terminals would obey it.
    @Override
    public String toString() {
        String text = location + ": " + message + (remedy.isEmpty() ? "" : "\n    " + remedy);
        return CONTROL.matcher(text)
                .replaceAll(match -> "\\\\u%04x".formatted((int) match.group().charAt(0)));
    }
}
