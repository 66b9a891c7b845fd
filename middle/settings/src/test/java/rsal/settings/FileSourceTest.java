package rsal.settings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FileSourceTest {
    private static final Location HERE = new Location("hunt.yaml", 3, 8);

    @TempDir
    private Path temp;

    private FileSource source;

    @BeforeEach
    void setUp() throws IOException {
        Path inside = Files.createDirectories(temp.resolve("inside/maps")).getParent();
        Files.writeString(inside.resolve("a.txt"), "inside");
        Files.writeString(temp.resolve("secret.txt"), "outside");
        Files.createDirectory(temp.resolve("inside2"));
        Files.writeString(temp.resolve("inside2/b.txt"), "beside");
        Files.createSymbolicLink(inside.resolve("way-out"), temp.resolve("secret.txt"));
        Files.createSymbolicLink(inside.resolve("way-back"), inside.resolve("a.txt"));
        source = FileSource.folder(inside);
    }

    @Test
    void readsFilesOfItsFolder() {
        assertThat(source.text("a.txt", 100, HERE)).isEqualTo("inside");
        assertThat(source.text("maps/../a.txt", 100, HERE)).isEqualTo("inside");
        assertThat(source.text("way-back", 100, HERE)).isEqualTo("inside");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "../secret.txt",
                "maps/../../secret.txt",
                "../inside2/b.txt",
                "way-out",
                "/etc/passwd",
                "nothing.txt",
                "maps",
                "",
                "a\0b"
            })
    void readsNothingElse(String path) {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> source.read(path, 100, HERE))
                .withMessageStartingWith("hunt.yaml:3:8: ");
    }

    @Test
    void guessesWhichFileWasMeantAmongThoseItMayRead() {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> source.read("b.txt", 100, HERE))
                .withMessageContaining("Maybe 'a.txt' was meant?");
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> source.read("other.yaml", 100, HERE))
                .withMessageContaining("It is looked for in");
        for (String outside : new String[] {"../secrets.txt", "../inside2/c.txt", "maps/../../secrets.txt"}) {
            assertThatExceptionOfType(InvalidSettings.class)
                    .isThrownBy(() -> source.read(outside, 100, HERE))
                    .withMessageNotContaining("Maybe");
        }
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> FileSource.disk().read(temp + "/secrets.txt", 100, HERE))
                .withMessageContaining("There is no file '" + temp + "/secrets.txt'")
                .withMessageContaining("Maybe 'secret.txt' was meant?");
    }

    @Test
    void readsNoMoreThanIsAllowed() {
        assertThat(source.read("a.txt", 6, HERE)).hasSize(6);
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> source.read("a.txt", 5, HERE))
                .withMessageContaining("more than 5 bytes");
    }

    @Test
    void reportsWhatIsTooLargeInMebibytes() throws IOException {
        Files.write(temp.resolve("inside/large"), new byte[(1 << 20) + 1]);
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> source.read("large", 1 << 20, HERE))
                .withMessageEndingWith("File 'large' has more than 1 MiB, and no more is read.\n"
                        + "    Maybe it is another kind of file.");
    }

    @Test
    void distinguishesFoldersFromFiles() {
        for (FileSource each : List.of(source, FileSource.disk())) {
            assertThatExceptionOfType(InvalidSettings.class)
                    .isThrownBy(() -> each.read(".", 5, HERE))
                    .withMessageEndingWith("'.' is a folder, not a file.\n    Name a file in it.");
        }
    }

    @Test
    void refusesTextThatIsNone() throws IOException {
        Files.write(temp.resolve("inside/binary"), new byte[] {(byte) 0xff, (byte) 0xfe});
        assertThatExceptionOfType(InvalidSettings.class).isThrownBy(() -> source.text("binary", 100, HERE));
    }

    @Test
    void resourcesCannotBeLeftEither() {
        FileSource resources = FileSource.resources(FileSource.class, "/rsal/settings/");
        assertThat(resources.text("x11-colors.txt", 100_000, HERE)).contains("aliceblue");
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> resources.read("../settings/x11-colors.txt", 100_000, HERE));
    }
}
