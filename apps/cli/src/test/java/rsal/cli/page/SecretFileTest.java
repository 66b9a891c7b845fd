package rsal.cli.page;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.common.jimfs.Configuration;
import com.google.common.jimfs.Jimfs;
import java.nio.file.FileSystem;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SecretFileTest {
    private static final byte[] KEY = {1, 2, 3};

    @Test
    void isForItsOwnerOnly(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("key");
        Files.writeString(file, "an older one that all may read");
        SecretFile.write(file, KEY);
        assertThat(file).hasBinaryContent(KEY);
        assertThat(Files.getPosixFilePermissions(file))
                .containsExactlyInAnyOrder(PosixFilePermission.OWNER_READ, PosixFilePermission.OWNER_WRITE);
    }

    @Test
    void isWrittenWhereFilesHaveNoSuchPermissions() throws Exception {
        try (FileSystem windows = Jimfs.newFileSystem(Configuration.windows())) {
            Path file = Files.createDirectories(windows.getPath("C:\\lab")).resolve("key");
            SecretFile.write(file, KEY);
            assertThat(Files.readAllBytes(file)).isEqualTo(KEY);
        }
    }
}
