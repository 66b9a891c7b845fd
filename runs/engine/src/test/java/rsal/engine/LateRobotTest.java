package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.report.RunResult;
import rsal.engine.report.Snapshot;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;

/// A robot that the scenario plans, and that its robot system finds only after the run has begun.
@Timeout(60)
class LateRobotTest {
    private static final String SCENARIO = Runs.TWO_WANDERERS
            .replace("type: truthful, error: 0.2", "type: truthful")
            .replace("run:\n", "mrs: {use: reality, host: late}\nrun:\n");

    @TempDir
    private Path folder;

    private RunPlan plan(String scenario) {
        return Runs.plan(folder, scenario, RunOptions.NONE);
    }

    private static List<String> events(LiveRun run) {
        return run.events(0).stream()
                .map(event -> event.subject() + ": " + event.text())
                .toList();
    }

    @Test
    void itJoinsWithTheAgentsThatWerePlannedForIt() {
        LiveRun run = LiveRun.start(plan(SCENARIO));
        RunResult result = Runs.result(run);
        assertThat(result.outcome()).isEqualTo("timeout");
        assertThat(events(run))
                .containsSubsequence(
                        "hunter-1: is not there yet; it joins when it is found",
                        ": 1 robot, 1 agent",
                        "hunter-1: is there",
                        "chase-1: has started")
                .doesNotContain("hunter-1: motors are off until somebody switches them on");
        assertThat(run.snapshot().robots()).extracting(robot -> robot.id()).containsExactly("prey", "hunter-1");
    }

    @Test
    void whatNeedsASensorThatARobotLacksIsLeftOut() {
        String scenario = SCENARIO.replace("host: late", "host: blind").replace("    pose: {free: true}\n", """
                    pose: {free: true}
                    devices: {laser: urg04lx, localizer: {type: amcl}}
                """);
        LiveRun run = LiveRun.start(plan(scenario));
        assertThat(Runs.result(run).outcome()).isEqualTo("timeout");
        assertThat(events(run))
                .contains("hunter-1: 'localizer' is left out, as the robot has no RangeSensor", "chase-1: has started");
    }

    @Test
    void aDeviceWithoutAConnectionFromTheBeginningIsAnEvent() {
        LiveRun run = LiveRun.start(plan(SCENARIO.replace("host: late", "host: broken")));
        Runs.result(run);
        assertThat(events(run)).contains("hunter-1/base: is lost: No connection.");
    }

    @Test
    void theTimeOfARunBeginsWhenItsRobotsAreThere() {
        LiveRun run = LiveRun.start(plan(SCENARIO.replace("host: late", "host: slow")));
        LiveRun same = LiveRun.start(plan(SCENARIO.replace("host: late", "host: at-once")));
        assertThat(Runs.result(run).simulatedSeconds())
                .isEqualTo(Runs.result(same).simulatedSeconds());
        assertThat(times(run)).isEqualTo(times(same));
    }

    private static List<String> times(LiveRun run) {
        return run.events(0).stream()
                .map(event -> event.time() + " " + event.subject() + ": " + event.text())
                .toList();
    }

    @Test
    void itsFaultsBeginWhenItJoinsUnlessTheyAreOver() {
        String scenario = SCENARIO.replace("    pose: {free: true}\n", """
                    pose: {free: true}
                    devices: {localizer: {type: truthful}}
                """) + """
                faults:
                  - {kind: frozen, robots: hunter-1, devices: localizer, at: 0, for: 2}
                  - {kind: frozen, robots: hunter-1, devices: localizer, at: 1, for: 6}
                """;
        LiveRun run = LiveRun.start(plan(scenario));
        Runs.result(run);
        assertThat(times(run).stream().filter(line -> line.contains("frozen")))
                .containsExactly("PT3S hunter-1/localizer: frozen", "PT7S hunter-1/localizer: no longer frozen");
    }

    @Test
    void itsMotorsStayOffUntilSomebodySwitchesThemOn() {
        LiveRun run = LiveRun.start(plan(SCENARIO.replace("host: late", "host: late-off")));
        Runs.result(run);
        assertThat(events(run))
                .containsSubsequence("hunter-1: is there", "hunter-1: motors are off until somebody switches them on");
        assertThat(run.snapshot().robots().getLast().stopped()).isTrue();
    }

    @Test
    void itsMotorsAreOnIfSomebodyHasSwitchedThemOnBefore() throws InterruptedException {
        String slow = SCENARIO.replace("host: late", "host: late-off").replace("speed: max", "speed: 1");
        try (LiveRun run = LiveRun.start(plan(slow))) {
            run.operator().rearm().toCompletableFuture().join();
            var on = new CountDownLatch(1);
            try (var _ = run.onEvents(() -> events(run).stream()
                    .filter(event -> event.equals("hunter-1: motors on, as those of the other robots"))
                    .findFirst()
                    .ifPresent(_ -> on.countDown()))) {
                on.await();
            }
            assertThat(run.snapshot().robots()).noneMatch(robot -> robot.stopped());
        }
    }

    @Test
    void itStandsStillWhileAnEmergencyStopHolds() {
        String slow = SCENARIO.replace("speed: max", "speed: 1");
        try (LiveRun run = LiveRun.start(plan(slow))) {
            run.operator().rearm().toCompletableFuture().join();
            run.operator().estop().toCompletableFuture().join();
            Snapshot there = run.when(now -> now.robots().size() == 2)
                    .toCompletableFuture()
                    .join();
            assertThat(there.robots()).allMatch(robot -> robot.stopped());
        }
    }
}
