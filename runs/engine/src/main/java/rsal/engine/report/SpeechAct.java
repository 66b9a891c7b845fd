package rsal.engine.report;

import java.time.Duration;

/// An act of a conversation, as it was said.
///
/// @param time since the run's start
/// @param from name of the agent that said it
/// @param to name of the agent that it was for
/// @param conversation its id
/// @param protocol as FIPA calls it: `fipa-request`
/// @param act as FIPA calls it: `inform`
/// @param words what it was about, clipped
/// @param times how often it was said until its partner showed that it had heard it
public record SpeechAct(
        Duration time,
        String from,
        String to,
        String conversation,
        String protocol,
        String act,
        String words,
        int times) {}
