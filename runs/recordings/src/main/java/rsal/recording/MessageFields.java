package rsal.recording;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;
import rsal.recording.proto.MessageType;
import rsal.recording.proto.ProtoReader;

/// A message that was read, by the names of its fields. What is not there has its default (0, empty).
record MessageFields(Map<?, ?> values) {
    /// @throws IOException when it is no such message
    static MessageFields read(MessageType type, ByteBuffer message) throws IOException {
        return new MessageFields(ProtoReader.read(type, message));
    }

    String text(String name) {
        return values.get(name) instanceof String text ? text : "";
    }

    double number(String name) {
        return values.get(name) instanceof Double number ? number : 0;
    }

    long count(String name) {
        return values.get(name) instanceof Long count ? count : 0;
    }

    boolean flag(String name) {
        return values.get(name) instanceof Boolean flag && flag;
    }

    byte[] bytes(String name) {
        return values.get(name) instanceof byte[] bytes ? bytes : new byte[0];
    }

    Optional<MessageFields> within(String name) {
        return values.get(name) instanceof Map<?, ?> map ? Optional.of(new MessageFields(map)) : Optional.empty();
    }

    List<MessageFields> all(String name) {
        return many(name).stream()
                .filter(Map.class::isInstance)
                .map(map -> new MessageFields((Map<?, ?>) map))
                .toList();
    }

    List<String> texts(String name) {
        return many(name).stream().map(String::valueOf).toList();
    }

    float[] floats(String name) {
        List<?> many = many(name);
        float[] floats = new float[many.size()];
        for (int i = 0; i < floats.length; i++) {
            floats[i] = many.get(i) instanceof Double number ? number.floatValue() : 0;
        }
        return floats;
    }

    double[] doubles(String name) {
        return many(name).stream()
                .mapToDouble(number -> number instanceof Double known ? known : 0)
                .toArray();
    }

    private List<?> many(String name) {
        return values.get(name) instanceof List<?> many ? many : List.of();
    }

    /// One of a few words; another one when it is none of them.
    <E extends Enum<E>> E word(Class<E> type, String name, E otherwise) {
        for (E word : type.getEnumConstants()) {
            if (word.name().equals(text(name))) {
                return word;
            }
        }
        return otherwise;
    }

    /// What a localizer believes. Where several hypotheses were held, an older recording has the best alone.
    PoseEstimate estimate() {
        Pose2d best = pose("pose").orElse(Pose2d.ORIGIN);
        List<Hypothesis> several = all("hypotheses").stream()
                .map(one ->
                        new Hypothesis(one.number("weight"), one.pose("pose").orElse(Pose2d.ORIGIN), one.covariance()))
                .toList();
        return new PoseEstimate(
                best,
                covariance(),
                several.isEmpty() ? List.of(new Hypothesis(1, best, covariance())) : several,
                number("confidence"),
                word(PoseEstimate.Quality.class, "quality", PoseEstimate.Quality.LOST));
    }

    private Covariance2d covariance() {
        return new Covariance2d(number("xx"), number("xy"), 0, number("yy"), 0, number("headings"));
    }

    /// One of ours: x, y, heading.
    Pose2d pose() {
        return new Pose2d(number("x"), number("y"), number("heading"));
    }

    Optional<Pose2d> pose(String name) {
        return within(name).map(MessageFields::pose);
    }

    /// One of Foxglove's, as seen from above.
    Pose2d foxglovePose(String name) {
        Optional<MessageFields> pose = within(name);
        Optional<MessageFields> position = pose.flatMap(all -> all.within("position"));
        Optional<MessageFields> turn = pose.flatMap(all -> all.within("orientation"));
        return new Pose2d(
                position.map(point -> point.number("x")).orElse(0.0),
                position.map(point -> point.number("y")).orElse(0.0),
                turn.map(q -> 2 * Math.atan2(q.number("z"), q.number("w"))).orElse(0.0));
    }
}
