package rsal.jason;

import java.nio.charset.StandardCharsets;
import java.util.Map;
import rsal.agent.AgentType;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// Agents whose texts stand in tests.
final class Texts {
    private Texts() {}

    static AgentType type(String text) {
        return type(Map.of("a.asl", text));
    }

    /// @param texts by file, of which `a.asl` is the agent's own
    static AgentType type(Map<String, String> texts) {
        return new AgentSpeak().read("a.asl", files(texts), Location.of("scenario.yaml"));
    }

    private static FileSource files(Map<String, String> texts) {
        return (path, _, askedAt) -> {
            String text = texts.get(path);
            if (text == null) {
                throw new InvalidSettings(askedAt, "There is no file '%s'.".formatted(path), "");
            }
            return text.getBytes(StandardCharsets.UTF_8);
        };
    }
}
