import java.time.Duration;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agents.pursuit.Caught;
import rsal.agent.message.PoseReport;

/// Listens to the others, and tells how much was said: an agent without a robot.
public final class Watcher implements Agent {
    private static final Duration INTERVAL = Duration.ofSeconds(10); // between two things that it tells

    private int heard;
    private String newest = "nobody";

    @Override
    public void start(AgentContext self) {
        self.subscribe(PoseReport.TOPIC, message -> hear(message.sender()));
        self.subscribe(Caught.TOPIC, message -> self.print("%s has caught %s"
                .formatted(message.content().hunter(), message.content().prey())));
        self.scheduler().every(INTERVAL, () -> {
            self.state("has heard %d poses, the newest from %s".formatted(heard, newest));
            self.metric("heard", heard);
        });
    }

    private void hear(String sender) {
        heard++;
        newest = sender;
    }
}
