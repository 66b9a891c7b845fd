package rsal.agents.driving;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.agent.Agent;
import rsal.agent.AgentSpec;
import rsal.agent.AgentType;
import rsal.agent.platform.AgentPlatform;
import rsal.agents.FakeRobot;
import rsal.agents.Scene;
import rsal.data.Pose2d;
import rsal.device.Navigator.Tolerance;
import rsal.settings.Arguments;

class NavigationClientTest {
    private final Scene scene = new Scene();
    private final FakeRobot r1 = scene.robot("r1", "rover");

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
        var none = Arguments.defaults(List.of());
        scene.platform.start(new AgentSpec("bob", "tested", new Careless(r1), none, Optional.of(r1.robot), 1));
        scene.advance(0);
        r1.navigator.reach();
        scene.advance(0);
        assertThat(scene.platform.views())
                .singleElement()
                .satisfies(bob -> assertThat(bob.status()).isEqualTo(AgentPlatform.Status.FAILED))
                .satisfies(bob -> assertThat(bob.state()).isEqualTo("a slip of bob's"));
    }
}
