package rsal.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.testkit.Rounds;

class EditedScenarioTest {
    private static final String OWN = """
            rsal: 1
            scenario: own
            world: {file: small.world}
            robots: {one: {model: pioneer2dx, pose: [0, 0, 0]}}
            """;

    @TempDir
    Path folder;

    private String own() throws IOException {
        Files.writeString(folder.resolve("small.world"), "floorplan ( name \"floor\" size [10 10 1] )");
        return Files.writeString(folder.resolve("own.yaml"), OWN).toString();
    }

    @Test
    void isAmongTheFilesOfItsOwn() throws IOException {
        String file = own();
        Scenario edited = Scenario.edited(file, OWN.replace("scenario: own", "scenario: other"));

        assertThat(edited.name()).isEqualTo("other");
        assertThat(edited.isEdited()).isTrue();
        assertThat(edited.location()).isEqualTo(Scenario.load(file).location());
        assertThat(edited.plan(RunOptions.NONE).robots()).hasSize(1); // which needs the world beside it
        assertThat(Files.readString(Path.of(file))).isEqualTo(OWN);
        assertThatThrownBy(() -> Scenario.edited(file, OWN.replace("small.world", "../small.world"))
                        .check())
                .isInstanceOfSatisfying(
                        InvalidSettings.class, e -> assertThat(e.getMessage()).contains("small.world"));
    }

    @Test
    void isNoneWithTheSameText() throws IOException {
        String file = own();
        assertThat(Scenario.edited(file, OWN).isEdited()).isFalse();
        Scenario loaded = Scenario.load(file);
        assertThat(loaded.edited(OWN)).isSameAs(loaded);
    }

    @Test
    void isNoneOnceItsFileHasTheSameTextOrItHasThatOfItsFile() throws IOException {
        Path file = Path.of(own());
        String other = OWN.replace("scenario: own", "scenario: other");
        Scenario edited = Scenario.load(file.toString()).edited(other);
        assertThat(edited.edited(OWN).isEdited()).isFalse();

        Files.writeString(file, other + "# and more");
        assertThat(edited.isEdited()).isTrue();
        Files.writeString(file, other);
        assertThat(edited.isEdited()).isFalse();
        Files.delete(file);
        assertThat(edited.isEdited()).isTrue();
    }

    @Test
    void canBeEditedOnAndBeMadeAgainFromWhatWasRead() {
        Scenario built = Scenario.load("patrol");
        Scenario edited = built.edited(built.text().replace("scenario: patrol", "scenario: rounds"));
        Scenario again = edited.edited(edited.text() + "\n# nothing new\n");
        again.plan(RunOptions.NONE);

        assertThat(again.name()).isEqualTo("rounds");
        Scenario made = Scenario.again(again.location().file(), again.readFiles(), true);
        assertThat(made.text()).isEqualTo(again.text()).endsWith("# nothing new\n");
    }

    @Test
    void reportsWhereItsErrorsAre() {
        String text = Scenario.written("patrol").replace("robots:", "robotz:");
        int line = (int) text.substring(0, text.indexOf("robotz:")).lines().count() + 1;
        assertThatThrownBy(() -> Scenario.edited("patrol", text).check())
                .isInstanceOfSatisfying(
                        InvalidSettings.class,
                        e -> assertThat(e.problems()).anySatisfy(problem -> {
                            assertThat(problem.location()).isEqualTo(new Location("patrol/scenario.yaml", line, 1));
                            assertThat(problem.remedy()).contains("robots");
                        }));
    }

    @Test
    void isReadOfAFileWithErrorsToo() throws IOException {
        Path broken = Files.writeString(folder.resolve("broken.yaml"), "rsal: [1");
        assertThat(Scenario.written(broken.toString())).isEqualTo("rsal: [1");
        assertThat(Scenario.edited(broken.toString(), OWN.replace("file: small.world", "map: office"))
                        .name())
                .isEqualTo("own");
    }

    @Test
    void isNeverAWorldNorWhatIsNotThere() throws IOException {
        own();
        String world = folder.resolve("small.world").toString();
        assertThatThrownBy(() -> Scenario.written(world)).hasMessageContaining("is a world");
        assertThatThrownBy(() -> Scenario.load(world).edited("rsal: 1")).hasMessageContaining("is a world");
        assertThatThrownBy(() -> Scenario.edited("patroll", OWN)).hasMessageContaining("patrol");
    }

    static List<String> someOfThem() {
        List<String> all = Scenario.builtInNames();
        return all.subList(0, Rounds.of(3, all.size()));
    }

    /// Whatever a person has half written: it can be read, or is refused with its errors.
    @ParameterizedTest
    @MethodSource("someOfThem")
    void survivesAnyEdit(String name) {
        String whole = Scenario.written(name);
        for (int seed = 0; seed < Rounds.of(3, 12); seed++) {
            String text = scribbled(whole, new SplittableRandom(seed));
            try {
                Scenario.edited(name, text).check();
            } catch (InvalidSettings e) {
                assertThat(e.problems()).isNotEmpty();
            } catch (RuntimeException e) {
                throw new AssertionError("Seed %d of %s:%n%s".formatted(seed, name, text), e);
            }
        }
    }

    private static String scribbled(String whole, SplittableRandom random) {
        String[] pieces = {
            "",
            " ",
            "\n",
            "  ",
            ": ",
            "- ",
            "{",
            "}",
            "[",
            "]",
            "$",
            "*a",
            "&a ",
            "\"",
            "#",
            "-1",
            "1e99",
            "null",
            ".nan",
            "\u0000",
            "\t",
            "robots: ",
            "count: 0"
        };
        var text = new StringBuilder(whole);
        for (int edits = 1 + random.nextInt(3); edits > 0; edits--) {
            int at = random.nextInt(text.length());
            int end = Math.min(text.length(), at + (random.nextBoolean() ? 0 : random.nextInt(12)));
            text.replace(at, end, pieces[random.nextInt(pieces.length)]);
        }
        return text.toString();
    }
}
