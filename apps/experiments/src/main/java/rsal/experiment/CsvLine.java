package rsal.experiment;

import java.util.stream.Collectors;
import java.util.stream.Stream;

/// A line of CSV (RFC 4180, but with a line feed alone).
public final class CsvLine {
    private CsvLine() {}

    public static String of(Stream<String> cells) {
        return cells.map(CsvLine::cell).collect(Collectors.joining(",", "", "\n"));
    }

    private static String cell(String text) {
        return text.chars().anyMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r')
                ? '"' + text.replace("\"", "\"\"") + '"'
                : text;
    }
}
