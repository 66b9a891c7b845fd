package rsal.cli.log;

import java.util.List;
import java.util.Optional;
import picocli.CommandLine;

/// One kind of files that `rsal convert` reads, and what it makes of them. Found by [java.util.ServiceLoader]; has no
/// state.
public interface Conversion {
    /// What it takes, with examples of names, for people: `worlds of Stage (FILE.world)`.
    String description();

    /// Whether it converts this. At most one conversion does.
    ///
    /// @param file what is converted
    /// @param out where to, if that was said
    boolean accepts(String file, Optional<String> out);

    /// Writes what it was made of. What it fails to write is not left half written in a place that was free.
    ///
    /// @throws rsal.settings.InvalidSettings when the file can't be converted, or something is in the way
    Result convert(Request request);

    /// @param force whether files that are there may be lost
    /// @param seed for what is drawn at random
    /// @param command for errors in what was typed
    record Request(String file, Optional<String> out, boolean force, long seed, CommandLine command) {}

    /// What to print.
    ///
    /// @param json the same as an object
    /// @param lines for people
    /// @param notes what they may not expect
    record Result(Object json, List<String> lines, List<String> notes) {}
}
