package own;

import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.function.Consumer;
import rsal.agent.Message;
import rsal.agent.MessageTransport;
import rsal.agent.ServiceDescription;
import rsal.agent.Topic;
import rsal.time.Scheduler;

/// One mailman, who brings one message after the other.
final class Mail implements MessageTransport {
    private final Scheduler run;
    private final ExecutorService mailman;
    private final Map<String, ExecutorService> threads; // by agent, as the host knows them
    private final Map<String, Set<String>> listeners = new HashMap<>(); // by topic

    Mail(Scheduler run, ExecutorService mailman, Map<String, ExecutorService> threads) {
        this.run = run;
        this.mailman = mailman;
        this.threads = threads;
    }

    @Override
    public void listens(String agent, Topic<?> topic) {
        listeners.computeIfAbsent(topic.name(), _ -> new LinkedHashSet<>()).add(agent);
    }

    @Override
    public void ignores(String agent, Topic<?> topic) {
        listeners.get(topic.name()).remove(agent);
    }

    @Override
    public void carry(Message<?> message, Consumer<String> arrival) {
        mailman.execute(() -> run.exclusively(() -> bring(message, arrival)));
    }

    /// On each listener's own thread it is told that the message has arrived.
    private void bring(Message<?> message, Consumer<String> arrival) {
        Set<String> all = listeners.getOrDefault(message.topic().name(), Set.of());
        for (String agent : message.isForAll() ? all : List.of(message.to())) {
            ExecutorService thread = threads.get(agent);
            if (thread != null && all.contains(agent)) {
                thread.execute(() -> run.exclusively(() -> arrival.accept(agent)));
            }
        }
    }

    @Override
    public void offers(String agent, ServiceDescription capability) {} // nobody looks for it here

    @Override
    public void withdraws(String agent, ServiceDescription capability) {}

    void close() {
        mailman.shutdown();
    }
}
