package rsal.engine.communication;

import java.util.List;
import java.util.Map;
import rsal.agent.Message;
import rsal.engine.event.NewestByName;
import rsal.engine.event.RunClock;
import rsal.engine.report.ReceivedMessage;
import rsal.engine.report.Words;

/// What reached each agent lately, for people to read: the newest of each topic, so that poses at 10 Hz do not push out
/// the one request. Words are made only for those who ask.
public final class Mailboxes {
    /// How many messages of one topic are kept for an agent.
    static final int MOST_OF_A_TOPIC = 8;

    /// How many topics are kept for an agent: those heard of last.
    static final int MOST_TOPICS = 32;

    /// How many agents' are kept: of those that heard something last.
    private static final int MOST_AGENTS = 20_000;

    private final RunClock clock;
    private final Map<String, NewestByName<Message<?>>> byAgent = NewestByName.touchedLast(MOST_AGENTS);

    public Mailboxes(RunClock clock) {
        this.clock = clock;
    }

    void heard(Message<?> message, String listener) {
        byAgent.computeIfAbsent(listener, _ -> new NewestByName<>(MOST_OF_A_TOPIC, MOST_TOPICS))
                .add(message.topic().name(), message);
    }

    /// What reached an agent, oldest first.
    public List<ReceivedMessage> of(String agent) {
        NewestByName<Message<?>> letters = byAgent.get(agent);
        return letters == null
                ? List.of()
                : letters.all().stream().map(this::mail).toList();
    }

    private ReceivedMessage mail(Message<?> message) {
        return new ReceivedMessage(
                clock.at(message.time()),
                message.sender(),
                message.isForAll(),
                message.topic().name(),
                Words.clipped(message));
    }
}
