package rsal.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.scenario.PlannedThings.PlannedThing;
import rsal.settings.InvalidSettings;

/// What a scenario puts into its world.
class ThingsTest {
    private static final String SCENARIO = """
            rsal: 1
            scenario: tidy
            arguments:
              cans: {type: integer, default: 12}
            world: {map: office}
            robots:
              cart: {count: 2, model: pioneer2dx, pose: [[-20, 4, 0], [-22, 5.5, 0]]}
            things:
              can:
                count: $cans
                pose: {free: true, clearance: 0.5}
                body: {radius: 0.08, height: 0.1}
                color: "#2ca02c"
                obstacle: false
                grippable: true
                every: 20
                depot: {around: cart, radius: 1.5}
              mat: {pose: [-21, 2, 0], body: {length: 1, width: 0.5, height: 0.02}, obstacle: false, givingPower: 50}
            run:
              stop:
                - {when: allCollected(can), outcome: success}
            metrics:
              - {name: n, from: count(collected(can))}
            """;

    @TempDir
    private Path folder;

    private RunPlan plan(String text, long seed) throws IOException {
        Path file = Files.writeString(folder.resolve("tidy.yaml"), text);
        return Scenario.load(file.toString()).plan(RunOptions.NONE.withSeed(seed));
    }

    private static List<Pose2d> poses(PlannedThings things) {
        return things.each().stream().map(each -> each.thing().mapFromThing()).toList();
    }

    @Test
    void areWhatTheScenarioSays() throws IOException {
        List<PlannedThings> things = plan(SCENARIO, 1).things();
        PlannedThings cans = things.getFirst();
        assertThat(cans.each()).hasSize(12);
        assertThat(cans.each().getFirst().thing()).satisfies(can -> {
            assertThat(can.name()).isEqualTo("can-1");
            assertThat(can.obstacle()).isFalse();
            assertThat(can.grippable()).isTrue();
            assertThat(can.color()).hasToString("#2ca02c");
        });
        assertThat(cans.depot().orElseThrow().mapFromMiddles())
                .containsExactly(new Point2d(-20, 4), new Point2d(-22, 5.5));
        PlannedThings mat = things.getLast();
        assertThat(mat.depot()).isEmpty();
        assertThat(mat.each()).singleElement().satisfies(each -> {
            assertThat(each.thing().name()).isEqualTo("mat");
            assertThat(each.thing().givingPower()).isEqualTo(50);
            assertThat(each.comes()).isZero();
        });
    }

    @Test
    void lieWhereTheSeedSaysApartAndOutsideOfDepots() throws IOException {
        PlannedThings cans = plan(SCENARIO, 1).things().getFirst();
        assertThat(poses(cans)).isEqualTo(poses(plan(SCENARIO, 1).things().getFirst()));
        assertThat(poses(cans)).isNotEqualTo(poses(plan(SCENARIO, 2).things().getFirst()));
        for (Pose2d one : poses(cans)) {
            assertThat(cans.depot().orElseThrow().holds(one.position(), 0.5)).isFalse();
            assertThat(poses(cans))
                    .allSatisfy(other -> assertThat(one.equals(other) || one.distanceTo(other) >= 1)
                            .isTrue());
        }
    }

    @Test
    void comeOneAfterTheOther() throws IOException {
        var times = plan(SCENARIO.replace("default: 12", "default: 200"), 1).things().getFirst().each().stream()
                .map(PlannedThing::comes)
                .toList();
        assertThat(times.getFirst()).isZero();
        assertThat(times).isSorted();
        assertThat(times.getLast().dividedBy(199)).isBetween(Duration.ofSeconds(17), Duration.ofSeconds(23));
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            around: cart,            | around: carts,            | 17 | No robots have the role 'carts'.
            around: cart,            |                           | 17 | 'things.can.depot' needs 'around' or 'at'.
            around: cart,            | around: cart, at: [[1, 2]],| 17 | 'things.can.depot' has both 'around' and 'at'.
            mat: {pose: [-21, 2, 0], | mat: {                    | 18 | 'things.mat.pose' is missing.
            mat: {pose               | cart-2: {pose             | 18 | 'cart-2' can't be the name of things
            clearance: 0.5           | clearance: 50             | 11 | There is no free place for thing 'can-1'.
            every: 20                | evry: 20                  | 16 | 'evry' is not known in 'things.can'.
            allCollected(can)        | allCollected(cen)         | 21 | No things that have a depot are called 'cen'.
            allCollected(can)        | allCollected(mat)         | 21 | No things that have a depot are called 'mat'.
            allCollected(can)        | allReached(can)           | 21 | No things that have a reach are called 'can'.
            every: 20                | reach: {by: carts}        | 16 | No robots have the role 'carts'.
            every: 20                | reach: {within: 2}        | 16 | 'things.can.reach.by' is missing
            clearance: 0.5           | clearance: 0.5, passage: 1| 11 | 'passage' must not be more than 'clearance', which is 0.5.
            """)
    void errorsSayWhereAndWhat(String right, String wrong, int line, String message) {
        String text = SCENARIO.replace(right, wrong == null ? "" : wrong);
        assertThatThrownBy(() -> plan(text, 1))
                .isInstanceOfSatisfying(
                        InvalidSettings.class,
                        e -> assertThat(e.problems()).anySatisfy(problem -> {
                            assertThat(problem.message()).contains(message);
                            assertThat(problem.location().line()).isEqualTo(line);
                        }));
    }
}
