package rsal.release;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.HashSet;
import java.util.Set;
import org.apache.commons.compress.archivers.zip.ZipFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ArchiveTest {
    private static final String LONG_NAME = "docs/" + "long".repeat(40) + ".html";

    @TempDir
    private Path folder;

    private Path input(String name, FileTime changed) throws IOException {
        Path input = Files.createDirectories(folder.resolve(name).resolve("inner"));
        Path script = Files.writeString(input.resolve("run.sh"), "#!/bin/sh\n");
        assertThat(script.toFile().setExecutable(true)).isTrue();
        Files.setLastModifiedTime(script, changed);
        Files.writeString(input.resolve("Größe.txt"), "Größe");
        return input.getParent();
    }

    private static FileTree tree(Path input) throws IOException {
        var tree = new FileTree();
        tree.addFolder("x", input, _ -> true);
        tree.add(LONG_NAME, "page".getBytes(StandardCharsets.UTF_8));
        return tree;
    }

    private static byte[] packed(Archive kind, FileTree tree) throws IOException {
        var bytes = new ByteArrayOutputStream();
        kind.write(tree, "top", bytes);
        return bytes.toByteArray();
    }

    @ParameterizedTest
    @EnumSource
    void theSameFilesGiveTheSameBytes(Archive kind) throws IOException {
        Path first = input("a", FileTime.fromMillis(0));
        Path second = input("b", FileTime.fromMillis(1_700_000_000_000L));
        assertThat(packed(kind, tree(second))).isEqualTo(packed(kind, tree(first)));
    }

    @Test
    void tarUnpacksThemWithMarksOfPrograms() throws Exception {
        Path file = folder.resolve("a.tar.gz");
        Archive.TAR_GZ.write(tree(input("a", FileTime.fromMillis(0))), "top", file);
        int code = new ProcessBuilder("tar", "-xzf", file.toString(), "-C", folder.toString())
                .inheritIO()
                .start()
                .waitFor();
        assertThat(code).isZero();
        Path top = folder.resolve("top");
        assertThat(top.resolve("x/inner/run.sh")).isExecutable().hasContent("#!/bin/sh");
        assertThat(Files.isExecutable(top.resolve("x/inner/Größe.txt"))).isFalse();
        assertThat(top.resolve(LONG_NAME)).hasContent("page");
        assertThat(Files.getLastModifiedTime(top.resolve(LONG_NAME)).toInstant())
                .hasToString("2026-01-01T00:00:00Z");
    }

    @Test
    void zipHasThemWithMarksOfPrograms() throws IOException {
        Path file = folder.resolve("a.zip");
        Archive.ZIP.write(tree(input("a", FileTime.fromMillis(0))), "top", file);
        try (var zip = ZipFile.builder().setPath(file).get()) {
            var programs = new HashSet<String>();
            zip.getEntries().asIterator().forEachRemaining(entry -> {
                if ((entry.getUnixMode() & 0111) != 0) {
                    programs.add(entry.getName());
                }
            });
            assertThat(programs).isEqualTo(Set.of("top/x/inner/run.sh"));
            assertThat(zip.getInputStream(zip.getEntry("top/x/inner/Größe.txt")))
                    .hasContent("Größe");
        }
    }

    @Test
    void whatFailsLeavesTheFormerFile() throws IOException {
        var tree = new FileTree();
        tree.add(
                "a",
                new FileTree.Content(
                        () -> {
                            throw new IOException("unreadable");
                        },
                        false));
        Path file = Files.writeString(folder.resolve("a.zip"), "former");
        assertThatThrownBy(() -> Archive.ZIP.write(tree, "top", file)).hasMessage("unreadable");
        assertThat(file).hasContent("former");
        try (var files = Files.list(folder)) {
            assertThat(files).containsExactly(file);
        }
    }

    @Test
    void aFolderHasOnlyTheFilesOfATree() throws IOException {
        Path target = Files.createDirectories(folder.resolve("target"));
        Files.writeString(Files.createDirectories(target.resolve("old")).resolve("a"), "former");
        tree(input("a", FileTime.fromMillis(0))).unpack(target);
        assertThat(target.resolve("old")).doesNotExist();
        assertThat(target.resolve("x/inner/Größe.txt")).hasContent("Größe");
        assertThat(target.resolve(LONG_NAME)).hasContent("page");
    }

    @Test
    void aPathIsThereOnce() {
        var tree = new FileTree();
        tree.add("a", new byte[0]);
        assertThatThrownBy(() -> tree.add("a", new byte[1])).hasMessage("'a' is there twice");
    }
}
