package rsal.jade;

import rsal.settings.Parameter;

/// A window of JADE's own, which is an agent itself.
enum Tool {
    SNIFFER(
            "sniffer",
            "jade.tools.sniffer.Sniffer",
            "JADE's window of messages between agents (sniffer)",
            "*"), // all agents
    RMA("rma", "jade.tools.rma.rma", "JADE's window of all agents, which can end them (remote management agent)", ""),
    INTROSPECTOR(
            "introspector",
            "jade.tools.introspector.Introspector",
            "JADE's window of the queued behaviors and messages of an agent (introspector)",
            "");

    private final String agent;
    private final String type;
    private final String description;
    private final String watched;

    Tool(String agent, String type, String description, String watched) {
        this.agent = agent;
        this.type = type;
        this.description = description;
        this.watched = watched;
    }

    Parameter<Boolean> parameter() {
        return Parameter.flag(agent, false, description);
    }

    /// Name of its agent, and of the setting that opens it.
    String agent() {
        return agent;
    }

    /// Name of the class of its agent.
    String type() {
        return type;
    }

    /// Of its agent.
    Object[] arguments() {
        return watched.isEmpty() ? new Object[0] : new Object[] {watched};
    }

    @Override
    public String toString() {
        return agent;
    }
}
