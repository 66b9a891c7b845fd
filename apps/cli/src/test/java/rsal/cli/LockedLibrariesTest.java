package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/// Maven holds what it fetches to `.mvn/checksums/checksums.sha256`, but asks nothing of what is missing there.
class LockedLibrariesTest {
    private static final Path LIST = Path.of("../../.mvn/checksums/checksums.sha256");

    @Test
    void eachLibraryHasItsChecksum() throws Exception {
        Map<String, String> locked = Files.readAllLines(LIST).stream()
                .map(line -> line.split(" {2}", 2))
                .collect(Collectors.toMap(
                        words -> Path.of(words[1]).getFileName().toString(), words -> words[0], (one, _) -> one));
        List<Path> libraries = Pattern.compile(File.pathSeparator)
                .splitAsStream(System.getProperty("java.class.path")
                        + File.pathSeparator
                        + System.getProperty("jdk.module.path", ""))
                .filter(entry ->
                        entry.endsWith(".jar") && !new File(entry).getName().startsWith("rsal-"))
                .map(Path::of)
                .toList();
        assertThat(libraries).hasSizeGreaterThan(50);
        assertThat(libraries)
                .allSatisfy(library -> assertThat(locked)
                        .as("after a change of versions: .ci/lock-checksums")
                        .containsEntry(library.getFileName().toString(), sha256(library)));
    }

    private static String sha256(Path file) throws Exception {
        return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(file)));
    }
}
