package rsal.cli.page;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.common.jimfs.Configuration;
import com.google.common.jimfs.Jimfs;
import java.nio.file.FileSystem;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.settings.InvalidSettings;

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

    @Test
    void oneThatOthersReadIsNoticed(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("tokens");
        SecretFile.write(file, KEY);
        assertThat(SecretFile.isReadByOthers(file)).isFalse();
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r--r--"));
        assertThat(SecretFile.isReadByOthers(file)).isTrue();
    }

    @Test
    void aMissingFileIsNamed(@TempDir Path folder) {
        Path missing = folder.resolve("no.pem");
        for (ThrowingCallable read : List.<ThrowingCallable>of(
                () -> PemFiles.identity(missing, missing), () -> NetworkChoices.read(missing))) {
            assertThatThrownBy(read)
                    .isInstanceOf(InvalidSettings.class)
                    .hasMessageContaining("There is no file '%s'.", missing);
        }
    }
}
