package rsal.stage.playercfg;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import rsal.scene.Scene;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

/// Configurations that stand in a test instead of on a disk, as `etc/test.cfg`.
final class Configs {
    static final String FILE = "etc/test.cfg";

    private final Map<String, byte[]> files = new HashMap<>();

    static Configs of(String text) {
        return new Configs().and(FILE, text);
    }

    Configs and(String path, String text) {
        return and(path, text.getBytes(StandardCharsets.ISO_8859_1));
    }

    Configs and(String path, byte[] bytes) {
        files.put(path, bytes);
        return this;
    }

    FileSource source() {
        return (path, most, askedAt) -> {
            byte[] bytes = files.get(path);
            if (bytes == null || bytes.length > most) {
                throw new InvalidSettings(askedAt, "There is no file '%s'.".formatted(path), "");
            }
            return bytes;
        };
    }

    Scene read() {
        return new PlayerFormat().read(FILE, source(), 1);
    }

    List<String> warnings() {
        return read().warnings().stream().map(Problem::toString).toList();
    }

    /// What is wrong with it, one entry for each error.
    List<String> errors() {
        try {
            read();
            return List.of();
        } catch (InvalidSettings e) {
            return e.problems().stream().map(Problem::toString).toList();
        }
    }
}
