package rsal.jade;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import rsal.agent.AgentHost;
import rsal.agent.Message;
import rsal.agent.MessageTransport;
import rsal.agent.ServiceDescription;
import rsal.agent.Topic;
import rsal.agent.platform.ThreadLane;
import rsal.time.Scheduler;

/// Agents on a JADE platform of their own. All calls in turn.
final class JadeHost implements AgentHost, MessageTransport {
    private static final String PEOPLE = "operator"; // in whose name our people speak

    private final Scheduler run;
    private final JadePlatform platform;
    private final JadeAgent people;
    private final Map<String, JadeAgent> agents = new HashMap<>(); // by name
    private final Map<String, JadeAgent> leaving = new HashMap<>(); // who still have their names
    private final Map<String, AID> topics = new HashMap<>(); // by name
    private Consumer<String> onKilled = _ -> {};
    private boolean closed;

    private JadeHost(Scheduler run, JadePlatform platform) {
        this.run = run;
        this.platform = platform;
        this.people = new JadeAgent(PEOPLE, run, _ -> {});
    }

    /// @throws IllegalStateException when JADE can't start
    /// @throws UncheckedIOException when there is no display for its windows
    static JadeHost start(Scheduler run, Set<Tool> tools) {
        if (!tools.isEmpty() && !hasDisplay()) {
            throw new UncheckedIOException(new IOException(
                    "JADE's windows need a display, and there is none. Maybe remove %s.".formatted(tools)));
        }
        var host = new JadeHost(run, JadePlatform.start());
        try {
            host.platform.start(PEOPLE, host.people);
            tools.forEach(host.platform::open);
        } catch (IllegalArgumentException | IllegalStateException e) {
            host.close();
            throw e;
        }
        return host;
    }

    private static boolean hasDisplay() {
        try {
            return !GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (AWTError _) {
            return false; // the one that there should be does not answer
        }
    }

    JadePlatform platform() {
        return platform;
    }

    @Override
    public Scheduler lane(String name) {
        var agent = new JadeAgent(name, run, gone -> run.execute(() -> gone(gone)));
        if (!leaving.containsKey(name)) {
            platform.start(name, agent);
        }
        agents.put(name, agent);
        return new ThreadLane(run, agent);
    }

    /// The platform has forgotten an agent, as it was told, or by a person's will.
    private void gone(JadeAgent agent) {
        String name = agent.name();
        if (agent.isLeaving()) {
            leaving.remove(name, agent);
            if (agents.containsKey(name) && !closed) {
                platform.start(name, agents.get(name));
            }
        } else if (agents.remove(name, agent)) {
            onKilled.accept(name);
        }
    }

    @Override
    public Optional<MessageTransport> carrier() {
        return Optional.of(this);
    }

    @Override
    public void onKilled(Consumer<String> listener) {
        onKilled = listener;
    }

    @Override
    public void end(String name) {
        JadeAgent agent = agents.remove(name);
        if (agent != null && leaving.putIfAbsent(name, agent) == null) { // else it never began on JADE
            agent.leave();
        }
    }

    @Override
    public void close() {
        if (!closed) {
            closed = true;
            people.leave();
            platform.endSoon();
        }
    }

    @Override
    public void listens(String agent, Topic<?> topic) {
        find(agent).ifPresent(listener -> listener.listen(address(topic)));
    }

    @Override
    public void ignores(String agent, Topic<?> topic) {
        find(agent).ifPresent(listener -> listener.ignore(address(topic)));
    }

    @Override
    public void carry(Message<?> message, Consumer<String> arrival) {
        AID receiver = message.isForAll() ? address(message.topic()) : platform.agent(message.to());
        ACLMessage utterance = Utterance.of(message, receiver, arrival);
        find(message.sender()).ifPresentOrElse(sender -> sender.say(utterance), () -> {
            utterance.setSender(platform.agent(message.sender()));
            people.say(utterance);
        });
    }

    @Override
    public void offers(String agent, ServiceDescription capability) {
        find(agent).ifPresent(one -> one.offer(capability));
    }

    @Override
    public void withdraws(String agent, ServiceDescription capability) {
        find(agent).ifPresent(one -> one.withdraw(capability));
    }

    private Optional<JadeAgent> find(String agent) {
        return Optional.ofNullable(agents.get(agent));
    }

    private AID address(Topic<?> topic) {
        return topics.computeIfAbsent(topic.name(), platform::topic);
    }
}
