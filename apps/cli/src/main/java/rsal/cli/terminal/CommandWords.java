package rsal.cli.terminal;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import rsal.navigation.amcl.SensorModel;
import rsal.settings.Suggestion;

/// Reads words of the command line, and says in people's words what is wrong with one.
public final class CommandWords {
    private CommandWords() {}

    /// For all commands that it has by now.
    public static void register(CommandLine commandLine) {
        ITypeConverter<Integer> whole = CommandWords::whole;
        ITypeConverter<Long> longer = CommandWords::longer;
        ITypeConverter<Double> number = CommandWords::number;
        commandLine
                .registerConverter(int.class, whole)
                .registerConverter(Integer.class, whole)
                .registerConverter(long.class, longer)
                .registerConverter(Long.class, longer)
                .registerConverter(double.class, number)
                .registerConverter(Double.class, number)
                .registerConverter(SensorModel.Kind.class, word -> oneOf(word, SensorModel.Kind.values()));
    }

    private static int whole(String word) {
        try {
            return Integer.parseInt(word);
        } catch (NumberFormatException _) {
            throw new TypeConversionException(
                    word.matches("[+-]?\\d+")
                            ? "'%s' is too large a number.".formatted(word)
                            : "'%s' is not a whole number, like 42.".formatted(word));
        }
    }

    public static long longer(String word) {
        try {
            return Long.parseLong(word);
        } catch (NumberFormatException _) {
            throw new TypeConversionException("'%s' is not a whole number, like 42.".formatted(word));
        }
    }

    private static double number(String word) {
        try {
            return Double.parseDouble(word);
        } catch (NumberFormatException _) {
            throw new TypeConversionException("'%s' is not a number, like 0.5.".formatted(word));
        }
    }

    /// NaN when it is not a number, for those who say in their own words what it should be.
    public static double orNaN(String word) {
        try {
            return Double.parseDouble(word);
        } catch (NumberFormatException _) {
            return Double.NaN;
        }
    }

    public static <E extends Enum<E>> E oneOf(String word, E[] known) {
        List<String> names = Arrays.stream(known)
                .map(value -> value.name().toLowerCase(Locale.ROOT))
                .toList();
        int found = names.indexOf(word.toLowerCase(Locale.ROOT));
        if (found < 0) {
            throw new TypeConversionException("There is no '%s'. %s".formatted(word, Suggestion.among(word, names)));
        }
        return known[found];
    }
}
