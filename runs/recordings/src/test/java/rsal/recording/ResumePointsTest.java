package rsal.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.util.Objects;
import org.junit.jupiter.api.Test;

class ResumePointsTest {
    private static final long SECOND = 1_000_000_000;
    private static final long MOST = 100_000;

    /// After so many seconds, of which each has a message that is new.
    private static ResumePoints read(int seconds, int bytes, NewestRecords held) {
        var places = new ResumePoints(MOST);
        for (int second = 0; second < seconds; second++) {
            if (places.isDue(second * SECOND)) {
                places.keep(second * SECOND - 1, held);
            }
            held.put("/state", second, ByteBuffer.allocate(bytes));
        }
        return places;
    }

    @Test
    void thereIsOneEveryTwoSeconds() {
        ResumePoints places = read(21, 10, new NewestRecords());
        assertThat(places.count()).isEqualTo(11);
        assertThat(places.before(-SECOND)).isNull();
        assertThat(Objects.requireNonNull(places.before(5 * SECOND)).getKey()).isEqualTo(4 * SECOND - 1);
    }

    @Test
    void largeMessagesAreInFewPlaces() {
        ResumePoints places = read(600, 10_000, new NewestRecords());
        assertThat(places.count()).isBetween(4, 10);
        assertThat(Objects.requireNonNull(places.before(0)).getKey()).isEqualTo(-1);
    }

    /// A thousand robots have many, which hardly change.
    @Test
    void manyMessagesAreInFewPlacesToo() {
        var held = new NewestRecords();
        for (int i = 0; i < 200; i++) {
            held.put("/devices " + i, 0, ByteBuffer.allocate(4));
        }
        assertThat(read(600, 10, held).count()).isBetween(3, 8);
        assertThat(read(600, 10, new NewestRecords()).count()).isBetween(150, 400);
    }
}
