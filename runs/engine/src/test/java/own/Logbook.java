package own;

import rsal.agent.Agent;
import rsal.agent.AgentContext;

/// Counts the visits of each post. Needs no robot.
public final class Logbook implements Agent {
    private final int[] visits = new int[3]; // by post

    @Override
    public void start(AgentContext self) {
        self.subscribe(Sentry.Visit.TOPIC, message -> {
            int post = message.content().post();
            visits[post]++;
            self.show("post " + post, "%d times, last by %s".formatted(visits[post], message.sender()));
        });
    }
}
