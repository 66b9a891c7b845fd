package rsal.server.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.RunPlan.Clock;
import rsal.server.Errand;
import rsal.server.message.Messages.Restart;
import rsal.testkit.fake.ClockHost;

/// Which clock a run has that somebody starts in the page on another agent host.
class RestartReaderTest {
    private static final RunPlan SIMULATED = Errand.plan();

    private static RunPlan on(RunPlan present, Optional<String> host) {
        var none = Optional.<String>empty();
        var wish = new Restart(none, none, Optional.empty(), none, none, host, none);
        return new RestartReader(new ScenarioCatalog(List.of()), present, 1).read(wish);
    }

    private static RunPlan on(RunPlan present, String host) {
        return on(present, Optional.of(host));
    }

    private static String host(RunPlan plan) {
        return plan.mas().provider().key();
    }

    @Test
    void aHostThatKnowsNoOtherTimeRunsInRealTime() {
        RunPlan real = on(SIMULATED, ClockHost.KEY);
        assertThat(host(real)).isEqualTo(ClockHost.KEY);
        assertThat(real.clock()).isEqualTo(Clock.WALL);
        assertThat(on(real, Optional.empty()).clock()).as("as it is").isEqualTo(Clock.WALL);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "plain"})
    void whoLeavesItIsByTheScenariosClockAgain(String host) {
        RunPlan left = on(on(SIMULATED, ClockHost.KEY), host);
        assertThat(host(left)).isEqualTo("plain");
        assertThat(left.clock()).isEqualTo(Clock.SIMULATED);
    }

    @Test
    void whoWantedRealTimeOnAHostThatNeedsNoneKeepsIt() {
        RunPlan wanted = Errand.plan("errand.yaml", RunOptions.NONE.inRealTimeOn("plain"));
        assertThat(on(wanted, "plain").clock()).isEqualTo(Clock.WALL);
        assertThat(on(wanted, Optional.empty()).clock()).isEqualTo(Clock.WALL);
        assertThat(on(wanted, "").clock())
                .as("the scenario's host, by its clock")
                .isEqualTo(Clock.SIMULATED);
    }
}
