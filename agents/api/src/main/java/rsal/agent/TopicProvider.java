package rsal.agent;

import java.util.Collection;

/// Topics that belong to an installation, found by [java.util.ServiceLoader]. Nobody may use their names for
/// messages of another type. People can publish on them, and agents in AgentSpeak know them by name.
public interface TopicProvider {
    Collection<Topic<?>> topics();
}
