/// The agents that come with RSAL. Nothing depends on this module: scenarios name its agents by their keys.
module rsal.agent.library {
    requires rsal.agent.platform;
    requires rsal.behaviors;
    requires static org.jspecify;

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
    provides rsal.metric.MetricType with
            rsal.agents.formation.FormationMetric,
            rsal.agents.patrol.IdlenessMetric,
            rsal.agents.pursuit.CaptureMetric,
            rsal.agents.rescue.FoundMetric;
}
