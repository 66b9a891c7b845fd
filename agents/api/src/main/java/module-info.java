/// What an agent is, what it is given, and what it says; the contracts of agent platforms and agent languages.
/// Knows robots only as devices of the middle layer.
module rsal.agent.api {
    requires transitive rsal.devices;
    requires static org.jspecify;

    exports rsal.agent;

    uses rsal.agent.AgentHostProvider;
    uses rsal.agent.AgentType;
}
