package rsal.ros2.rosbridge;

import java.io.StringWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.json.JsonReadFeature;
import tools.jackson.core.json.JsonWriteFeature;

/// JSON as rosbridge speaks it. It is Python's: NaN and infinity may be written as `NaN` and `Infinity`, in
/// both directions.
final class Json {
    private static final int MOST_LEVELS = 64;
    private static final JsonFactory FACTORY = JsonFactory.builder()
            .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
            .disable(JsonWriteFeature.WRITE_NAN_AS_STRINGS)
            .streamReadConstraints(StreamReadConstraints.builder()
                    .maxNestingDepth(MOST_LEVELS)
                    .maxStringLength(RosbridgeTransport.MOST_BYTES)
                    .build())
            .build();

    private Json() {}

    static Value read(String text) throws InvalidMessage {
        try (JsonParser parser = FACTORY.createParser(ObjectReadContext.empty(), text)) {
            Value value = value(parser, parser.nextToken());
            if (parser.nextToken() != null) {
                throw new InvalidMessage("Something follows a value of JSON.");
            }
            return value;
        } catch (JacksonException e) {
            throw new InvalidMessage("It is no JSON: %s".formatted(e.getOriginalMessage()), e);
        }
    }

    private static Value value(JsonParser parser, JsonToken token) throws InvalidMessage {
        return switch (token) {
            case null -> throw new InvalidMessage("It is empty.");
            case START_OBJECT -> {
                Map<String, Value> fields = new LinkedHashMap<>();
                while (parser.nextToken() == JsonToken.PROPERTY_NAME) {
                    String name = parser.currentName();
                    fields.put(name, value(parser, parser.nextToken()));
                }
                yield new Value.Fields(fields);
            }
            case START_ARRAY -> {
                List<Value> values = new ArrayList<>();
                for (JsonToken next = parser.nextToken(); next != JsonToken.END_ARRAY; next = parser.nextToken()) {
                    values.add(value(parser, next));
                }
                yield new Value.Many(values);
            }
            case VALUE_STRING -> new Value.Text(parser.getString());
            case VALUE_NUMBER_INT -> integer(parser);
            case VALUE_NUMBER_FLOAT -> new Value.Real(parser.getDoubleValue());
            case VALUE_TRUE -> new Value.Bool(true);
            case VALUE_FALSE -> new Value.Bool(false);
            case VALUE_NULL -> new Value.Null();
            default -> throw new InvalidMessage("JSON can't have %s here.".formatted(token));
        };
    }

    private static Value integer(JsonParser parser) {
        if (parser.getNumberType() != JsonParser.NumberType.BIG_INTEGER) {
            return new Value.Int(parser.getLongValue());
        }
        var big = parser.getBigIntegerValue();
        boolean isUnsigned = big.signum() > 0 && big.bitLength() <= Long.SIZE;
        return isUnsigned ? new Value.Int(big.longValue()) : new Value.Real(big.doubleValue());
    }

    /// An object.
    static String write(Consumer<JsonGenerator> fields) {
        var text = new StringWriter();
        try (JsonGenerator out = FACTORY.createGenerator(ObjectWriteContext.empty(), text)) {
            out.writeStartObject();
            fields.accept(out);
            out.writeEndObject();
        }
        return text.toString();
    }
}
