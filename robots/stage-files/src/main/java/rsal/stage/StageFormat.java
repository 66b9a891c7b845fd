package rsal.stage;

import java.io.File;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.scene.Scene;
import rsal.settings.FileSource;
import rsal.world.SceneFormat;

/// World files of Stage 4 (`.world`). What they include is looked for in the folders of the environment's
/// `STAGEPATH`, too, when all files may be read.
public final class StageFormat implements SceneFormat {
    @Override
    public String suffix() {
        return ".world";
    }

    @Override
    public Scene read(String path, FileSource files, long seed) {
        return scene(StageWorld.read(path, files(files)), path, seed);
    }

    /// What becomes of a world.
    ///
    /// @param path of its file, for messages
    /// @param seed for what it leaves to chance
    public static Scene scene(StageWorld world, String path, long seed) {
        return new SceneMaker(world, path, seed).scene();
    }

    /// Where worlds and what they name are looked for.
    public static WorldFiles files(FileSource files) {
        return files.everywhere() ? WorldFiles.onDisk(searchPath()) : WorldFiles.in(files);
    }

    private static List<String> searchPath() {
        return Optional.ofNullable(System.getenv("STAGEPATH")).stream()
                .flatMap(folders -> Stream.of(folders.split(File.pathSeparator)))
                .filter(folder -> !folder.isBlank())
                .toList();
    }
}
