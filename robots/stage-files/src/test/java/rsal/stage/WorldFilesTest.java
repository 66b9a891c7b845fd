package rsal.stage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;

/// Where included files and images are looked for.
class WorldFilesTest {
    @TempDir
    private Path temp;

    private String world;

    @BeforeEach
    void setUp() throws IOException {
        Files.createDirectories(temp.resolve("worlds/robots"));
        Files.createDirectories(temp.resolve("shared"));
        world = temp.resolve("worlds/a.world").toString();
    }

    @Test
    void filesAreLookedForBesideTheWorldFirst() throws IOException {
        write("worlds/a.world", "include \"robots/cart.inc\"\ncart ( )");
        write("worlds/robots/cart.inc", "include \"wheel.inc\"\ndefine cart wheel ( )");
        write("worlds/wheel.inc", "define wheel model ( mass 1 )");
        write("worlds/robots/wheel.inc", "define wheel model ( mass 2 )");
        assertThat(mass(List.of())).isEqualTo(1);
    }

    @Test
    void thenBesideTheFileThatNamesThem() throws IOException {
        write("worlds/a.world", "include \"robots/cart.inc\"\ncart ( )");
        write("worlds/robots/cart.inc", "include \"wheel.inc\"\ndefine cart wheel ( )");
        write("worlds/robots/wheel.inc", "define wheel model ( mass 2 )");
        write("shared/wheel.inc", "define wheel model ( mass 3 )");
        assertThat(mass(List.of(temp.resolve("shared").toString()))).isEqualTo(2);
    }

    @Test
    void thenInTheFoldersOfTheSearchPath() throws IOException {
        write("worlds/a.world", "include \"lib/wheel.inc\"\nwheel ( )");
        write("shared/wheel.inc", "define wheel model ( mass 3 )");
        assertThat(mass(List.of(
                        temp.resolve("nowhere").toString(),
                        temp.resolve("shared").toString())))
                .isEqualTo(3);
    }

    @Test
    void filesMayBeInFoldersAbove() throws IOException {
        write("worlds/a.world", "include \"../shared/wheel.inc\"\nwheel ( )");
        write("shared/wheel.inc", "define wheel model ( mass 4 )");
        assertThat(mass(List.of())).isEqualTo(4);
    }

    @Test
    void filesMayBeNamedInFull() throws IOException {
        write("worlds/a.world", "include \"%s\"\nwheel ( )".formatted(temp.resolve("shared/wheel.inc")));
        write("shared/wheel.inc", "define wheel model ( mass 5 )");
        assertThat(mass(List.of())).isEqualTo(5);
    }

    @Test
    void aSlipInAFilesNameIsGuessed() throws IOException {
        write("worlds/a.world", "include \"robots/crat.inc\"");
        write("worlds/robots/cart.inc", "");
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> StageWorld.read(world, WorldFiles.onDisk(List.of())))
                .withMessage(world + ":1:1: There is no file '" + temp.resolve("worlds/robots/crat.inc")
                        + "'.\n    Maybe 'cart.inc' was meant?");
    }

    @Test
    void aSlipInTheWorldsOwnNameIsGuessed() throws IOException {
        write("worlds/a.world", "");
        String slip = temp.resolve("worlds/b.world").toString();
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> StageWorld.read(slip, WorldFiles.onDisk(List.of())))
                .withMessage(slip + ": There is no file '" + slip + "'.\n    Maybe 'a.world' was meant?");
    }

    @Test
    void whatIsThereButCanNotBeReadIsNotGuessedToBeMeant() throws IOException {
        write("worlds/a.world", "include \"robots\"\ninclude \".\"\nmodel ( bitmap \".\" )");
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> StageWorld.read(world, WorldFiles.onDisk(List.of())))
                .satisfies(e -> assertThat(e.problems())
                        .extracting(
                                problem -> problem.location().line() + " " + problem.message() + " " + problem.remedy())
                        .containsExactly(
                                "1 '%s' is a folder, not a file. Name a file in it."
                                        .formatted(temp.resolve("worlds/robots")),
                                "2 '%s' is a folder, not a file. Name a file in it.".formatted(temp.resolve("worlds")),
                                "3 '%s' is a folder, not a file. Name a file in it."
                                        .formatted(temp.resolve("worlds"))));
    }

    @Test
    void aWorldThatIsTooLargeIsReported() throws IOException {
        write("worlds/a.world", "#".repeat(Lexer.MAX_BYTES + 1));
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> StageWorld.read(world, WorldFiles.onDisk(List.of())))
                .withMessage(world + ": File '" + world + "' has more than 16 MiB, and no more is read.\n"
                        + "    Maybe it is another kind of file.");
        write("worlds/b.world", "include \"a.world\"");
        String including = temp.resolve("worlds/b.world").toString();
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> StageWorld.read(including, WorldFiles.onDisk(List.of())))
                .withMessage(including + ":1:1: File '" + world + "' has more than 16 MiB, and no more is read.\n"
                        + "    Maybe it is another kind of file.");
    }

    @Test
    void aSourceIsNeverLeft() throws IOException {
        write("worlds/a.world", "include \"../shared/wheel.inc\"\nwheel ( )");
        write("shared/wheel.inc", "define wheel model ( mass 4 )");
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> StageWorld.read("a.world", WorldFiles.in(FileSource.folder(temp.resolve("worlds")))))
                .withMessageStartingWith("a.world:1:1: '../shared/wheel.inc' lies outside of");
    }

    private double mass(List<String> searchPath) {
        return StageWorld.read(world, WorldFiles.onDisk(searchPath))
                .models()
                .getFirst()
                .traits()
                .mass();
    }

    private void write(String path, String text) throws IOException {
        Files.writeString(temp.resolve(path), text);
    }
}
