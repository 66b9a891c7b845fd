package rsal.engine.report;

import java.time.Duration;
import java.util.Optional;

/// Something that happened in a run, in words for people.
///
/// @param sequence from 1, without gaps
/// @param time since the run's start
/// @param kind `run`, `agent`, `message`, `goal`, `caught`, `collision`, `operator`, `hand`, `health` or
///         `fault`
/// @param subject name of the robot, agent or device it is about; empty for the run itself
/// @param said when it is a message of its subject's: to whom, and what about. A [RunObserver] hears messages
///         by themselves
public record RunEvent(
        long sequence, Duration time, String kind, String subject, String text, Optional<SentMessage> said) {
    /// Something that is no message.
    public RunEvent(long sequence, Duration time, String kind, String subject, String text) {
        this(sequence, time, kind, subject, text, Optional.empty());
    }
}
