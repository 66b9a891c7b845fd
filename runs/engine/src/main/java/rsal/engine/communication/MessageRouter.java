package rsal.engine.communication;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import rsal.agent.ChannelModel;
import rsal.agent.Message;

/// Carries messages: by radio first, then through what goes wrong besides. Counts what arrives and what does
/// not, and keeps the newest.
public final class MessageRouter implements ChannelModel {
    private final Optional<Radio> radio;
    private final Faults faults;
    private final Traffic traffic;
    private final Mailboxes mailboxes;
    private final Links links;

    /// @param radio empty when all hear all
    public MessageRouter(Optional<Radio> radio, Faults faults, Traffic traffic, Mailboxes mailboxes, Links links) {
        this.radio = radio;
        this.faults = faults;
        this.traffic = traffic;
        this.mailboxes = mailboxes;
        this.links = links;
    }

    @Override
    public List<Duration> copies(Message<?> message, String listener) {
        if (faults.isSilent(message.sender())) {
            return List.of(); // it has not been said
        }
        if (faults.isSilent(listener)) {
            traffic.unheard(message, listener);
            return List.of();
        }
        List<Duration> byRadio =
                radio.map(channel -> channel.copies(message, listener)).orElse(AT_ONCE);
        if (byRadio.isEmpty()) {
            traffic.lost(message, listener, radio.orElseThrow().why());
            return byRadio;
        }
        Duration late = byRadio.getFirst();
        List<Duration> copies = faults.delivery().copies(message, listener); // which tells of what is lost itself
        return late.isZero() ? copies : copies.stream().map(late::plus).toList();
    }

    @Override
    public boolean reaches(Message<?> message, String listener) {
        return faults.delivery().reaches(message, listener);
    }

    @Override
    public void heard(Message<?> message, String listener) {
        traffic.heard(message, listener);
        mailboxes.heard(message, listener);
        links.heard(message, listener);
    }

    @Override
    public void unheard(Message<?> message, String listener) {
        traffic.unheard(message, listener);
    }
}
