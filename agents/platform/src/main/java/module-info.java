/// Runs agents: carries their messages and knows who is there; conversations by FIPA's protocols, goals and
/// plans, boards, teams. Has the platform for plain Java agents.
module rsal.agent.platform {
    requires transitive rsal.agent.api;
    requires static org.jspecify;

    exports rsal.agent.bdi;
    exports rsal.agent.board;
    exports rsal.agent.message;
    exports rsal.agent.platform;
    exports rsal.agent.presence;
    exports rsal.agent.protocol;
    exports rsal.agent.team;

    provides rsal.agent.AgentHostProvider with
            rsal.agent.plain.PlainHostProvider;
    provides rsal.agent.TopicProvider with
            rsal.agent.message.CommonTopics,
            rsal.agent.team.TeamTopics;
    provides rsal.agent.team.AllocationType with
            rsal.agent.team.CentralAllocations.Bids,
            rsal.agent.team.CentralAllocations.FirstCome,
            rsal.agent.team.ConsensusBundles,
            rsal.agent.team.SequentialAuctions;

    uses rsal.agent.team.AllocationType;
}
