package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;

class ThingsRunTest {
    private static final String TIDY = """
            rsal: 1
            scenario: tidy
            world: {map: office}
            robots:
              cart: {model: pioneer2dx, pose: [-20, 4, 0]}
            things:
              can: {count: 3, pose: [[-19, 1.2, 0], [-19, 1.7, 0], [-15, -1, 0]], body: {radius: 0.08, height: 0.1}, obstacle: false, every: $every, depot: {at: [[-19, 1]], radius: 1}}
            arguments:
              every: {type: number, default: 0}
            run:
              seed: 7
              clock: {speed: max}
              stop:
                - {when: allCollected(can), outcome: success}
                - {when: time >= 60, outcome: timeout}
            metrics:
              - {name: collected, from: count(collected(can))}
              - {name: two, from: firstTime(collected(can) >= 2)}
            """;

    @TempDir
    private Path folder;

    private RunPlan plan(String text) {
        return Runs.plan(folder, text, RunOptions.NONE);
    }

    @Test
    void whatLiesInADepotCounts() {
        RunResult result = Runs.result(plan(TIDY));
        assertThat(result.outcome()).isEqualTo("timeout");
        assertThat(result.metrics().get("collected")).hasValue(2);
        RunResult wide = Runs.result(plan(TIDY.replace("radius: 1}", "radius: 5}")));
        assertThat(wide.outcome()).isEqualTo("success");
        assertThat(wide.simulatedSeconds()).isLessThan(1);
    }

    @Test
    void thingsThatComeLaterCountFromThenOn() {
        RunPlan plan = plan(TIDY.replace("default: 0", "default: 10"));
        double second = plan.things().getFirst().each().get(1).comes().toMillis() / 1000.0;
        assertThat(second).isBetween(0.5, 55.0);
        RunResult result = Runs.result(plan);
        assertThat(result.metrics().get("two").orElseThrow()).isBetween(second, second + 0.2);
    }

    @Test
    void whatIsInTheWayOfAThingDelaysIt() {
        String onTheRobot = TIDY.replace("[-19, 1.2, 0]", "[-20, 4, 0]").replace("obstacle: false", "obstacle: true");
        try (var run = LiveRun.start(plan(onTheRobot))) {
            Runs.result(run);
            assertThat(run.events(0))
                    .filteredOn(event -> event.subject().equals("can-1"))
                    .extracting(RunEvent::text)
                    .singleElement()
                    .asString()
                    .startsWith("can't come yet: ");
        }
    }
}
