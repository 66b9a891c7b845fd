package rsal.scenario.installed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.agent.AgentType;
import rsal.scenario.SecondWanderer;
import rsal.settings.InvalidSettings;

class ProvidersTest {
    @TempDir
    private Path folder;

    @Test
    void findsThemByKey() throws IOException {
        assertThat(agentsWith("")).containsKeys("follow", "wanderer");
    }

    @Test
    void saysWhichClassIsNotThere() {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> agentsWith("own.Wandere"))
                .withMessageContainingAll(
                        "META-INF/services/rsal.agent.AgentType: ", "own.Wandere", "public AgentType");
    }

    @Test
    void saysWhichClassIsSomethingElse() {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> agentsWith("rsal.agent.AgentType"))
                .withMessageContainingAll("rsal.agent.AgentType", "public AgentType");
    }

    @Test
    void saysWhichTwoHaveTheSameKey() {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> agentsWith(SecondWanderer.class.getName()))
                .withMessageContainingAll("rsal.testkit.example.Wanderer", "SecondWanderer", "both called 'wanderer'");
    }

    /// All types of agents, as if one more were installed.
    private Map<String, AgentType> agentsWith(String className) throws IOException {
        Path services = Files.createDirectories(folder.resolve("META-INF/services"));
        Files.writeString(services.resolve(AgentType.class.getName()), className);
        Thread thread = Thread.currentThread();
        ClassLoader before = thread.getContextClassLoader();
        try (var loader = new URLClassLoader(new URL[] {folder.toUri().toURL()}, before)) {
            thread.setContextClassLoader(loader);
            return Providers.byKey(AgentType.class, AgentType::key);
        } finally {
            thread.setContextClassLoader(before);
        }
    }
}
