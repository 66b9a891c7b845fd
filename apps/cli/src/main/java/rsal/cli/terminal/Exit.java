package rsal.cli.terminal;

/// Exit codes, the same for all commands. Signals end with 130 (interrupt) and 143 (terminate), as the JVM does.
public final class Exit {
    public static final int SUCCESS = 0;

    /// An error of the program.
    public static final int INTERNAL = 1;

    /// The command line cannot be understood.
    public static final int USAGE = 2;

    /// A scenario, an argument or a file is wrong.
    public static final int INVALID = 3;

    /// The scenario ended in failure or timeout, or an agent failed.
    public static final int NO_SUCCESS = 4;

    /// Something outside cannot be reached or had: a port, a tool, memory.
    public static final int UNREACHABLE = 5;

    private Exit() {}
}
