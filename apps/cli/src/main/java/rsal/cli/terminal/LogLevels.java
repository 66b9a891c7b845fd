package rsal.cli.terminal;

import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/// Which entries of a log are kept: `info`, or `info,player=debug` with levels for parts of the program.
///
/// @param least level of the least important entries, of parts that are not named
/// @param byPart level by part, as [#part] names it
public record LogLevels(Level least, Map<String, Level> byPart) {
    private static final String OURS = "rsal.";

    /// Levels of a log, the least important first.
    public enum Level {
        debug,
        info,
        warn,
        error
    }

    /// The part of the program that a logger belongs to: of `rsal.player.device.RemoteServer` it is `player`; a library
    /// is its own part.
    static String part(String logger) {
        return logger.startsWith(OURS) ? logger.substring(OURS.length()).split("\\.", 2)[0] : logger;
    }

    /// The loggers of a part: those with this name or one below.
    static String logger(String part) {
        return part.contains(".") ? part : OURS + part;
    }

    public static final class Converter implements ITypeConverter<LogLevels> {
        @Override
        public LogLevels convert(String typed) {
            Level least = Level.info;
            var byPart = new TreeMap<String, Level>();
            for (String each : typed.split(",", -1)) {
                int assigned = each.indexOf('=');
                if (assigned < 0) {
                    least = level(each);
                } else if (each.substring(0, assigned).matches("[a-z][\\w.]*")) {
                    byPart.put(each.substring(0, assigned), level(each.substring(assigned + 1)));
                } else {
                    throw new TypeConversionException(
                            "'%s' is not a level of a part, like player=debug.".formatted(each));
                }
            }
            return new LogLevels(least, byPart);
        }

        private static Level level(String typed) {
            return Arrays.stream(Level.values())
                    .filter(level -> level.name().equals(typed))
                    .findFirst()
                    .orElseThrow(() -> new TypeConversionException("'%s' is not a level: %s."
                            .formatted(
                                    typed,
                                    Arrays.stream(Level.values())
                                            .map(Enum::name)
                                            .collect(Collectors.joining(", ")))));
        }
    }
}
