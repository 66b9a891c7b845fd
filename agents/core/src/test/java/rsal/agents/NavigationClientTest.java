package rsal.agents;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import rsal.agent.AgentPlatform.Status;
import rsal.agent.Run;
import rsal.data.Pose2d;
import rsal.device.Navigator.Tolerance;

class NavigationClientTest {
    private final Run run = new Run();
    private final FakeRobot r1 = new FakeRobot("r1", "rover", run.scheduler);

    @Test
    void agentThatThrowsWhenItsDriveEndsIsEnded() {
        run.start(
                "bob",
                self -> new NavigationClient(self, r1.navigator).goTo(Pose2d.ORIGIN, Tolerance.DEFAULT, _ -> {
                    throw new IllegalStateException("a slip of bob's");
                }),
                r1.robot);
        run.advance(0);
        r1.navigator.reach();
        run.advance(0);
        assertThat(run.view("bob").status()).isEqualTo(Status.FAILED);
        assertThat(run.view("bob").state()).isEqualTo("a slip of bob's");
    }
}
