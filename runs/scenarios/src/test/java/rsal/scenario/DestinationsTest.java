package rsal.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.settings.Problem;
import rsal.testkit.Rounds;

/// What is said of places that a scenario gives and that robots don't get to.
class DestinationsTest {
    private static final String ROOMS = """
            resolution: 0.5
            drawing: |
              ##############################
              #..............#.............#
              #..............#.............#
              #..............#.............#
              #..............#.............#
              #......##......#.............#
              #......##......#.............#
              ##############################
            """; // 15 m by 4 m, two rooms and a table at (4, 1)
    private static final String SCENARIO = """
            rsal: 1
            scenario: watch
            arguments:
              places: {type: string, default: "PLACES"}
            world: {map: rooms.yaml}
            robots:
              guard:
                model: pioneer3at
                pose: [1.5, 1.5, 0]
                devices: {laser: utm30lx, localizer: {type: amcl}, planner: {type: wavefront}, navigator: {}}
            THINGS
            agents:
              worker: {type: worker, robot: guard}
              patrol: {type: patrol, parameters: {places: $places}}
              ceiling: {type: overhead-camera, parameters: {things: can, places: "4 1"}}
            configurations:
              near: {}
              far: {arguments: {places: "12 2"}}
            """;

    @TempDir
    private Path folder;

    @BeforeEach
    void drawRooms() throws IOException {
        Files.writeString(folder.resolve("rooms.yaml"), ROOMS);
    }

    private RunPlan plan(String places, String things, RunOptions options) throws IOException {
        Path file = Files.writeString(
                folder.resolve("watch.yaml"), SCENARIO.replace("PLACES", places).replace("THINGS", things));
        return Scenario.load(file.toString()).plan(options);
    }

    private List<Problem> notes(String places, String things) throws IOException {
        return plan(places, things, RunOptions.NONE).notes();
    }

    private static String cans(String settings) {
        return """
                things:
                  can: {body: {radius: 0.1, height: 0.1}, obstacle: false, %s}
                """.formatted(settings);
    }

    private static final String NO_CANS = cans("pose: [2, 3, 0]");

    @Test
    void nothingIsSaidOfPlacesThatRobotsGetTo() throws IOException {
        assertThat(notes("1 1; 6 3", NO_CANS)).isEmpty();
        assertThat(notes("", NO_CANS)).isEmpty();
    }

    @Test
    void whatLiesInATableIsReportedWhereItIsWritten() throws IOException {
        assertThat(notes("1 1; 4 1", NO_CANS)).singleElement().satisfies(note -> {
            assertThat(note.location().line()).isEqualTo(4);
            assertThat(note.message())
                    .contains("'places' of agent 'patrol'", "1 of 2", "Place (4.00, 1.00) is in a wall, or", "Maybe");
        });
    }

    @Test
    void aRoomWithoutADoorIsReported() throws IOException {
        assertThat(notes("1 1; 12 2", NO_CANS))
                .singleElement()
                .satisfies(
                        note -> assertThat(note.message()).contains("(12.00, 2.00) cannot be reached", "too narrow"));
        assertThat(notes("1 1; 400 2", NO_CANS))
                .singleElement()
                .satisfies(note ->
                        assertThat(note.message()).contains("(400.00, 2.00) is outside the map", "another map"));
    }

    @Test
    void aLittleTooNearIsNearEnough() throws IOException {
        assertThat(notes("0.9 2.2", NO_CANS)).isEmpty();
        assertThat(notes("3.4 1", NO_CANS)).hasSize(1);
    }

    @Test
    void manyAreReportedInOne() throws IOException {
        assertThat(notes("4 1; 12 1; 12 2; 12 3; 13 2; 1 1", NO_CANS))
                .singleElement()
                .satisfies(note -> assertThat(note.message()).contains("5 of 6", "Nor to 2 others"));
    }

    @Test
    void whatIsTypedOrSetByAConfigurationIsReportedThere() throws IOException {
        assertThat(plan("1 1", NO_CANS, RunOptions.NONE.withArguments(Map.of("places", "4 1")))
                        .notes())
                .singleElement()
                .satisfies(note -> assertThat(note.location()).hasToString("--set places=4 1"));
        assertThat(plan("1 1", NO_CANS, RunOptions.NONE.withConfiguration("far"))
                        .notes())
                .singleElement()
                .satisfies(note -> assertThat(note.location().line()).isEqualTo(20));
    }

    @Test
    void itIsEnoughThatOneOfSeveralKindsOfRobotsGetsThere() throws IOException {
        String other = """
                  other:
                    model: pioneer2dx
                    pose: [12, 1.5, 0]
                    devices: {laser: urg04lx, localizer: {type: amcl}, navigator: {}}
                """;
        assertThat(notes("1 1; 12 2; 4 1", other + NO_CANS))
                .singleElement()
                .satisfies(note -> assertThat(note.message()).contains("1 of 3", "(4.00, 1.00)"));
    }

    @Test
    void thingsAndTheirDepotsAreReportedToo() throws IOException {
        assertThat(notes("", cans("pose: [12, 3, 0], grippable: true, depot: {at: [[2, 2]]}")))
                .singleElement()
                .satisfies(note -> {
                    assertThat(note.location().line()).isEqualTo(12);
                    assertThat(note.message()).contains("'pose' of things 'can'", "(12.00, 3.00) cannot be reached");
                });
        assertThat(notes("", cans("pose: [2, 3, 0], grippable: true, depot: {at: [[12, 2]]}")))
                .singleElement()
                .satisfies(note -> assertThat(note.message()).contains("depot of things 'can'"));
        assertThat(notes("", cans("pose: [12, 3, 0], reach: {by: guard}")))
                .singleElement()
                .satisfies(note -> assertThat(note.message()).contains("'pose' of things 'can'"));
        assertThat(notes("", cans("pose: [12, 3, 0]"))).as("nobody goes there").isEmpty();
    }

    @Test
    void allThatComesAlongIsClean() {
        for (Scenario scenario : Scenario.builtIn()) {
            List<Configuration> all = scenario.configurations();
            for (Configuration configuration : all.subList(0, Rounds.of(1, all.size()))) {
                assertThat(scenario.plan(RunOptions.NONE.withConfiguration(configuration.name()))
                                .notes())
                        .as("%s:%s", scenario.name(), configuration.name())
                        .isEmpty();
            }
        }
    }
}
