package rsal.agents;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.Agent;
import rsal.agent.AgentSpec;
import rsal.agent.AgentType;
import rsal.agent.plain.PlainHostProvider;
import rsal.agent.platform.AgentPlatform;
import rsal.data.Pose2d;
import rsal.device.Navigator.Tolerance;
import rsal.settings.Arguments;
import rsal.time.LockstepScheduler;

class NavigationClientTest {
    private static final Arguments NONE = Arguments.defaults(List.of());

    private final LockstepScheduler scheduler = new LockstepScheduler();
    private final AgentPlatform platform =
            new AgentPlatform(scheduler, new PlainHostProvider().create(NONE, scheduler), Optional.empty());
    private final FakeRobot r1 = new FakeRobot("r1", "rover", scheduler);

    private record Careless(FakeRobot fake) implements AgentType {
        @Override
        public String key() {
            return "careless";
        }

        @Override
        public String description() {
            return "Fails when its robot is there.";
        }

        @Override
        public Agent create(Arguments arguments) {
            return self -> new NavigationClient(self, fake.navigator).goTo(Pose2d.ORIGIN, Tolerance.DEFAULT, _ -> {
                throw new IllegalStateException("a slip of bob's");
            });
        }
    }

    @Test
    void agentThatThrowsWhenItsDriveEndsIsEnded() {
        platform.start(new AgentSpec("bob", "tested", new Careless(r1), NONE, Optional.of(r1.robot), 1));
        scheduler.advance(Duration.ZERO);
        r1.navigator.reach();
        scheduler.advance(Duration.ZERO);
        assertThat(platform.views())
                .singleElement()
                .satisfies(bob -> assertThat(bob.status()).isEqualTo(AgentPlatform.Status.FAILED))
                .satisfies(bob -> assertThat(bob.state()).isEqualTo("a slip of bob's"));
    }
}
