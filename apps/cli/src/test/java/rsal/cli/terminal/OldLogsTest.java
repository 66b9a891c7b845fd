package rsal.cli.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OldLogsTest {
    @TempDir
    Path folder;

    @Test
    void theNewestAreKeptAndNothingElseIsTouched() throws IOException {
        for (int i = 0; i < 5; i++) {
            Path log = Files.createFile(folder.resolve("rsal-" + i + ".log"));
            Files.setLastModifiedTime(log, FileTime.fromMillis(1_000_000L * (i + 1)));
        }
        Path other = Files.createFile(folder.resolve("rsal-notes.log"));
        OldLogs.keepNewest(folder, 2);
        assertThat(folder)
                .isDirectoryNotContaining("glob:**rsal-[012].log")
                .isDirectoryContaining("glob:**rsal-3.log")
                .isDirectoryContaining("glob:**rsal-4.log");
        assertThat(other).exists();
    }
}
