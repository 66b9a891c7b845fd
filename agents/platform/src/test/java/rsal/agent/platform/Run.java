package rsal.agent.platform;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.agent.Agent;
import rsal.agent.AgentSpec;
import rsal.agent.AgentType;
import rsal.agent.ChannelModel;
import rsal.agent.Topic;
import rsal.agent.plain.PlainHostProvider;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.time.LockstepScheduler;

/// A society on the plain host in simulated time, with agents written as lambdas.
public final class Run {
    static final Topic<String> WORDS = new Topic<>("words", String.class);

    public final LockstepScheduler scheduler = new LockstepScheduler();
    final AgentPlatform platform = new AgentPlatform(
            scheduler, new PlainHostProvider().create(Arguments.defaults(List.of()), scheduler), Optional.empty());

    /// All that was said, as `zoe -> amy: request: ...`, in order.
    public List<String> transcript() {
        var lines = new ArrayList<String>();
        platform.onMessage(said ->
                lines.add(said.sender() + " -> " + (said.isForAll() ? "all" : said.to()) + ": " + said.content()));
        return lines;
    }

    public void deliverBy(ChannelModel delivery) {
        platform.deliverBy(delivery);
    }

    public <M> void send(String sender, String to, Topic<M> topic, M message) {
        platform.send(sender, to, topic, message);
    }

    public <T> Optional<T> look(String name, Class<T> type) {
        return platform.look(name, type);
    }

    public void stop(String name) {
        platform.stop(name);
    }

    public void start(String name, Agent agent) {
        platform.start(spec(name, agent, Optional.empty()));
    }

    public void start(String name, Agent agent, Robot robot) {
        platform.start(spec(name, agent, Optional.of(robot)));
    }

    /// An agent that hears words and hands them on with the name of the one who said them: `bob: hi`.
    void startListener(String name, Consumer<String> heard) {
        start(name, self -> self.subscribe(WORDS, m -> heard.accept(m.sender() + ": " + m.content())));
    }

    public void advance(double seconds) {
        scheduler.advance(Duration.ofMillis(Math.round(seconds * 1000)));
    }

    public AgentPlatform.View view(String name) {
        return platform.views().stream()
                .filter(view -> view.agent().name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    private static AgentSpec spec(String name, Agent agent, Optional<Robot> robot) {
        return new AgentSpec(name, "tested", new Type(agent), Arguments.defaults(List.of()), robot, name.hashCode());
    }

    private record Type(Agent agent) implements AgentType {
        @Override
        public String key() {
            return "lambda";
        }

        @Override
        public String description() {
            return "Does what a test wants.";
        }

        @Override
        public Agent create(Arguments arguments) {
            return agent;
        }
    }
}
