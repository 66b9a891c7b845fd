package rsal.cli.page;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
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

    /// Those that are there: users of services and containers may have no home, and then a private temporary folder.
    private static Stream<Path> folders() {
        return Stream.<Supplier<Optional<Path>>>of(() -> Optional.of(folder()), PrivateFolder::existing)
                .flatMap(folder -> folder.get().stream());
    }

    private static String name(int port) {
        return "page-%d.token".formatted(port);
    }

    /// Keeps it until this program ends, however it does but by `kill -9`.
    ///
    /// @throws IOException if there is no folder that can be written
    void keep() throws IOException {
        try {
            keep(Files.createDirectories(folder()));
        } catch (IOException e) {
            try {
                keep(PrivateFolder.make());
            } catch (IOException second) {
                second.addSuppressed(e);
                throw second;
            }
        }
    }

    private void keep(Path folder) throws IOException {
        Path file = folder.resolve(name(port));
        SecretFile.write(file, token.getBytes(StandardCharsets.UTF_8));
        file.toFile().deleteOnExit();
    }

    /// That of a page; empty when there is none of this person's.
    static Optional<PageKey> of(int port) {
        return folders()
                .flatMap(folder -> token(folder.resolve(name(port))).stream())
                .findFirst()
                .map(token -> new PageKey(port, token));
    }

    private static Optional<String> token(Path file) {
        try {
            return Optional.of(Files.readString(file).strip());
        } catch (IOException e) {
            return Optional.empty(); // nobody is there, or somebody else
        }
    }

    /// Ports of this person's pages, the least first.
    static List<Integer> ports() {
        return folders().flatMap(PageKey::ports).distinct().sorted().toList();
    }

    private static Stream<Integer> ports(Path folder) {
        if (!Files.isDirectory(folder)) {
            return Stream.of();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files
                    .map(file -> NAME.matcher(file.getFileName().toString()))
                    .filter(Matcher::matches)
                    .map(name -> Integer.parseInt(name.group(1)))
                    .toList()
                    .stream();
        } catch (IOException | UncheckedIOException e) {
            return Stream.of();
        }
    }
}
