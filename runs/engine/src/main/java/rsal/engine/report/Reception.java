package rsal.engine.report;

/// How much one agent heard of what another said of a topic.
///
/// @param sender empty for all together, where there are too many to tell
/// @param listener empty for all together, where there are too many to tell
/// @param heard messages that reached it, each once however many copies there were
/// @param lost messages that it listened to and that did not get through
public record Reception(String sender, String listener, String topic, long heard, long lost) {}
