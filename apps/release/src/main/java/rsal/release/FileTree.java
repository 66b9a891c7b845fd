package rsal.release;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Stream;

/// What a release has in it: files by their paths, with `/`, in sorted order.
final class FileTree {
    private final SortedMap<String, Content> files = new TreeMap<>();

    /// @param executable whether the system may run it
    record Content(Source source, boolean executable) {}

    /// The bytes of a file, read when they are packed.
    @FunctionalInterface
    interface Source {
        byte[] bytes() throws IOException;
    }

    void add(String path, byte[] bytes) {
        add(path, new Content(() -> bytes, false));
    }

    void add(String path, Content content) {
        if (files.put(path, content) != null) {
            throw new IllegalStateException("'%s' is there twice".formatted(path));
        }
    }

    /// Adds all files of a folder under a path. A symbolic link is added as what it links to.
    void addFolder(String path, Path folder, Predicate<String> wanted) throws IOException {
        try (Stream<Path> all = Files.walk(folder)) {
            List<Path> found = all.filter(Files::isRegularFile).toList();
            for (Path file : found) {
                String name = folder.relativize(file).toString().replace('\\', '/');
                if (wanted.test(name)) {
                    add(path + "/" + name, new Content(() -> Files.readAllBytes(file), Files.isExecutable(file)));
                }
            }
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    /// Writes all files to a folder, which then has nothing else.
    void unpack(Path folder) throws IOException {
        if (Files.exists(folder)) {
            try (Stream<Path> all = Files.walk(folder)) {
                List<Path> deepestFirst = all.sorted(Comparator.reverseOrder()).toList();
                for (Path each : deepestFirst) {
                    Files.delete(each);
                }
            }
        }
        Files.createDirectories(folder);
        for (Map.Entry<String, Content> file : files.entrySet()) {
            Path path = folder.resolve(file.getKey());
            Files.createDirectories(path.getParent());
            Files.write(path, file.getValue().source().bytes());
        }
    }

    SortedMap<String, Content> files() {
        return Collections.unmodifiableSortedMap(files);
    }
}
