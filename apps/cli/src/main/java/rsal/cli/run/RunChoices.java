package rsal.cli.run;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;
import rsal.cli.terminal.CommandWords;

/// What commands that start a run have in common.
public final class RunChoices {
    @Option(
            names = "--set",
            paramLabel = "NAME=VALUE",
            converter = Setting.Converter.class,
            description = "Set an argument of the scenario ('rsal show SCENARIO' lists them). May be repeated.")
    private List<Setting> settings = List.of();

    @Option(
            names = "--seed",
            paramLabel = "N",
            converter = Seed.class,
            description = "Seed of all random numbers. The same seed gives the same run.")
    private @Nullable Long seed;

    @Option(
            names = "--speed",
            paramLabel = "X|max",
            converter = Speed.class,
            description = "Simulated time over real time, from 0.1; max: as fast as possible.")
    private @Nullable Double speed;

    Map<String, String> arguments() {
        var arguments = new LinkedHashMap<String, String>();
        settings.forEach(setting -> arguments.put(setting.name(), setting.value()));
        return arguments;
    }

    OptionalLong seed() {
        return seed == null ? OptionalLong.empty() : OptionalLong.of(seed);
    }

    OptionalDouble speed() {
        return speed == null ? OptionalDouble.empty() : OptionalDouble.of(speed);
    }

    /// What `--set` says of an argument.
    public record Setting(String name, String value) {
        public static final class Converter implements ITypeConverter<Setting> {
            @Override
            public Setting convert(String typed) {
                int equals = typed.indexOf('=');
                if (equals < 1) {
                    throw new TypeConversionException(
                            "'%s' is not a name and its value, like speed=2.".formatted(typed));
                }
                return new Setting(typed.substring(0, equals), typed.substring(equals + 1));
            }
        }
    }

    static final class Seed implements ITypeConverter<Long> {
        @Override
        public Long convert(String typed) {
            return CommandWords.longer(typed);
        }
    }

    static final class Speed implements ITypeConverter<Double> {
        private static final double LEAST = 0.1;

        @Override
        public Double convert(String typed) {
            if (typed.equals("max")) {
                return Double.POSITIVE_INFINITY;
            }
            double speed = CommandWords.orNaN(typed);
            if (!(speed >= LEAST)) {
                throw new TypeConversionException(
                        "'%s' is neither a number of at least %s, like 4, nor max.".formatted(typed, LEAST));
            }
            return speed;
        }
    }
}
