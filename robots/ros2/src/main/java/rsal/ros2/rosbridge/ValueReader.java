package rsal.ros2.rosbridge;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.json.JsonReadFeature;
import tools.jackson.dataformat.cbor.CBORFactory;
import tools.jackson.dataformat.cbor.CBORParser;

/// Reads what a server sends. Its JSON is Python's, which may have `NaN` and `Infinity`.
final class ValueReader {
    private static final int MOST_OBJECTS = 200_000; // in a message; a cloud has four for each particle

    private static final StreamReadConstraints LIMITS = StreamReadConstraints.builder()
            .maxNestingDepth(64)
            .maxStringLength(RosbridgeTransport.MOST_BYTES)
            .build();
    private static final JsonFactory JSON = JsonFactory.builder()
            .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
            .streamReadConstraints(LIMITS)
            .build();
    private static final CBORFactory CBOR =
            CBORFactory.builder().streamReadConstraints(LIMITS).build();

    private final JsonParser parser;
    private int objects;

    private ValueReader(JsonParser parser) {
        this.parser = parser;
    }

    static WireValue json(String text) throws InvalidMessage {
        try (JsonParser parser = JSON.createParser(ObjectReadContext.empty(), text)) {
            return new ValueReader(parser).whole();
        } catch (JacksonException e) {
            throw new InvalidMessage("It is not JSON: %s".formatted(e.getOriginalMessage()), e);
        }
    }

    /// @param bytes from their position to their limit
    static WireValue cbor(ByteBuffer bytes) throws InvalidMessage {
        var copy = new byte[bytes.remaining()];
        bytes.duplicate().get(copy);
        try (JsonParser parser = CBOR.createParser(ObjectReadContext.empty(), copy)) {
            return new ValueReader(parser).whole();
        } catch (JacksonException e) {
            throw new InvalidMessage("It is not CBOR: %s".formatted(e.getOriginalMessage()), e);
        }
    }

    private WireValue whole() throws InvalidMessage {
        WireValue value = value(parser.nextToken());
        if (parser.nextToken() != null) {
            throw new InvalidMessage("Something follows its end.");
        }
        return value;
    }

    private WireValue value(JsonToken token) throws InvalidMessage {
        return switch (token) {
            case null -> throw new InvalidMessage("It is empty.");
            case START_OBJECT -> {
                objects++;
                if (objects > MOST_OBJECTS) {
                    throw new InvalidMessage("It has more than %d objects.".formatted(MOST_OBJECTS));
                }
                Map<String, WireValue> fields = new LinkedHashMap<>();
                while (parser.nextToken() == JsonToken.PROPERTY_NAME) {
                    String name = parser.currentName();
                    fields.put(name, value(parser.nextToken()));
                }
                yield new WireValue.Fields(fields);
            }
            case START_ARRAY -> {
                List<WireValue> values = new ArrayList<>();
                for (JsonToken next = parser.nextToken(); next != JsonToken.END_ARRAY; next = parser.nextToken()) {
                    values.add(value(next));
                }
                yield new WireValue.Many(values);
            }
            case VALUE_STRING -> new WireValue.Text(parser.getString());
            case VALUE_NUMBER_INT -> integer();
            case VALUE_NUMBER_FLOAT -> new WireValue.Real(parser.getDoubleValue());
            case VALUE_TRUE -> new WireValue.Bool(true);
            case VALUE_FALSE -> new WireValue.Bool(false);
            case VALUE_NULL -> new WireValue.Null();
            case VALUE_EMBEDDED_OBJECT -> bytes();
            default -> throw new InvalidMessage("It can't have %s here.".formatted(token));
        };
    }

    /// A byte string of CBOR, and the tag in front of it.
    private WireValue bytes() {
        int tag = parser instanceof CBORParser cbor ? cbor.getCurrentTag() : 0;
        int known = NumberArray.isTag(tag) ? tag : NumberArray.UINT8;
        return parser.getEmbeddedObject() instanceof byte[] bytes
                ? new WireValue.Numbers(known, ByteBuffer.wrap(bytes))
                : new WireValue.Null(); // what is undefined
    }

    private WireValue integer() {
        if (parser.getNumberType() != JsonParser.NumberType.BIG_INTEGER) {
            return new WireValue.Int(parser.getLongValue());
        }
        var big = parser.getBigIntegerValue();
        boolean isUnsigned = big.signum() > 0 && big.bitLength() <= Long.SIZE;
        return isUnsigned ? new WireValue.Int(big.longValue()) : new WireValue.Real(big.doubleValue());
    }
}
