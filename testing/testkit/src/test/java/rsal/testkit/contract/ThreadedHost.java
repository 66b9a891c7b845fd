package rsal.testkit.contract;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import rsal.agent.AgentHost;
import rsal.agent.AgentHostProvider;
import rsal.agent.Capability;
import rsal.agent.Carrier;
import rsal.agent.Message;
import rsal.agent.ThreadLane;
import rsal.agent.Topic;
import rsal.settings.Arguments;
import rsal.time.Scheduler;

/// A thread for each agent, and one more for the mail, as multi-agent systems with threads of their own have them.
final class ThreadedHost implements AgentHost {
    private final Scheduler run;
    private final boolean carries;
    private final Map<String, ExecutorService> threads = new HashMap<>(); // by agent
    private final Map<String, Set<String>> listeners = new HashMap<>(); // by topic
    private final ExecutorService mail = Executors.newSingleThreadExecutor();

    private ThreadedHost(Scheduler run, boolean carries) {
        this.run = run;
        this.carries = carries;
    }

    @Override
    public Scheduler lane(String name) {
        ExecutorService thread = Executors.newSingleThreadExecutor();
        threads.put(name, thread);
        return new ThreadLane(run, task -> {
            if (!thread.isShutdown()) {
                thread.execute(task);
            }
        });
    }

    @Override
    public Optional<Carrier> carrier() {
        return carries ? Optional.of(new Mail()) : Optional.empty();
    }

    @Override
    public void end(String name) {
        Optional.ofNullable(threads.remove(name)).ifPresent(ExecutorService::shutdown);
        listeners.values().forEach(all -> all.remove(name));
    }

    @Override
    public void close() {
        mail.shutdown();
    }

    private final class Mail implements Carrier {
        @Override
        public void listens(String agent, Topic<?> topic) {
            listeners.computeIfAbsent(topic.name(), _ -> new HashSet<>()).add(agent);
        }

        @Override
        public void ignores(String agent, Topic<?> topic) {
            listeners.getOrDefault(topic.name(), new HashSet<>()).remove(agent);
        }

        @Override
        public void carry(Message<?> message, Consumer<String> arrival) {
            mail.execute(() -> run.exclusively(() -> deliver(message, arrival)));
        }

        private void deliver(Message<?> message, Consumer<String> arrival) {
            Set<String> all = listeners.getOrDefault(message.topic().name(), Set.of());
            (message.isForAll() ? List.copyOf(all) : List.of(message.to()))
                    .stream()
                            .filter(all::contains)
                            .forEach(agent -> Optional.ofNullable(threads.get(agent))
                                    .ifPresent(thread ->
                                            thread.execute(() -> run.exclusively(() -> arrival.accept(agent)))));
        }

        @Override
        public void offers(String agent, Capability capability) {}

        @Override
        public void withdraws(String agent, Capability capability) {}
    }

    record Provider(boolean carries) implements AgentHostProvider {
        @Override
        public String key() {
            return "threaded";
        }

        @Override
        public String description() {
            return "A thread for each agent.";
        }

        @Override
        public boolean followsSchedulerTime() {
            return false;
        }

        @Override
        public AgentHost create(Arguments settings, Scheduler scheduler) {
            return new ThreadedHost(scheduler, carries);
        }
    }
}
