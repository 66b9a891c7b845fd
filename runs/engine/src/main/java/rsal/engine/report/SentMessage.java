package rsal.engine.report;

import java.time.Duration;

/// Something that an agent said to others.
///
/// @param time since the run's start
/// @param to name of the agent that it was for; empty when for all
/// @param conversation its id; empty when it was in none, as protocol and act then are
/// @param words what it was about, for people
public record SentMessage(
        Duration time,
        String from,
        String to,
        String topic,
        String conversation,
        String protocol,
        String act,
        String words) {}
