package rsal.sim.stage;

import java.io.File;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.scene.Scene;
import rsal.scene.SceneFormat;
import rsal.settings.FileSource;

/// World files of Stage 4 (`.world`). What they include is looked for in the folders of the environment's
/// `STAGEPATH`, too, when all files may be read.
public final class StageFormat implements SceneFormat {
    @Override
    public String suffix() {
        return ".world";
    }

    @Override
    public Scene read(String path, FileSource files, long seed) {
        WorldFiles found = files.everywhere() ? WorldFiles.onDisk(searchPath()) : WorldFiles.in(files);
        return new SceneMaker(StageWorld.read(path, found), path, seed).scene();
    }

    private static List<String> searchPath() {
        return Optional.ofNullable(System.getenv("STAGEPATH")).stream()
                .flatMap(folders -> Stream.of(folders.split(File.pathSeparator)))
                .filter(folder -> !folder.isBlank())
                .toList();
    }
}
