package rsal.testkit.example;

import java.time.Duration;
import java.time.Instant;
import java.util.HashSet;
import java.util.Set;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.message.Text;
import rsal.settings.Arguments;

/// Says something ten times a second and counts what it hears of others: how much, how often the same, how late.
public final class Chatter implements AgentType {
    @Override
    public String key() {
        return "chatter";
    }

    @Override
    public String description() {
        return "Says something ten times a second and counts what it hears.";
    }

    @Override
    public Agent create(Arguments arguments) {
        return new Counting();
    }

    private static final class Counting implements Agent {
        private final Set<String> known = new HashSet<>();
        private int said;
        private int heard;
        private int again;
        private int late;

        @Override
        public void start(AgentContext self) {
            self.scheduler().every(Duration.ofMillis(100), () -> self.publish(Text.TOPIC, new Text("no. " + said++)));
            self.subscribe(Text.TOPIC, message -> {
                Instant now = self.scheduler().instant();
                heard++;
                again += known.add(message.sender() + " " + message.content().words()) ? 0 : 1;
                late += message.time().isBefore(now) ? 1 : 0;
                self.show("heard", Integer.toString(heard));
                self.show("again", Integer.toString(again));
                self.show("late", Integer.toString(late));
            });
        }
    }
}
