package rsal.settings;

/// A place in a file that a person wrote.
///
/// @param file as the person knows it
/// @param line from 1; 0 for the whole file (or a command line)
/// @param column from 1
public record Location(String file, int line, int column) {
    public static Location of(String file) {
        return new Location(file, 0, 0);
    }

    @Override
    public String toString() {
        return line == 0 ? file : file + ":" + line + ":" + column;
    }
}
