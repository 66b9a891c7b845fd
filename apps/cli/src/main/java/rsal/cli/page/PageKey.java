package rsal.cli.page;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/// Lets commands of the same person change a run that has a page: its token lies in a file that nobody else may read,
/// as long as the page is there.
record PageKey(int port, String token) {
    private static final Pattern NAME = Pattern.compile("page-(\\d{1,5})\\.token");

    /// Where such files are: the folder that the system has for what only counts while somebody is logged in, else one
    /// in their home.
    static Path folder() {
        return Optional.ofNullable(System.getenv("XDG_RUNTIME_DIR"))
                .filter(folder -> !folder.isEmpty())
                .map(folder -> Path.of(folder, "rsal"))
                .orElseGet(() -> Path.of(System.getProperty("user.home"), ".cache", "rsal"));
    }

    private static Path file(int port) {
        return folder().resolve("page-%d.token".formatted(port));
    }

    /// Keeps it until this program ends, however it does but by `kill -9`.
    void keep() throws IOException {
        Path file = file(port);
        Files.createDirectories(file.getParent());
        SecretFile.write(file, token.getBytes(StandardCharsets.UTF_8));
        file.toFile().deleteOnExit();
    }

    /// That of a page; empty when there is none of this person's.
    static Optional<PageKey> of(int port) {
        try {
            return Optional.of(new PageKey(port, Files.readString(file(port)).strip()));
        } catch (IOException e) {
            return Optional.empty(); // nobody is there, or somebody else
        }
    }

    /// Ports of this person's pages, the least first.
    static List<Integer> ports() {
        if (!Files.isDirectory(folder())) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder())) {
            return files.map(file -> NAME.matcher(file.getFileName().toString()))
                    .filter(Matcher::matches)
                    .map(name -> Integer.parseInt(name.group(1)))
                    .sorted()
                    .toList();
        } catch (IOException | UncheckedIOException e) {
            return List.of();
        }
    }
}
