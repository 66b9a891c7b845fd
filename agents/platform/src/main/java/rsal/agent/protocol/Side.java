package rsal.agent.protocol;

/// Which part somebody has in a conversation.
public enum Side {
    /// Began it.
    INITIATOR,
    /// Was spoken to.
    PARTICIPANT;

    Side other() {
        return this == INITIATOR ? PARTICIPANT : INITIATOR;
    }
}
