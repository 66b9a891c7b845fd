package rsal.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.device.Navigator;
import rsal.settings.Arguments;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problem;

class JavaLanguageTest {
    private static final String LOAD = """
            import java.util.List;
            import rsal.agent.*;
            import rsal.device.*;
            import rsal.settings.*;

            public final class Loader implements AgentType {
                private static final Parameter<Double> MOST = Parameter.number("most", 3, 1, 9, "kg", "How much it takes.");

                public String key() { return "loader"; }
                public String description() { return "Loads."; }
                public List<Parameter<?>> parameters() {
                    return List.of(MOST);
                }
                public List<Class<? extends Device>> needs() { return List.of(Navigator.class); }
                public boolean yields() { return true; }
                public Agent create(Arguments arguments) {
                    return self -> self.publish(Load.TOPIC, new Load(arguments.get(MOST)));
                }
            }
            """;
    private static final String LOAD_MESSAGE = """
            import rsal.agent.Topic;

            public record Load(double mass) {
                public static final Topic<Load> TOPIC = new Topic<>("load", Load.class);
            }
            """;
    private static final String LISTENER = """
            import rsal.agent.*;

            /// Listens to loads.
            /// And more.
            public class Listener implements Agent {
                public static final Topic<?> HEARS = Load.TOPIC;
                public void start(AgentContext self) { self.subscribe(Load.TOPIC, message -> {}); }
            }
            """;

    @TempDir
    private Path folder;

    private final JavaLanguage java = new JavaLanguage();
    private Location scenario;

    @BeforeEach
    void nameTheScenario() {
        scenario = new Location(folder.resolve("own.yaml").toString(), 7, 11);
    }

