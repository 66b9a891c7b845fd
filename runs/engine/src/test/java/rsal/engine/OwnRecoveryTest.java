package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.settings.InvalidSettings;

/// Recoveries in the order that a scenario says, with the one of `docs/how-to/recoveries.md` among them.
class OwnRecoveryTest {
    private static final String SCENARIO = """
            rsal: 1
            scenario: blocked
            title: Boards stand around the robot
            world: {map: office}
            robots:
              r:
                model: pioneer2dx
                pose: [0, -1.3, 0]
                devices:
                  laser: urg04lx
                  localizer: {type: odometry}
                  navigator: {timeout: 20, recoveries: [{type: StepAside.java, time: 3}, {type: wait, after: 5, duration: 2}, backUp]}
            things:
              front: {pose: [2, -1.3, 0], body: {length: 0.1, width: 1.3, height: 1}, obstacle: true}
              back: {pose: [-1, -1.3, 0], body: {length: 0.1, width: 1.3, height: 1}, obstacle: true}
              left: {pose: [0.5, -0.7, 0], body: {length: 2.8, width: 0.1, height: 1}, obstacle: true}
              right: {pose: [0.5, -1.9, 0], body: {length: 2.8, width: 0.1, height: 1}, obstacle: true}
            agents:
              driver: {type: Driver.java, robot: r}
            run:
              clock: {speed: max}
              stop:
                - {when: allArrived(r), outcome: success}
                - {when: time >= 120, outcome: timeout}
            metrics:
              - {name: wallCollisions, from: count(wallCollisions)}
            """;
    private static final String DRIVER = """
            import rsal.agent.*;
            import rsal.agent.message.GoalReached;
            import rsal.agent.message.NewGoal;
            import rsal.data.Pose2d;
            import rsal.device.Navigator;

            public class Driver implements Agent {
                public void start(AgentContext self) {
                    var goal = new Pose2d(5, -1, 0);
                    self.publish(NewGoal.TOPIC, new NewGoal("r", goal));
                    self.robot().orElseThrow().require(Navigator.class).goTo(goal).result().thenAccept(end -> {
                        self.print(end.toString());
                        self.publish(GoalReached.TOPIC, new GoalReached("r", goal, "stuck", end.toString()));
                    });
                }
            }
            """;

    @TempDir
    private Path folder;

    @BeforeEach
    void write() throws IOException {
        String page = Files.readString(Path.of("../../docs/how-to/recoveries.md"));
        Matcher block = Pattern.compile("```java\n(.*?)```", Pattern.DOTALL).matcher(page);
        assertThat(block.find()).isTrue();
        Files.writeString(folder.resolve("StepAside.java"), block.group(1));
        Files.writeString(folder.resolve("Driver.java"), DRIVER);
    }

    private RunPlan plan(String text) {
        return Runs.plan(folder, text, RunOptions.NONE);
    }

    @Test
    void triesThemInTheirOrder() throws Exception {
        RunPlan plan = plan(SCENARIO);
        assertThat(plan.robots().getFirst().drivers().getLast().options().written())
                .containsEntry(
                        "recoveries",
                        List.of(
                                Map.of("type", "stepAside", "time", 3.0),
                                Map.of("type", "wait", "after", 5.0, "times", 1L, "duration", 2.0),
                                "backUp"));
        try (var run = LiveRun.start(plan)) {
            RunResult result = Runs.result(run);
            assertThat(result.metrics().get("wallCollisions")).hasValue(0);
            assertThat(run.events(0).stream().map(RunEvent::text))
                    .anyMatch(text -> text.contains("tried 'stepAside' once, 'wait' once, 'backUp' "));
        }
    }

    private void refuses(String recoveries, String... words) {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> plan(SCENARIO.replaceAll("recoveries: \\[.*?]}", "recoveries: " + recoveries + "}")))
                .withMessageContainingAll(words);
    }

    @Test
    void reportsEachErrorWithItsPlace() {
        refuses("[wait, bakUp]", "scenario.yaml:12:", "There is no recovery 'bakUp'.", "Maybe 'backUp'");
        refuses("[{type: wait, duration: 0}]", "'robots.r.devices.navigator.recoveries.duration'", "from 0.1 to 600");
        refuses("[{type: wait, duraton: 3}]", "'duraton' is not known", "Maybe 'duration'");
        refuses("[3]", "'robots.r.devices.navigator.recoveries' must be a text");
        refuses("[Driver.java]", "Class 'Driver' is not of the kind 'recovery'.");
        refuses("{time: 3}", "'robots.r.devices.navigator.recoveries.type'");
    }

    @Test
    void oneAloneNeedsNoList() {
        assertThat(plan(SCENARIO.replaceAll("recoveries: \\[.*?]}", "recoveries: wait}"))
                        .robots()
                        .getFirst()
                        .drivers()
                        .getLast()
                        .options()
                        .written())
                .containsEntry("recoveries", List.of("wait"));
    }
}
