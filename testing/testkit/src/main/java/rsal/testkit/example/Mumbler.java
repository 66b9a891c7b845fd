package rsal.testkit.example;

import java.time.Duration;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.agent.Topic;
import rsal.settings.Arguments;

/// Says after a second what can't be put in words.
public final class Mumbler implements AgentType {
    private static final Topic<Mumbling> MUMBLING = new Topic<>("mumbling", Mumbling.class);

    @Override
    public String key() {
        return "mumbler";
    }

    @Override
    public String description() {
        return "Says after a second what can't be put in words.";
    }

    @Override
    public Agent create(Arguments arguments) {
        return self -> self.scheduler().after(Duration.ofSeconds(1), () -> self.publish(MUMBLING, new Mumbling()));
    }

    private record Mumbling() {
        @Override
        public String toString() {
            throw new IllegalStateException("There are no words for it.");
        }
    }
}
