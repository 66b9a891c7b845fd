/// Agents: what they are given, how they talk, who is there, and the host that runs plain Java ones. Knows robots
/// only as devices of the middle layer; knows nothing of where they come from.
module rsal.agents {
    requires rsal.behaviors;
    requires transitive rsal.devices;
    requires static org.jspecify;

    exports rsal.agent;
    exports rsal.agent.bare;
    exports rsal.agent.bdi;
    exports rsal.agent.board;
    exports rsal.agent.message;
    exports rsal.agent.presence;
    exports rsal.agent.protocol;
    exports rsal.agent.team;

    uses rsal.agent.AgentHostProvider;
    uses rsal.agent.AgentType;

    provides rsal.agent.AgentHostProvider with
            rsal.agent.plain.PlainHostProvider;
    provides rsal.agent.AgentType with
            rsal.agents.BlackboardMaster,
            rsal.agents.BlobAgent,
            rsal.agents.OverheadCamera,
            rsal.agents.Collect,
            rsal.agents.Dispatch,
            rsal.agents.DeploymentAgent,
            rsal.agents.Escape,
            rsal.agents.Evade,
            rsal.agents.Explore,
            rsal.agents.FetchMaster,
            rsal.agents.Forage,
            rsal.agents.Follow,
            rsal.agents.Formation,
            rsal.agents.HuntMaster,
            rsal.agents.Mapping,
            rsal.agents.Intrude,
            rsal.agents.NavigationAgent,
            rsal.agents.Swarm,
            rsal.agents.Patrol,
            rsal.agents.RescueMaster,
            rsal.agents.Rescuer.Helper,
            rsal.agents.Rescuer.Scout,
            rsal.agents.View,
            rsal.agents.Roamer.WallFollow,
            rsal.agents.Roamer.Wander,
            rsal.agents.WorkerAgent;
}
