package rsal.settings;

/// The version of a file's format, which its author writes as `rsal: 1`.
public final class FormatVersion {
    private static final String KEY = "rsal";

    private FormatVersion() {}

    /// Reports a version that this program does not read. It does not report one that is missing: that is the reader's.
    ///
    /// @param top the file's settings
    /// @param what is read, as `scenario`
    /// @param version that this program reads
    public static void check(Section top, String what, int version) {
        if (!top.has(KEY)) {
            return;
        }
        double written = top.number(KEY);
        if (written != version) {
            String words = written == Math.rint(written) ? Long.toString((long) written) : Double.toString(written);
            top.problem(
                    KEY,
                    "This %s has format '%s'; this RSAL reads format %d.".formatted(what, words, version),
                    written > version ? "It was written for a newer RSAL: use that." : "");
        }
    }
}
