package rsal.jadex.hunt;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.AgentSpec;
import rsal.agent.AgentType;
import rsal.agent.plain.PlainHostProvider;
import rsal.agent.platform.AgentPlatform;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.RobotBench;
import rsal.testkit.fake.FakeLocalizer;
import rsal.testkit.fake.FakeNavigator;
import rsal.testkit.fake.FakeProvider;
import rsal.testkit.fake.TestedType;

class JadexHunterTest extends RobotBench {
    private static final Arguments ARGUMENTS = Arguments.defaults(new JadexHunter().parameters());

    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(new FakeLocalizer.Driver(), new FakeNavigator.Driver());
    }

    @Test
    void saysWhereItBelongsWhenItIsOnAnotherHost() {
        assertThat(failureOf(new JadexHunter()))
                .isEqualTo("Agent 'follow-1' uses Jadex and needs its platform."
                        + " Maybe run it by '--mas jadex --clock wall'.");
    }

    @Test
    void endsByFaultsOfItsMind() {
        var slip = new IllegalStateException("a slip");
        assertThat(failureOf(new TestedType(self -> new JadexHunt(self, ARGUMENTS).failed(slip))))
                .isEqualTo("The mind of 'follow-1' failed: java.lang.IllegalStateException: a slip");
    }

    private String failureOf(AgentType type) {
        var host = new PlainHostProvider().create(Arguments.defaults(List.of()), run);
        var platform = new AgentPlatform(run, host, Optional.empty());
        platform.start(new AgentSpec("follow-1", "follow", type, ARGUMENTS, Optional.of(robot()), 1));
        advance(1);
        AgentPlatform.View view = platform.views().getFirst();
        assertThat(view.status()).isEqualTo(AgentPlatform.Status.FAILED);
        return view.state();
    }
}
