package rsal.server.message;

import com.fasterxml.jackson.annotation.Nulls;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JacksonException;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.TokenStreamLocation;
import tools.jackson.core.exc.StreamReadException;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.type.TypeReference;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.json.JsonMapper;

/// JSON in and out. Reading is strict: what was not asked for is an error, and so is what is missing.
public final class Json {
    private static final int MAX_DEPTH = 10;
    private static final JsonMapper MAPPER = JsonMapper.builder(JsonFactory.builder()
                    .streamReadConstraints(StreamReadConstraints.builder()
                            .maxNestingDepth(MAX_DEPTH)
                            .build())
                    .build())
            .enable(
                    DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES,
                    DeserializationFeature.FAIL_ON_NULL_CREATOR_PROPERTIES,
                    DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES,
                    DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .changeDefaultNullHandling(nulls -> nulls.withContentNulls(Nulls.FAIL))
            .build();

    private Json() {}

    public static String write(Object message) {
        return MAPPER.writeValueAsString(message);
    }

    /// @throws Refusal with a sentence about what is wrong with the text
    public static <T extends Record> T read(String text, Class<T> type) {
        return read(shape(type), () -> MAPPER.readValue(text, type));
    }

    /// Values by name.
    ///
    /// @param names that it may have, for people
    /// @throws Refusal with a sentence about what is wrong with the text
    public static Map<String, Object> readObject(String text, List<String> names) {
        return read("an object of " + String.join(", ", names), () -> MAPPER.readValue(text, new TypeReference<>() {}));
    }

    /// @param shape what the text is to be, for people
    private static <T> T read(String shape, Supplier<@Nullable T> reader) {
        try {
            T message = reader.get();
            if (message != null) {
                return message;
            }
            throw new Refusal(400, "This needs %s, not null.".formatted(shape));
        } catch (StreamReadException e) {
            TokenStreamLocation at = e.getLocation();
            throw new Refusal(
                    400,
                    "This needs %s, but it is not JSON from line %d, column %d on."
                            .formatted(shape, at.getLineNr(), at.getColumnNr()));
        } catch (JacksonException e) {
            String where = e.getPath().stream()
                    .map(JacksonException.Reference::getPropertyName)
                    .collect(Collectors.joining("."));
            throw new Refusal(
                    400,
                    "This needs %s.%s"
                            .formatted(shape, where.isEmpty() ? "" : " (" + where + ") is missing or wrong."));
        }
    }

    /// "an object of robot, x, y, heading"
    private static String shape(Class<? extends Record> type) {
        return Arrays.stream(type.getRecordComponents())
                .map(component -> component.getName())
                .collect(Collectors.joining(", ", "an object of ", ""));
    }
}
