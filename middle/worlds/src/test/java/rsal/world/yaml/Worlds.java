package rsal.world.yaml;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

/// Worlds that stand in a test instead of on a disk, as `hall.world.yaml`.
final class Worlds {
    static final String FILE = "hall.world.yaml";

    private final Map<String, byte[]> files = new HashMap<>();

    /// @param text after its first line
    static Worlds of(String text) {
        return new Worlds().and(FILE, "rsal: 1\n" + text);
    }

    Worlds and(String path, String text) {
        return and(path, text.getBytes(StandardCharsets.ISO_8859_1));
    }

    Worlds and(String path, byte[] bytes) {
        files.put(path, bytes);
        return this;
    }

    /// A picture, drawn with `#` for what is dark.
    Worlds andImage(String path, String drawn) {
        List<String> lines = drawn.lines().toList();
        var pgm = new StringBuilder("P2 %d %d 255\n".formatted(lines.getFirst().length(), lines.size()));
        for (String line : lines) {
            line.chars().forEach(c -> pgm.append(c == '#' ? "0 " : c == '+' ? "100 " : "255 "));
        }
        return and(path, pgm.toString());
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
        return read(1);
    }

    Scene read(long seed) {
        return new YamlFormat().read(FILE, source(), seed);
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

    static Entity thing(Scene scene, String name) {
        return scene.things().stream()
                .filter(thing -> thing.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    /// All that is in a scene; things that hold arrays have no equality of their own.
    static List<Object> parts(Scene scene) {
        return List.of(
                scene.title(),
                scene.walls(),
                scene.things(),
                scene.robots(),
                scene.robotBodies(),
                scene.odomFromBase(),
                scene.programs());
    }
}
