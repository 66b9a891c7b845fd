package rsal.engine.communication;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import rsal.agent.Message;
import rsal.engine.event.NewestByName;
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

    private final Instant began;
    private final Map<String, NewestByName<Message<?>>> byAgent = NewestByName.touchedLast(MOST_AGENTS);

    /// @param began when the run did
    public Mailboxes(Instant began) {
        this.began = began;
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
                Duration.between(began, message.time()),
                message.sender(),
                message.isForAll(),
                message.topic().name(),
                Words.clipped(message));
    }
}
