package rsal.stage;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

/// World files that stand in a test instead of on a disk.
final class Worlds {
    private final Map<String, byte[]> files = new HashMap<>();

    /// A world of one file, `test.world`.
    static Worlds of(String text) {
        return new Worlds().and("test.world", text);
    }

    Worlds and(String path, String text) {
        return and(path, text.getBytes(StandardCharsets.UTF_8));
    }

    Worlds and(String path, byte[] bytes) {
        files.put(path, bytes);
        return this;
    }

    /// A picture, drawn with `#` for what is solid and blanks or dots for what is not.
    Worlds andImage(String path, String drawn) {
        List<String> lines = drawn.lines().toList();
        var pgm = new StringBuilder("P2 %d %d 255\n".formatted(lines.getFirst().length(), lines.size()));
        for (String line : lines) {
            line.chars().forEach(c -> pgm.append(c == '#' ? "0 " : "255 "));
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

    StageWorld read() {
        return StageWorld.read("test.world", WorldFiles.in(source()));
    }

    List<StageModel> models() {
        return read().models();
    }

    /// The only model at the top.
    StageModel model() {
        List<StageModel> models = models();
        if (models.size() != 1) {
            throw new AssertionError("There are %d models.".formatted(models.size()));
        }
        return models.getFirst();
    }

    /// All models by name.
    Map<String, StageModel> named() {
        var named = new HashMap<String, StageModel>();
        read().forEach(model -> named.put(model.name(), model));
        return named;
    }

    List<String> names() {
        var names = new ArrayList<String>();
        read().forEach(model -> names.add(model.name()));
        return names;
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
