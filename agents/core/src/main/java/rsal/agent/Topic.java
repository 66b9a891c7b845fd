package rsal.agent;

/// A channel of messages of one type. Equal topics are the same channel.
public record Topic<M>(String name, Class<M> type) {}
