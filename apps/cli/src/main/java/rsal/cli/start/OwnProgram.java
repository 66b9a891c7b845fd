package rsal.cli.start;

import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;

/// This program, to be started once more as another process.
public final class OwnProgram {
    private OwnProgram() {}

    /// @param kept which of the JVM's options the other process gets, too
    /// @param more options that it gets besides; of two that contradict each other, the JVM takes the latter
    /// @return the command, to which arguments are added
    public static List<String> command(Predicate<String> kept, List<String> more) {
        return Stream.of(
                        Stream.of(Path.of(System.getProperty("java.home"), "bin", "java")
                                .toString()),
                        ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
                                .filter(kept),
                        more.stream(),
                        Stream.of("-cp", System.getProperty("java.class.path"), "rsal.cli.Main"))
                .flatMap(part -> part)
                .toList();
    }
}
