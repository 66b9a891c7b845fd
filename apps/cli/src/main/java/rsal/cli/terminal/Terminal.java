package rsal.cli.terminal;

import java.io.Console;
import picocli.CommandLine.Help.Ansi;

/// Who looks on. The launcher tells by properties. Where it can't, as on Windows, Java does, which only knows of input
/// and
/// output together.
public final class Terminal {
    private Terminal() {}

    /// Whether progress may be drawn on stderr.
    public static boolean showsProgress() {
        return isOn("rsal.terminal.err");
    }

    /// Colors for stdout: only on a terminal, and never with `NO_COLOR` (https://no-color.org).
    public static Ansi colors() {
        String noColor = System.getenv("NO_COLOR");
        boolean wanted = isOn("rsal.terminal.out") && (noColor == null || noColor.isEmpty());
        return wanted ? Ansi.ON : Ansi.OFF;
    }

    /// @param property `true`, or `ask` where the launcher can't tell
    @SuppressWarnings("SystemConsoleNull") // since JDK 25, it returns null again where there is none (JDK-8351435)
    private static boolean isOn(String property) {
        String reported = System.getProperty(property, "");
        if (!reported.equals("ask")) {
            return Boolean.parseBoolean(reported);
        }
        Console console = System.console();
        return console != null && console.isTerminal();
    }
}
