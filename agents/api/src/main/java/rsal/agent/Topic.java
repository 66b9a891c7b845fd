package rsal.agent;

import java.util.Objects;

/// A channel of messages of one type. Equal topics are the same channel.
public record Topic<M>(String name, Class<M> type) {
    public Topic {
        Objects.requireNonNull(name, "A topic must have a name.");
        Objects.requireNonNull(type, "A topic must have a type.");
    }
}
