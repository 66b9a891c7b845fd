package rsal.agent;

import java.util.Optional;

/// What a message holds, when that says itself how people see it. Records of messages implement this; of
/// others, people see [Object#toString] as an event of the kind [#MESSAGE].
public interface MessageContent {
    /// The kind of the event that is a message like any other.
    String MESSAGE = "message";

    /// A sentence or a part of one, for people: `hunter-1 goes for prey-2`.
    default String words() {
        return toString();
    }

    /// The kind of the event that each of these is in a run: `message`, `goal`, `caught`. Empty for what agents
    /// say again and again, as their poses: that is no event. People see it when they ask for its topic.
    default Optional<String> eventKind() {
        return Optional.of(MESSAGE);
    }

    /// What people see of any content.
    static String wordsOf(Object content) {
        return content instanceof MessageContent own ? own.words() : content.toString();
    }

    /// As [#eventKind], of any content.
    static Optional<String> eventKindOf(Object content) {
        return content instanceof MessageContent own ? own.eventKind() : Optional.of(MESSAGE);
    }
}
