package rsal.cli;

import java.lang.reflect.RecordComponent;
import java.util.Comparator;
import java.util.Objects;
import java.util.ServiceLoader;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.agent.Topic;
import rsal.agent.TopicProvider;

/// The messages of agents and the readings of devices, as their sources tell of them.
final class MessageTypes {
    private MessageTypes() {}

    static String topics() {
        return ServiceLoader.load(TopicProvider.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(provider -> Reference.isShipped(provider.getClass()))
                .<Topic<?>>flatMap(provider -> provider.topics().stream())
                .sorted(Comparator.comparing(Topic::name))
                .map(topic -> section(topic.name(), topic.type()))
                .collect(Collectors.joining("\n"));
    }

    static String readings() {
        return DeviceTypes.readings()
                .sorted(Comparator.comparing(Class::getSimpleName))
                .map(reading -> section(reading.getSimpleName(), reading))
                .collect(Collectors.joining("\n"));
    }

    private static String section(String heading, Class<?> type) {
        SourceText source = SourceText.of(type);
        var text = new StringBuilder("### %s%n%n%s%n".formatted(heading, source.about()));
        text.append("\n* In Java: ").append(SourceText.link(type)).append('\n');
        RecordComponent[] fields = type.getRecordComponents();
        if (fields != null && fields.length > 0) {
            var table = new Markdown.Table("field", "type", "");
            Stream.of(fields)
                    .forEach(field -> table.row(
                            Markdown.code(field.getName()),
                            Markdown.code(simple(field.getGenericType().getTypeName())),
                            Objects.requireNonNull(
                                    source.parameters().get(field.getName()),
                                    () -> "%s says nothing of its field '%s'.".formatted(type, field.getName()))));
            text.append('\n').append(table);
        }
        return text.toString();
    }

    /// `java.util.List<rsal.data.Pose2d>` as `List<Pose2d>`.
    private static String simple(String type) {
        return type.replaceAll("[\\w.$]+[.$](\\w+)", "$1");
    }
}
