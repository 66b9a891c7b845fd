package rsal.agent.protocol;

/// Something begun with one or several partners.
public interface Conversation {
    /// Unique in a run.
    String id();

    /// Tells the partners that it is not wanted any more. It ends as cancelled, at once; after its end this does
    /// nothing.
    void cancel();
}
