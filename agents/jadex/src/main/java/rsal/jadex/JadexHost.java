package rsal.jadex;

import jadex.bridge.IExternalAccess;
import jadex.bridge.service.types.cms.CreationInfo;
import jadex.commons.future.FutureBarrier;
import jadex.commons.future.IFuture;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import rsal.agent.AgentHost;
import rsal.agent.Capability;
import rsal.agent.Carrier;
import rsal.agent.Message;
import rsal.agent.ThreadLane;
import rsal.agent.Topic;
import rsal.agent.protocol.Act;
import rsal.time.Scheduler;

/// A Jadex platform with a micro agent for each agent. Conversations go by the agents' services; what is said to all
/// goes straight to the inboxes of those who listen, as services stand some eight thousand calls a second, and a
/// hundred robots that tell where they are need ten times that.
///
/// Capabilities are known to our directory only: services of Jadex are types, not names.
final class JadexHost implements AgentHost, Carrier {
    private final Scheduler run;
    private final IExternalAccess platform;
    private final Map<String, Body> bodies = new HashMap<>(); // of those that run, by name
    private final Map<String, Set<String>> listeners = new HashMap<>(); // by topic, in the order in which they came
    private final List<IFuture<Map<String, Object>>> leaving = new ArrayList<>(); // and not yet gone
    private final Map<String, Integer> lives = new HashMap<>(); // how often there was one of that name, by Jadex's

    JadexHost(Scheduler run, IExternalAccess platform) {
        this.run = run;
        this.platform = platform;
    }

    @Override
    public Scheduler lane(String name) {
        var body = new Body(name, run);
        bodies.put(name, body);
        platform.createComponent(new CreationInfo().setPojo(body).setName(componentName(name)))
                .catchEx(e -> run.exclusively(() -> {
                    throw new IllegalStateException("Jadex could not make agent (%s).".formatted(name), e);
                }));
        return new ThreadLane(run, body);
    }

    /// Unique, also while one that was called the same still goes, and without what Jadex reads as an address.
    private String componentName(String agent) {
        String plain = agent.replaceAll("[^A-Za-z0-9_-]", "_");
        int life = lives.merge(plain, 1, Integer::sum);
        return life == 1 ? plain : plain + "_" + life;
    }

    @Override
    public Optional<Carrier> carrier() {
        return Optional.of(this);
    }

    @Override
    public void end(String name) {
        listeners.values().forEach(those -> those.remove(name));
        Optional.ofNullable(bodies.remove(name)).ifPresent(body -> leaving.add(body.end()));
        leaving.removeIf(IFuture::isDone);
    }

    /// The platform ends by its own threads, after its agents: else it leaves timers behind that wait for them.
    @Override
    public void close() {
        var all = new FutureBarrier<Map<String, Object>>();
        leaving.forEach(all::addFuture);
        all.waitForIgnoreFailures(_ -> {}).then(_ -> platform.killComponent());
    }

    @Override
    public void listens(String agent, Topic<?> topic) {
        listeners.computeIfAbsent(topic.name(), _ -> new LinkedHashSet<>()).add(agent);
    }

    @Override
    public void ignores(String agent, Topic<?> topic) {
        listeners.getOrDefault(topic.name(), Set.of()).remove(agent);
    }

    @Override
    public void carry(Message<?> message, Consumer<String> arrival) {
        var said = new Spoken(message, arrival);
        Set<String> those = listeners.getOrDefault(message.topic().name(), Set.of());
        if (message.isForAll()) {
            List.copyOf(those).forEach(name -> hand(name, said));
        } else if (those.contains(message.to())) {
            Body sender = bodies.get(message.sender());
            Body receiver = bodies.get(message.to());
            if (message.content() instanceof Act && sender != null && receiver != null && receiver.isThere()) {
                sender.say(receiver, said);
            } else {
                hand(message.to(), said);
            }
        }
    }

    private void hand(String name, Spoken said) {
        Optional.ofNullable(bodies.get(name)).ifPresent(body -> body.hear(said));
    }

    @Override
    public void offers(String agent, Capability capability) {}

    @Override
    public void withdraws(String agent, Capability capability) {}
}
