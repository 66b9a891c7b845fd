package rsal.agent.message;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.agent.Topic;
import rsal.agent.platform.AgentPlatform.Status;
import rsal.agent.platform.Run;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;

class MessagesTest {
    private static final Topic<Record> ANY = new Topic<>("any", Record.class);

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
            case "NavigableMap" -> Collections.emptyNavigableMap();
            default -> throw new AssertionError("Say here what a %s is like.".formatted(part));
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

    static Stream<Flaw> flaws() throws ReflectiveOperationException, URISyntaxException {
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

    /// All records of the package.
    private static List<Class<? extends Record>> types() throws ReflectiveOperationException, URISyntaxException {
        Path classes = Path.of(
                Alarm.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        File[] files = classes.resolve("rsal/agent/message").toFile().listFiles();
        var types = new ArrayList<Class<? extends Record>>();
        for (File file : Objects.requireNonNull(files)) {
            Class<?> type = Class.forName("rsal.agent.message." + file.getName().replace(".class", ""));
            if (type.isRecord()) {
                types.add(type.asSubclass(Record.class));
            }
        }
        return types;
    }

    @Test
    void allTopicsAreReserved() throws ReflectiveOperationException, URISyntaxException {
        var topics = new ArrayList<Topic<?>>();
        for (Class<? extends Record> type : types()) {
            if (!type.isMemberClass()) { // else it is part of a message
                topics.add(
                        (Topic<?>) Objects.requireNonNull(type.getField("TOPIC").get(null)));
            }
        }
        assertThat(new CommonTopics().topics()).containsExactlyInAnyOrderElementsOf(topics);
    }

    @ParameterizedTest
    @MethodSource("flaws")
    void whoMakesWhatCantBeEndsAndNoneOfThoseWhoListen(Flaw flaw) {
        var run = new Run();
        var heard = new ArrayList<Record>();
        run.start("listener", self -> self.subscribe(ANY, message -> heard.add(message.content())));
        run.start("speaker", self -> self.publish(ANY, flaw.make()));
        run.advance(1);
        assertThat(run.view("speaker").status()).isEqualTo(Status.FAILED);
        assertThat(run.view("listener").status()).isEqualTo(Status.RUNNING);
        assertThat(heard).isEmpty();
    }
}
