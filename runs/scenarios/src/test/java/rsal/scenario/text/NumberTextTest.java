package rsal.scenario.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NumberTextTest {
    /// What the page's tests expect of its own.
    private static final Path CASES = Path.of("../../apps/web/src/number-texts.json");

    @ParameterizedTest
    @CsvSource({
        "0, 0",
        "-0.0, 0",
        "2278, 2278",
        "-1234567890, -1234567890",
        "999999999999999, 999999999999999",
        "0.25, 0.250",
        "61.2345, 61.2",
        "2278.4, 2278",
        "1234567.5, 1234568",
        "99.96, 100",
        "999.7, 1000",
        "0.99996, 1.00",
        "0.0258, 0.0258",
        "-0.0004, -4.00e-4",
        "1.5e300, 1.50e300",
        "NaN, NaN",
        "-Infinity, -Infinity",
    })
    void isExactWhereItCounts(double value, String text) {
        assertThat(NumberText.of(value)).isEqualTo(text);
    }

    @Test
    void everyCountKeepsItsDigits() {
        new SplittableRandom(1)
                .longs(10_000, -999_999_999_999_999L, 1_000_000_000_000_000L)
                .forEach(count -> assertThat(NumberText.of((double) count)).isEqualTo(Long.toString(count)));
    }

    @Test
    void isOffByHalfOfItsLastDigitAtMost() {
        new SplittableRandom(2).doubles(10_000, -20, 20).map(Math::exp).forEach(value -> {
            String text = NumberText.of(value);
            assertThat(Math.abs(Double.parseDouble(text) - value) / value).isLessThanOrEqualTo(0.005);
            if (value >= 100) {
                assertThat(Double.parseDouble(text)).isEqualTo((double) Math.round(value));
            }
        });
    }

    /// The page writes the same numbers: its tests read this file. `-Drsal.update=true` writes it again.
    @Test
    void thePageWritesTheSame() throws IOException {
        String cases = values().mapToObj("  [%s, \"%%s\"]"::formatted)
                .map(line -> line.formatted(NumberText.of(Double.parseDouble(line.substring(3, line.indexOf(','))))))
                .collect(Collectors.joining(",\n", "[\n", "\n]\n"));
        if (Boolean.getBoolean("rsal.update")) {
            Files.writeString(CASES, cases);
        }
        assertThat(Files.readString(CASES).replace("\r\n", "\n"))
                .as("Write it again: -Dtest=NumberTextTest -Drsal.update=true")
                .isEqualTo(cases);
    }

    private static DoubleStream values() {
        var random = new SplittableRandom(3);
        DoubleStream borders = DoubleStream.of(
                0, 2278, 1e6, 1e15, 1e16, 9.995, 99.95, 999.5, 0.0009995, 0.001, 1e-300, 0.5, 2.5, 1.005, 123456.5);
        DoubleStream sizes = random.doubles(300, -40, 40).map(Math::exp);
        DoubleStream counts = random.longs(100, 0, 1_000_000_000_000L).asDoubleStream();
        DoubleStream halves = random.ints(100, 0, 100_000).mapToDouble(i -> i / 200.0);
        return DoubleStream.concat(DoubleStream.concat(borders, sizes), DoubleStream.concat(counts, halves))
                .flatMap(value -> DoubleStream.of(value, -value));
    }
}
