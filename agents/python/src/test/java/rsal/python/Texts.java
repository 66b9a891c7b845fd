package rsal.python;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import rsal.agent.AgentType;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.testkit.OfficialPython;

/// Agents of tests, as texts.
final class Texts {
    private Texts() {}

    static AgentType type(String text) {
        return type("a.py", Map.of("a.py", text));
    }

    /// @param texts by file
    static AgentType type(String type, Map<String, String> texts) {
        usePython();
        return new PythonLanguage().read(type, files(texts), Location.of("scenario.yaml"));
    }

    /// The one with numpy. A test is skipped where it can't be had, and says so.
    static void usePython() {
        try {
            System.setProperty(
                    Interpreter.PROPERTY, OfficialPython.interpreter().toString());
        } catch (IOException e) {
            throw new AssertionError(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new AssertionError(e);
        }
    }

    static FileSource files(Map<String, String> texts) {
        return (path, _, askedAt) -> {
            String text = texts.get(path);
            if (text == null) {
                throw new InvalidSettings(askedAt, "There is no file '%s'.".formatted(path), "");
            }
            return text.getBytes(StandardCharsets.UTF_8);
        };
    }
}
