package rsal.cli.terminal;

import java.util.List;
import rsal.settings.Problem;

/// Something wrong in a file, flat, for those who read JSON line by line.
///
/// @param line from 1; 0 for the whole file
/// @param column from 1
/// @param remedy what to try; empty when nobody can tell
public record FileError(String file, int line, int column, String message, String remedy) {
    public static List<FileError> of(List<Problem> problems) {
        return problems.stream().map(FileError::of).toList();
    }

    private static FileError of(Problem problem) {
        return new FileError(
                problem.location().file(),
                problem.location().line(),
                problem.location().column(),
                problem.message(),
                problem.remedy());
    }

    /// As people read it: with where it is written, when that is more than the file.
    public static String note(Problem note) {
        boolean isOfAll = note.location().line() == 0 && !note.location().file().startsWith("--");
        String remedy = note.remedy().isEmpty() ? "" : "\n    " + note.remedy();
        return "Note: " + (isOfAll ? note.message() + remedy : note);
    }
}
