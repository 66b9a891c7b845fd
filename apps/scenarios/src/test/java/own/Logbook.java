package own;

import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.settings.Arguments;

/// Counts the visits of each post. Needs no robot.
public final class Logbook implements AgentType {
    @Override
    public String key() {
        return "logbook";
    }

    @Override
    public String description() {
        return "Counts the visits of each post.";
    }

    @Override
    public Agent create(Arguments arguments) {
        return self -> {
            int[] visits = new int[3]; // by post
            self.subscribe(Sentry.Visit.TOPIC, message -> {
                int post = message.content().post();
                visits[post]++;
                self.show("post " + post, "%d times, last by %s".formatted(visits[post], message.sender()));
            });
        };
    }
}
