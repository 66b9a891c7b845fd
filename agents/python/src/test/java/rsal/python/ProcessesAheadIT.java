package rsal.python;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import rsal.agent.AgentSpec;
import rsal.agent.AgentType;
import rsal.agent.RunPreparation;
import rsal.agent.platform.AgentPlatform;
import rsal.agent.platform.PlainHost;
import rsal.settings.Arguments;
import rsal.time.LockstepScheduler;

class ProcessesAheadIT {
    private static final AgentType TYPE = Texts.type("a.py", Map.of("a.py", """
            import os
            import rsal
            RUNS = []
            class A(rsal.Agent):
                def on_start(self):
                    RUNS.append(self.name)
                    print(f"{os.getpid()} {len(RUNS)}")
            """));

    /// The lines of two agents.
    private static List<String> run() {
        var lines = new ArrayList<String>();
        var run = new LockstepScheduler();
        var platform = new AgentPlatform(run, new PlainHost(run), Optional.empty());
        platform.onPrint(print -> lines.add(print.line()));
        for (String name : List.of("amy", "bob")) {
            platform.start(new AgentSpec(name, "tested", TYPE, Arguments.defaults(List.of()), Optional.empty(), 1));
        }
        run.advance(Duration.ofSeconds(1));
        platform.close();
        return lines;
    }

    private static void awaitReady(int count) throws InterruptedException {
        for (int i = 0; i < 1000 && ProcessesAhead.ready() != count; i++) {
            TimeUnit.MILLISECONDS.sleep(5);
        }
        assertThat(ProcessesAhead.ready()).isEqualTo(count);
    }

    @Test
    void eachRunHasAProcessOfItsOwnThatWasStartedAhead() throws InterruptedException {
        run();
        assertThat(ProcessesAhead.ready()).isZero();
        var processes = new HashSet<String>();
        try (RunPreparation _ = RunPreparation.of(2, 4)) {
            assertThat(ProcessesAhead.ready()).isZero();
            for (int left : List.of(3, 2, 1, 0)) {
                List<String> lines = run();
                String process = lines.getFirst().replaceFirst(" .*", "");
                assertThat(lines).containsExactly(process + " 1", process + " 2");
                processes.add(process);
                awaitReady(Math.min(left, 2));
            }
        }
        assertThat(processes).hasSize(4);
    }

    @Test
    void thoseThatNoRunHasTakenEnd() throws InterruptedException {
        try (RunPreparation _ = new PythonLanguage().prepare(3, 100)) {
            run();
            awaitReady(3);
        }
        assertThat(ProcessesAhead.ready()).isZero();
    }
}
