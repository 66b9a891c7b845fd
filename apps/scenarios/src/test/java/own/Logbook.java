package own;

import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

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
    public List<Parameter> parameters() {
        return List.of();
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return List.of();
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
