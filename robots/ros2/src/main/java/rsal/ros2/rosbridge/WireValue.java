package rsal.ros2.rosbridge;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.ros2.link.PeerText;

/// A value of JSON or CBOR.
sealed interface WireValue {
    /// JSON has no NaN and no infinity: rosbridge sends this for them.
    record Null() implements WireValue {}

    record Bool(boolean isTrue) implements WireValue {}

    /// @param value the bits where it is more than a `long` can have
    record Int(long value) implements WireValue {}

    record Real(double value) implements WireValue {}

    record Text(String value) implements WireValue {}

    record Many(List<WireValue> values) implements WireValue {}

    /// Numbers of one type, as CBOR has them: a byte string, and its tag of RFC 8746.
    ///
    /// @param tag [NumberArray#UINT8] of a byte string without a tag
    record Numbers(int tag, ByteBuffer bytes) implements WireValue {}

    record Fields(Map<String, WireValue> values) implements WireValue {
        Optional<WireValue> find(String name) {
            return Optional.ofNullable(values.get(name));
        }

        /// The text of a field; empty when there is none, or it is none.
        Optional<String> text(String name) {
            return values.get(name) instanceof Text(String text) ? Optional.of(text) : Optional.empty();
        }

        /// The texts of a field, without what is none.
        List<String> texts(String name) {
            return values.get(name) instanceof Many(List<WireValue> all)
                    ? all.stream()
                            .filter(Text.class::isInstance)
                            .map(each -> ((Text) each).value())
                            .toList()
                    : List.of();
        }
    }

    /// For people: what it is.
    default String words() {
        return switch (this) {
            case Null _ -> "null";
            case Bool(boolean isTrue) -> String.valueOf(isTrue);
            case Int(long value) -> String.valueOf(value);
            case Real(double value) -> String.valueOf(value);
            case Text(String value) -> "'%s'".formatted(PeerText.shown(value, 80));
            case Many(List<WireValue> values) -> "a list of %d".formatted(values.size());
            case Numbers(int _, ByteBuffer bytes) -> "an array of %d bytes".formatted(bytes.remaining());
            case Fields(Map<String, WireValue> _) -> "an object";
        };
    }
}
