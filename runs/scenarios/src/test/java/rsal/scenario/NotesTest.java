package rsal.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

class NotesTest {
    @TempDir
    private Path folder;

    private String world(String text) throws IOException {
        return Files.writeString(folder.resolve("some.world.yaml"), text).toString();
    }

    @Test
    void aWorldWithNothingInItIsReportedWhenItIsReadOrRun() throws IOException {
        String empty = world("rsal: 1\n");
        assertThat(Scenario.scene(empty).warnings())
                .extracting(Problem::message)
                .containsExactly("There is nothing in this world: no wall, no thing, no robot.");
        assertThat(Scenario.load(empty).plan(RunOptions.NONE).notes())
                .isEqualTo(Scenario.scene(empty).warnings());
    }

    @Test
    void aWorldWithoutRobotsIsReportedOnlyWhenItIsRun() throws IOException {
        String still = world("rsal: 1\nwalls: [{radius: 1, center: [0, 0]}]\n");
        assertThat(Scenario.scene(still).warnings()).isEmpty();
        assertThat(Scenario.load(still).plan(RunOptions.NONE).notes())
                .extracting(Problem::message)
                .containsExactly("There is no robot in this world, so that nothing moves.");
        String moving = world("rsal: 1\nrobots: {r: {model: pioneer2dx, pose: [0, 0, 0]}}\n");
        assertThat(Scenario.scene(moving).warnings()).isEmpty();
        assertThat(Scenario.load(moving).plan(RunOptions.NONE).notes()).isEmpty();
    }

    @Test
    void errorsDoNotHideWarningsOfTheWorld() throws IOException {
        String world = world("rsal: 1\nwals: []\nrobots: {r: {model: pioneer2dx, pose: [0, 0, 0], program: dance}}\n");
        for (ThrowingCallable read : List.<ThrowingCallable>of(
                () -> Scenario.scene(world),
                () -> Scenario.load(world).check(),
                () -> Scenario.load(world).plan(RunOptions.NONE))) {
            assertThatExceptionOfType(InvalidSettings.class).isThrownBy(read).satisfies(e -> {
                assertThat(e.problems()).singleElement().asString().contains("'wals'");
                assertThat(e.warnings()).singleElement().asString().contains("'dance'");
            });
        }
    }

    @Test
    void errorsOfAScenarioDoNotHideWarningsOfItsWorld() throws IOException {
        world("rsal: 1\nrobots: {r: {model: pioneer2dx, pose: [0, 0, 0], program: dance}}\n");
        Path file = Files.writeString(
                folder.resolve("some.yaml"),
                "rsal: 1\nscenario: some\ntitle: Some\nworld: {file: some.world.yaml}\nrun: {stp: 1}\n");
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Scenario.load(file.toString()).plan(RunOptions.NONE))
                .satisfies(e -> {
                    assertThat(e.problems()).extracting(Problem::message).anyMatch(m -> m.contains("'stp'"));
                    assertThat(e.warnings()).singleElement().asString().contains("'dance'");
                });
    }

    private static RunPlan teleop(String configuration, RunOptions options) {
        return Scenario.load("teleop").plan(options.withConfiguration(configuration));
    }

    @Test
    void aSpeedOfRealTimeIsSaidToBeOne() {
        assertThat(teleop("real", RunOptions.NONE.withSpeed(4)).notes())
                .extracting(Problem::message)
                .anyMatch(note -> note.startsWith("A run in real time goes at speed 1"));
        assertThat(teleop("real", RunOptions.NONE).notes()).isEmpty();
    }

    /// What is noted of the map when the robots find their way.
    ///
    /// @param robot's fields that tell where it is
    private List<String> notesOfTheEdge(String world, String robot) throws IOException {
        world("rsal: 1\n" + world + "\n");
        Path file = Files.writeString(folder.resolve("some.yaml"), """
                rsal: 1
                scenario: some
                world: {file: some.world.yaml}
                robots:
                  r: {model: pioneer2dx, %s devices: {laser: urg04lx, localizer: {type: slam}, navigator: {}}}
                run: {stop: [{when: time > 1, outcome: success}]}
                """.formatted(robot));
        return Scenario.load(file.toString()).plan(RunOptions.NONE).notes().stream()
                .map(Problem::message)
                .filter(note -> note.contains("open at its edge"))
                .toList();
    }

    @ParameterizedTest
    @ValueSource(strings = {"pose: [3, 2, 0],", ""})
    void whatIsAroundTheWallsOfAClosedWorldIsNoOpening(String robot) throws IOException {
        assertThat(notesOfTheEdge("walls: [{line: [[0, 0], [6, 0], [6, 4], [0, 4]], closed: true}]", robot))
                .isEmpty();
        assertThat(notesOfTheEdge("walls: [{line: [[0, 0], [6, 1], [5, 5], [1, 4]], closed: true}]", robot))
                .isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"pose: [3, 2, 0],", ""})
    void aWorldWhoseWallsHaveAGapIsOpen(String robot) throws IOException {
        assertThat(notesOfTheEdge("walls: [{line: [[0, 3], [0, 0], [6, 0], [6, 4], [0, 4]]}]", robot))
                .singleElement()
                .asString()
                .contains("at (-0.");
    }

    @Test
    void aWorldIsOpenForARobotThatIsOutsideItsWalls() throws IOException {
        String world = "area: [-5, -5, 10, 10]\nwalls: [{line: [[0, 0], [6, 0], [6, 4], [0, 4]], closed: true}]";
        assertThat(notesOfTheEdge(world, "pose: [3, 2, 0],")).isEmpty();
        assertThat(notesOfTheEdge(world, "pose: [-3, 2, 0],")).hasSize(1);
        assertThat(notesOfTheEdge(world, "")).hasSize(1); // it may be put there
    }
}
