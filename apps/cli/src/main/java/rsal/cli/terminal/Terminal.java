package rsal.cli.terminal;

import picocli.CommandLine.Help.Ansi;

/// Who looks on. The launcher tells, because Java only knows of input and output together.
public final class Terminal {
    private Terminal() {}

    /// Whether progress may be drawn on stderr.
    public static boolean showsProgress() {
        return Boolean.getBoolean("rsal.terminal.err");
    }

    /// Colors for stdout: only on a terminal, and never with `NO_COLOR` (https://no-color.org).
    public static Ansi colors() {
        String noColor = System.getenv("NO_COLOR");
        boolean wanted = Boolean.getBoolean("rsal.terminal.out") && (noColor == null || noColor.isEmpty());
        return wanted ? Ansi.ON : Ansi.OFF;
    }
}
