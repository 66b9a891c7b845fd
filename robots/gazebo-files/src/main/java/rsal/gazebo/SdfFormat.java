package rsal.gazebo;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import rsal.scene.Scene;
import rsal.settings.FileSource;
import rsal.world.SceneFormat;

/// Worlds of Gazebo (`.sdf`). Those that Gazebo calls `.world` have the ending of Stage's, and are known by what is in
/// them: theirs is XML.
public final class SdfFormat implements SceneFormat {
    private static final int LOOKED_AT = 1_000; // bytes

    private final Map<String, String> environment;

    /// With the environment of this process.
    public SdfFormat() {
        this(System.getenv());
    }

    /// @param environment whose resource paths are searched
    SdfFormat(Map<String, String> environment) {
        this.environment = Map.copyOf(environment);
    }

    @Override
    public String suffix() {
        return ".sdf";
    }

    @Override
    public List<String> sharedSuffixes() {
        return List.of(".world");
    }

    @Override
    public boolean recognizes(byte[] content) {
        String beginning = new String(content, 0, Math.min(content.length, LOOKED_AT), StandardCharsets.UTF_8);
        return beginning.replace("\uFEFF", "").stripLeading().startsWith("<"); // no world of Stage can
    }

    @Override
    public Scene read(String path, FileSource files, long seed) {
        return new SdfWorldReader(path, new SdfFiles(files, path, environment)).scene();
    }
}
