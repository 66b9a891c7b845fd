package rsal.navigation.carmen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.testkit.PublicData;

class CarmenLogTest {
    @ParameterizedTest
    @CsvSource({
        "acapulco-corrected, 861, 181",
        "aces-corrected, 440, 180",
        "edmonton-corrected, 340, 180",
        "fhw-corrected, 488, 180",
        "freiburg-101-corrected, 292, 360",
        "orebro-corrected, 237, 181",
        "seattle-corrected, 241, 361"
    })
    void readsAllScansOfPublicLogs(String name, int scans, int beams) throws IOException {
        CarmenLog log = CarmenLog.read(PublicData.file("logs/%s.log.gz".formatted(name)), LogReader.Options.DEFAULT);

        assertThat(log.scans()).hasSize(scans).allMatch(scan -> scan.scan().count() == beams);
        assertThat(log.scans()).isSortedAccordingTo((a, b) -> a.time().compareTo(b.time()));
        assertThat(log.skipped().counts().keySet()).isSubsetOf("back in time");
    }

    @Test
    void theLongestReadingOfALogStandsForNothingWhenItIsThatOften() throws IOException {
        CarmenLog log = read(IntStream.range(0, 50)
                .mapToObj(i -> "FLASER 6 1 2 %s 8 8 8 0 0 0 0 0 0 %d h 0\n".formatted(3 + i * 0.09, i + 1))
                .collect(Collectors.joining()));

        assertThat(log.rangeMax()).isCloseTo(7.9, within(1e-6));
        assertThat(log.scans().getLast().scan().ranges()[5]).isEqualTo(Float.POSITIVE_INFINITY);
        assertThat(log.scans().getLast().scan().ranges()[2]).isCloseTo(7.41f, within(1e-6f));
    }

    @Test
    void theLongestReadingsOfALogAreRangesWhenTheyAreFew() throws IOException {
        CarmenLog log = read(IntStream.range(0, 50)
                .mapToObj(i -> "FLASER 4 1 2 3 %s 0 0 0 0 0 0 %d h 0\n".formatted(3 + i * 0.09, i + 1))
                .collect(Collectors.joining()));

        assertThat(log.rangeMax()).isEqualTo(50);
        assertThat(log.scans().getLast().scan().ranges()[3]).isCloseTo(7.41f, within(1e-6f));
    }

    @Test
    void theFarCornerOfARoomWhereARobotStandsIsThere() throws IOException {
        CarmenLog log = read(IntStream.range(0, 200)
                .mapToObj(i -> "FLASER 7 1 5.5 5.7 5.9 5.72 5.53 2 0 0 0 0 0 0 %d h 0\n".formatted(i + 1))
                .collect(Collectors.joining()));

        assertThat(log.rangeMax()).isEqualTo(50);
        assertThat(log.scans().getLast().scan().ranges()[3]).isCloseTo(5.9f, within(1e-6f));
    }

    private static CarmenLog read(String text) throws IOException {
        return CarmenLog.read(
                "test.log", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), LogReader.Options.DEFAULT);
    }
}
