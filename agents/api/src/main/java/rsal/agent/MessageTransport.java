package rsal.agent;

import java.util.function.Consumer;

/// Carries what agents say by the means of a multi-agent system, so that its own tools see it. Who hears it, and what a
/// bad radio makes of it, is decided by us when it arrives.
///
/// All calls on the run's thread, or on that of one of its agents while it is that one's turn.
public interface MessageTransport {
    /// From now on this agent is to be brought what is said there.
    void listens(String agent, Topic<?> topic);

    /// No more; told of an agent that ends, too, before that ends.
    void ignores(String agent, Topic<?> topic);

    /// Brings a message to all who listen to its topic by then, or to the one it is for. What one says arrives at
    /// another in the order in which it was said.
    ///
    /// @param message sent by one of its agents, or by a person
    /// @param arrival to be told the name of each whom it has reached, on that one's lane; of the sender, too, if
    /// need be
    void carry(Message<?> message, Consumer<String> arrival);

    /// Others may look for it there. Replaces what the agent offered under that name.
    void offers(String agent, ServiceDescription capability);

    void withdraws(String agent, ServiceDescription capability);
}
