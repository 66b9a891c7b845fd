/// What an agent is, what it is given, and what it says; the contracts of agent platforms and agent languages.
/// What runs are judged by: metrics see what agents say and where robots truly are. Knows robots only as
/// devices of the middle layer.
module rsal.agent.api {
    requires transitive rsal.devices;
    requires static org.jspecify;

    exports rsal.agent;
    exports rsal.metric;

    uses rsal.agent.AgentHostProvider;
    uses rsal.agent.AgentLanguage;
    uses rsal.agent.AgentType;
    uses rsal.agent.TopicProvider;
}