    private void write(String name, String text) {
        try {
            Files.createDirectories(folder.resolve(name).getParent());
            Files.writeString(folder.resolve(name), text);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private AgentType read(String name) {
        return java.read(name, FileSource.folder(folder), scenario);
    }

    private static List<Problem> errors(ThrowingCallable reading) {
        var errors = new ArrayList<Problem>();
        assertThatThrownBy(reading).isInstanceOfSatisfying(InvalidSettings.class, e -> errors.addAll(e.problems()));
        return errors;
    }

    private static Class<?> classOf(AgentType type) {
        return type.create(Arguments.defaults(type.parameters())).getClass();
    }

    @Test
    void aTypeIsAsItSaysOfItselfButCalledByItsFile() {
        write("Loader.java", LOAD);
        write("Load.java", LOAD_MESSAGE);
        AgentType type = read("Loader.java");
        assertThat(type.key()).isEqualTo("Loader.java");
        assertThat(type.description()).isEqualTo("Loads.");
        assertThat(type.parameters())
                .singleElement()
                .satisfies(most -> assertThat(most.name()).isEqualTo("most"));
        assertThat(type.needs()).containsExactly(Navigator.class);
        assertThat(type.drives(Arguments.defaults(type.parameters()))).isTrue();
        assertThat(type.yields()).isTrue();
    }

    @Test
    void anAgentWithoutParametersIsATypeOfItsOwn() {
        write("agents/Listener.java", LISTENER);
        write("agents/Load.java", LOAD_MESSAGE);
        AgentType type = read("agents/Listener.java");
        assertThat(type.key()).isEqualTo("agents/Listener.java");
        assertThat(type.description()).isEqualTo("Listens to loads.");
        assertThat(type.parameters()).isEmpty();
        Agent first = type.create(Arguments.of(List.of(), Map.of()));
        assertThat(type.create(Arguments.of(List.of(), Map.of()))).isNotSameAs(first);
    }

    @Test
    void agentsOfOneFolderHaveTheSameMessages() throws Exception {
        write("Loader.java", LOAD);
        write("Load.java", LOAD_MESSAGE);
        write("Listener.java", LISTENER);
        Class<?> loader = classOf(read("Loader.java"));
        Class<?> listener = classOf(read("Listener.java"));
        assertThat(loader.getClassLoader().loadClass("Load"))
                .isSameAs(listener.getClassLoader().loadClass("Load"));
    }

    @Test
    void whatHasNotChangedIsNotCompiledAgain() {
        write("Listener.java", LISTENER);
        write("Load.java", LOAD_MESSAGE);
        Class<?> first = classOf(read("Listener.java"));
        assertThat(classOf(read("Listener.java"))).isSameAs(first);

        write("Load.java", LOAD_MESSAGE.replace("mass", "weight"));
        Class<?> second = classOf(read("Listener.java"));
        assertThat(second).isNotSameAs(first);
        assertThat(classOf(read("Listener.java"))).isSameAs(second);
    }

    @Test
    void aPackageIsItsOwnAffair() {
        write("Listener.java", "package lab.hunt;\n" + LISTENER);
        write("Load.java", "package lab.hunt;\n" + LOAD_MESSAGE);
        assertThat(classOf(read("Listener.java")).getName()).isEqualTo("lab.hunt.Listener");
    }

    @Test
    void allErrorsAreReportedWhereTheyAre() {
        write("Listener.java", LISTENER.replace("subscribe", "subscrib").replace("{});", "{}); int x = \"y\";"));
        List<Problem> errors = errors(() -> read("Listener.java"));
        assertThat(errors).hasSizeGreaterThan(1).allSatisfy(error -> {
            assertThat(error.location().file()).isEqualTo("Listener.java");
            assertThat(error.location().line()).isBetween(6, 7);
            assertThat(error.message()).startsWith("Java can't compile this: ");
        });
        assertThat(errors.getFirst().remedy()).contains("'Load.java'");
    }

    @Test
    void anErrorInAFileThatItNeedsIsReportedThere() {
        write("Listener.java", LISTENER);
        write("Load.java", LOAD_MESSAGE.replace("double", "dubble"));
        assertThat(errors(() -> read("Listener.java")))
                .extracting(error -> error.location().toString())
                .containsExactly("Load.java:3:20");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '"', textBlock = """
            class Other {}                                               | There is no class 'Mine' in this file.
            public class Mine {}                                         | Class 'Mine' is not of the kind 'agent'.
            class Mine implements rsal.agent.Agent { public void start(rsal.agent.AgentContext self) {} } | can't be used as an agent
            public abstract class Mine implements rsal.agent.Agent {}    | can't be used as an agent
            public class Mine implements rsal.agent.Agent { public Mine(int x) {} public void start(rsal.agent.AgentContext self) {} } | can't be used as an agent
            public class Mine implements rsal.agent.AgentType { public String key() { return ""; } public String description() { throw new IllegalStateException("no words"); } public rsal.agent.Agent create(rsal.settings.Arguments a) { return self -> {}; } } | Class 'Mine' fails: java.lang.IllegalStateException: no words.
            public class Mine implements rsal.agent.AgentType { static int x = 1 / Integer.parseInt("0"); public String key() { return ""; } public String description() { return ""; } public rsal.agent.Agent create(rsal.settings.Arguments a) { return self -> {}; } } | Class 'Mine' fails: java.lang.ArithmeticException: / by zero.
            ""                                                           | There is no class 'Mine' in this file.
            """)
    void whatIsNoAgentIsRefused(String text, String message) {
        write("Mine.java", text);
        assertThat(errors(() -> read("Mine.java")).getFirst().toString())
                .startsWith("Mine.java")
                .contains(message);
    }

    @Test
    void classesOfOursAreNotReplaced() {
        write("Agent.java", "package rsal.agent;\npublic interface Agent { void start(AgentContext self); }\n");
        assertThat(errors(() -> read("Agent.java")).getFirst().message())
                .isEqualTo("RSAL has a class 'rsal.agent.Agent' already.");
    }

    @Test
    void aFileThatIsNotThereIsReportedWhereItIsNamed() {
        assertThat(errors(() -> read("Nobody.java")).getFirst().location()).isEqualTo(scenario);
    }

    @ParameterizedTest
    @ValueSource(strings = {"My Hunter.java", "2hunters.java", ".java", "a/b-c.java", "%41.java"})
    void aNameThatNoClassCanHaveIsRefused(String name) {
        write(name, LISTENER);
        assertThat(errors(() -> read(name)).getFirst().toString()).contains("A Java file can't be called");
    }

    /// Else what an author says would be forgotten as soon as there is something new to say.
    @Test
    void allThatATypeMaySayIsAsked() {
        List<String> own = Arrays.stream(JavaType.class.getDeclaredMethods())
                .map(Method::getName)
                .toList();
        assertThat(Arrays.stream(AgentType.class.getMethods()).map(Method::getName))
                .isSubsetOf(own);
        assertThat(Arrays.stream(JavaType.class.getDeclaredMethods())
                        .filter(method -> method.getName().equals("needs")))
                .hasSize(2);
    }
}
