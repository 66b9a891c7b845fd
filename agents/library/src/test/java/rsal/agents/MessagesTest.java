package rsal.agents;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.agent.Topics;
import rsal.agent.message.Hello;
import rsal.agents.foraging.CollectGoal;
import rsal.agents.formation.FormationSlots;
import rsal.agents.patrol.Visited;
import rsal.agents.patrol.strategy.RandomWalk;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.settings.Arguments;
import rsal.settings.PluginChoice;

class MessagesTest {
    /// A message, or part of one, with one thing that it can't have.
    record Flaw(
            Class<? extends Record> type,
            int part,
            @Nullable Object value) {
        Record make() {
            @Nullable Object[] values = samples(type);
            values[part] = value;
            return MessagesTest.make(type, values);
        }

        @Override
        public String toString() {
            return type.getSimpleName() + " with " + type.getRecordComponents()[part].getName() + " " + value;
        }
    }

    private static Record make(Class<? extends Record> type, @Nullable Object[] values) {
        Class<?>[] types = Stream.of(type.getRecordComponents())
                .map(RecordComponent::getType)
                .toArray(Class[]::new);
        try {
            return type.getDeclaredConstructor(types).newInstance(values);
        } catch (InvocationTargetException e) {
            throw (RuntimeException) e.getCause();
        } catch (ReflectiveOperationException e) {
            throw new LinkageError(e.getMessage(), e);
        }
    }

    private static @Nullable Object[] samples(Class<? extends Record> type) {
        return Stream.of(type.getRecordComponents()).map(MessagesTest::sample).toArray();
    }

    private static Object sample(RecordComponent part) {
        return switch (part.getType().getSimpleName()) {
            case "String" -> "r1";
            case "double" -> 1.0;
            case "int" -> 1;
            case "boolean" -> true;
            case "Point2d" -> new Point2d(1, 2);
            case "Pose2d" -> new Pose2d(1, 2, 3);
            case "Rgb" -> new Rgb(44, 160, 44);
            case "CollectGoal" -> new CollectGoal(new Rgb(44, 160, 44), new Point2d(1, 2));
            case "Kind" -> Hello.Kind.HELLO;
            case "Duration" -> Duration.ofSeconds(1);
            case "List" -> List.of();
            case "PluginChoice" -> new PluginChoice(new RandomWalk(), Arguments.defaults(List.of()));
            case "NavigableMap" -> Collections.emptyNavigableMap();
            case "Map" -> Map.of();
            default -> {
                if (!part.getType().isRecord()) {
                    throw new AssertionError("Say here what a %s is like.".formatted(part));
                }
                Class<? extends Record> type = part.getType().asSubclass(Record.class);
                yield make(type, samples(type));
            }
        };
    }

    private static List<@Nullable Object> flaws(RecordComponent part) {
        var nowhere = new Point2d(Double.NaN, 2);
        return switch (part.getType().getSimpleName()) {
            case "int", "boolean" -> List.of();
            case "double" -> List.of(Double.NaN);
            case "Point2d" -> Arrays.asList(null, nowhere, new Point2d(1, Double.NaN));
            case "Pose2d" -> Arrays.asList(null, new Pose2d(Double.NaN, 2, 3), new Pose2d(1, 2, Double.NaN));
            case "List" ->
                ((ParameterizedType) part.getGenericType()).getActualTypeArguments()[0].equals(Point2d.class)
                        ? Arrays.asList(null, Collections.singletonList(null), List.of(nowhere))
                        : Arrays.asList(null, Collections.singletonList(null));
            case "NavigableMap" -> Arrays.asList(null, new TreeMap<>(Collections.singletonMap("r1", null)));
            default -> Collections.singletonList(null);
        };
    }

    static Stream<Flaw> flaws() {
        var all = new ArrayList<Flaw>();
        for (Class<? extends Record> type : types()) {
            make(type, samples(type)); // nothing else is wrong with it
            RecordComponent[] parts = type.getRecordComponents();
            for (int i = 0; i < parts.length; i++) {
                for (Object value : flaws(parts[i])) {
                    all.add(new Flaw(type, i, value));
                }
            }
        }
        assertThat(all).extracting(Flaw::type).contains(Visited.class, FormationSlots.Slot.class);
        return all.stream();
    }

    /// All records that are messages, and parts of them.
    private static List<Class<? extends Record>> types() {
        return Topics.installed().stream()
                .flatMap(topic -> Stream.concat(
                        Stream.of(topic.type()), Stream.of(topic.type().getDeclaredClasses())))
                .filter(Class::isRecord)
                .<Class<? extends Record>>map(type -> type.asSubclass(Record.class))
                .toList();
    }

    /// A topic that is not installed has no event in AgentSpeak, and somebody may use its name for something
    /// else.
    @Test
    void allTopicsAreInstalled() throws IOException {
        var sources = new ArrayList<String>();
        for (String folder : List.of("src/main/java", "../platform/src/main/java/rsal/agent")) {
            try (Stream<Path> files = Files.walk(Path.of(folder))) {
                for (Path file : files.filter(Files::isRegularFile).toList()) {
                    if (Files.readString(file).contains(" TOPIC = new Topic<>(")) {
                        sources.add(file.getFileName().toString().replace(".java", ""));
                    }
                }
            }
        }
        assertThat(Topics.installed())
                .extracting(topic -> topic.type().getSimpleName())
                .containsExactlyInAnyOrderElementsOf(sources);
    }

    @ParameterizedTest
    @MethodSource("flaws")
    void whoMakesWhatCantBeIsReported(Flaw flaw) {
        assertThatThrownBy(flaw::make)
                .isInstanceOfAny(IllegalArgumentException.class, NullPointerException.class)
                .hasMessageNotContaining("@");
    }
}
