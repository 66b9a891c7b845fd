package rsal.world.yaml;

import rsal.scene.Scene;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.settings.Problems;
import rsal.settings.Value;
import rsal.world.SceneFormat;
import rsal.yaml.Yaml;

/// Worlds of our own. What they name (images, maps, models, parts) is looked for beside them.
public final class YamlFormat implements SceneFormat {
    /// How the names of such worlds end.
    public static final String SUFFIX = ".world.yaml";

    private static final int MAX_BYTES = 1 << 24;
    private static final Yaml.Limits LIMITS = new Yaml.Limits(MAX_BYTES, 1_000_000);
    private static final int MAX_PROBLEMS = 50;

    @Override
    public String suffix() {
        return SUFFIX;
    }

    @Override
    public Scene read(String path, FileSource files, long seed) {
        var at = Location.of(path);
        Value.Mapping root = Yaml.read(path, files.text(path, MAX_BYTES, at), LIMITS);
        return new YamlWorldReader(path, root, beside(path, files), seed, new Problems(MAX_PROBLEMS)).scene();
    }

    private static FileSource beside(String path, FileSource files) {
        String folder = path.substring(0, path.lastIndexOf('/') + 1);
        return (name, most, askedAt) -> files.read(name.startsWith("/") ? name : folder + name, most, askedAt);
    }
}
