package rsal.ros2.rosbridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/// CBOR, with examples of RFC 8949, appendix A.
class ValueReaderTest {
    /// As each object becomes a message, which takes a hundred times as much memory.
    @Test
    void tooManyObjectsAreRefused() throws InvalidMessage {
        assertThat(ValueReader.json("[" + "{},".repeat(199_999) + "{}]")).isInstanceOf(WireValue.Many.class);
        assertThatThrownBy(() -> ValueReader.json("[" + "{},".repeat(200_000) + "{}]"))
                .isInstanceOf(InvalidMessage.class)
                .hasMessage("It has more than 200000 objects.");
    }

    private static WireValue read(String hex) throws InvalidMessage {
        return ValueReader.cbor(ByteBuffer.wrap(HexFormat.of().parseHex(hex)));
    }

    @ParameterizedTest
    @CsvSource({
        "00, 0",
        "17, 23",
        "1818, 24",
        "1903e8, 1000",
        "1a000f4240, 1000000",
        "1b000000e8d4a51000, 1000000000000",
        "20, -1",
        "3903e7, -1000",
        "f4, false",
        "f5, true",
        "f6, null",
        "f7, null",
        "f93c00, 1.0",
        "f97bff, 65504.0",
        "fa47c35000, 100000.0",
        "fb3ff199999999999a, 1.1",
        "f97e00, NaN",
        "fb7ff0000000000000, Infinity",
        "60, ''''''",
        "6449455446, '''IETF'''",
        "62c3bc, '''ü'''",
        "7f657374726561646d696e67ff, '''streaming'''",
        "c074323031332d30332d32315432303a30343a30305a, '''2013-03-21T20:04:00Z'''", // a tag that means nothing here
        "3bffffffffffffffff, -1.8446744073709552E19"
    })
    void readsWhatTheStandardShows(String hex, String words) throws InvalidMessage {
        assertThat(read(hex).words()).isEqualTo(words);
    }

    @ParameterizedTest
    @ValueSource(strings = {"83010203", "9f010203ff"})
    void readsLists(String hex) throws InvalidMessage {
        assertThat(read(hex))
                .isEqualTo(
                        new WireValue.Many(List.of(new WireValue.Int(1), new WireValue.Int(2), new WireValue.Int(3))));
    }

    @ParameterizedTest
    @ValueSource(strings = {"a26161016162820203", "bf61610161629f0203ffff"})
    void readsMaps(String hex) throws InvalidMessage {
        assertThat(read(hex))
                .isEqualTo(new WireValue.Fields(Map.of(
                        "a",
                        new WireValue.Int(1),
                        "b",
                        new WireValue.Many(List.of(new WireValue.Int(2), new WireValue.Int(3))))));
    }

    @Test
    void readsBytesInParts() throws InvalidMessage {
        var bytes = new WireValue.Numbers(64, ByteBuffer.wrap(new byte[] {1, 2, 3, 4, 5}));
        assertThat(read("450102030405")).isEqualTo(bytes);
        assertThat(read("5f42010243030405ff")).isEqualTo(bytes);
        assertThat(read("d8554400000000")).isEqualTo(new WireValue.Numbers(85, ByteBuffer.wrap(new byte[4])));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "18", "1a0000", "8301", "a1", "62c3", "ff", "1c", "0000", "5f6161ff"})
    void refusesWhatIsNone(String hex) {
        assertThatThrownBy(() -> read(hex)).isInstanceOf(InvalidMessage.class);
    }
}
