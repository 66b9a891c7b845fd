package own;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import rsal.agent.AgentHost;
import rsal.agent.MessageTransport;
import rsal.agent.platform.ThreadLane;
import rsal.time.Scheduler;

/// Each agent on a thread of its own.
final class ThreadsHost implements AgentHost {
    private final Scheduler run;
    private final Optional<Mail> mail;
    private final Map<String, ExecutorService> threads = new HashMap<>(); // by agent

    ThreadsHost(Scheduler run, boolean withMail) {
        this.run = run;
        this.mail = withMail ? Optional.of(new Mail(run, thread("mail"), threads)) : Optional.empty();
    }

    /// One that drops what it is handed after its end.
    private static ExecutorService thread(String name) {
        return new ThreadPoolExecutor(
                1,
                1,
                0,
                TimeUnit.SECONDS,
                new LinkedBlockingQueue<>(),
                Thread.ofPlatform().daemon().name(name).factory(),
                new ThreadPoolExecutor.DiscardPolicy());
    }

    @Override
    public Scheduler lane(String name) {
        ExecutorService thread = thread(name);
        threads.put(name, thread);
        return new ThreadLane(run, thread);
    }

    @Override
    public Optional<MessageTransport> carrier() {
        return mail.map(MessageTransport.class::cast);
    }

    @Override
    public void end(String name) {
        threads.remove(name).shutdown();
    }

    @Override
    public void close() {
        mail.ifPresent(Mail::close);
    }
}
