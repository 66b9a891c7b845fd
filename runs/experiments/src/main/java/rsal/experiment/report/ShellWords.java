package rsal.experiment.report;

import java.util.List;
import java.util.stream.Collectors;

/// A command as it can be pasted into a shell.
public final class ShellWords {
    private ShellWords() {}

    public static String of(List<String> words) {
        return words.stream().map(ShellWords::quoted).collect(Collectors.joining(" "));
    }

    private static String quoted(String word) {
        return word.matches("[A-Za-z0-9_@%+=:,./-]+") ? word : "'" + word.replace("'", "'\\''") + "'";
    }
}
