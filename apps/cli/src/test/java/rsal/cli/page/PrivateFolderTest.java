package rsal.cli.page;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PrivateFolderTest {
    @TempDir
    private Path parent;

    @Test
    void isFoundAgainAndForItsOwnerOnly() throws Exception {
        assertThat(PrivateFolder.existing(parent)).isEmpty();
        Path made = PrivateFolder.make(parent);
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(made)))
                .isEqualTo("rwx------");
        assertThat(PrivateFolder.make(parent)).isEqualTo(made);
        assertThat(PrivateFolder.existing(parent)).contains(made);
        assertThat(parent).isDirectoryContaining("glob:**/rsal-*");
    }

    @Test
    void oneThatOthersMayOpenIsRefused() throws Exception {
        Path made = PrivateFolder.make(parent);
        Files.setPosixFilePermissions(made, PosixFilePermissions.fromString("rwxrwx---"));
        assertRefused();
    }

    @Test
    void aLinkIsRefused() throws Exception {
        Path made = PrivateFolder.make(parent);
        Path elsewhere = Files.move(made, parent.resolve("elsewhere"));
        Files.createSymbolicLink(made, elsewhere);
        assertRefused();
    }

    @Test
    void aFolderOfAnotherUserIsRefused() throws Exception {
        Path made = PrivateFolder.make(parent);
        Path other = Files.move(made, parent.resolve("rsal-4242")); // as if user 4242 had made it
        assertThat(PrivateFolder.isOwn(made.resolveSibling(other.getFileName())))
                .isFalse();
    }

    private void assertRefused() {
        assertThat(PrivateFolder.existing(parent)).isEmpty();
        assertThatThrownBy(() -> PrivateFolder.make(parent))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("is not a folder of this user alone");
    }
}
