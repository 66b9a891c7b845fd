package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.report.RunResult;
import rsal.robot.Robot;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.RobotRecorder;
import rsal.time.Scheduler;

/// Who records a run's robots has them from its first step to its end, and changes nothing.
class RecordedRobotsTest {
    @TempDir
    private Path folder;

    private static final class Notes extends IdleBridge implements RobotRecorder {
        private final List<String> notes = new ArrayList<>(); // on the run's thread, and read after its end

        @Override
        public Bridge open(BridgeContext context, Scheduler scheduler) {
            notes.add("%d s: %s"
                    .formatted(
                            scheduler.instant().getEpochSecond(),
                            context.robots().stream().map(Robot::id).sorted().toList()));
            return this;
        }

        @Override
        public Optional<IOException> failure() {
            return Optional.empty();
        }

        @Override
        public void leave(String robot) {
            notes.add("left: " + robot);
        }

        @Override
        public void close() {
            notes.add("closed");
        }
    }

    @Test
    void seesAllRobotsUntilTheEnd() {
        RunPlan plan = Runs.plan(folder, Runs.TWO_WANDERERS, RunOptions.NONE);
        var recorder = new Notes();
        RunResult result;
        try (LiveRun run = LiveRun.of(plan).recorder(recorder).start()) {
            result = Runs.result(run);
            assertThat(recorder.notes).containsExactly("0 s: [hunter-1, prey]", "closed");
        }
        assertThat(result.eventHash()).isEqualTo(Runs.result(plan).eventHash());
    }
}
