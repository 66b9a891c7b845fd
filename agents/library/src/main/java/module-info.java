/// The agents that come with RSAL, a package for each task, with its messages and metrics. Scenarios name its
/// agents by their keys. Only agents that work together with these depend on this module, as they use the same
/// messages.
module rsal.agent.library {
    requires transitive rsal.agent.platform;
    requires rsal.behaviors;
    requires static org.jspecify;

    exports rsal.agents.charging;
    exports rsal.agents.coverage;
    exports rsal.agents.driving;
    exports rsal.agents.exploration;
    exports rsal.agents.foraging;
    exports rsal.agents.formation;
    exports rsal.agents.parts;
    exports rsal.agents.patrol;
    exports rsal.agents.patrol.strategy;
    exports rsal.agents.pursuit;
    exports rsal.agents.pursuit.strategy;
    exports rsal.agents.rescue;
    exports rsal.agents.swarm;
    exports rsal.agents.team;

    provides rsal.agent.AgentType with
            rsal.agents.team.BlackboardMaster,
            rsal.agents.foraging.BlobAgent,
            rsal.agents.foraging.OverheadCamera,
            rsal.agents.foraging.Collect,
            rsal.agents.driving.Dispatch,
            rsal.agents.coverage.DeploymentAgent,
            rsal.agents.pursuit.Escape,
            rsal.agents.pursuit.Evade,
            rsal.agents.foraging.Explore,
            rsal.agents.foraging.FetchMaster,
            rsal.agents.foraging.Forage,
            rsal.agents.pursuit.Follow,
            rsal.agents.formation.Formation,
            rsal.agents.pursuit.HuntMaster,
            rsal.agents.exploration.Mapping,
            rsal.agents.patrol.Intrude,
            rsal.agents.driving.NavigationAgent,
            rsal.agents.formation.SwarmMember,
            rsal.agents.patrol.Patrol,
            rsal.agents.rescue.RescueMaster,
            rsal.agents.rescue.Rescuer.Helper,
            rsal.agents.rescue.Rescuer.Scout,
            rsal.agents.driving.ProxyMover,
            rsal.agents.driving.Roamer.WallFollow,
            rsal.agents.driving.Roamer.Wander,
            rsal.agents.swarm.SwarmRuleAgent,
            rsal.agents.team.WorkerAgent;
    provides rsal.metric.MetricType with
            rsal.agents.formation.FormationMetric,
            rsal.agents.patrol.IdlenessMetric,
            rsal.agents.pursuit.CaptureMetric,
            rsal.agents.rescue.FoundMetric,
            rsal.agents.swarm.SwarmMetric;
    provides rsal.agents.patrol.strategy.PatrolStrategyType with
            rsal.agents.patrol.strategy.BalancedTours,
            rsal.agents.patrol.strategy.Bids,
            rsal.agents.patrol.strategy.ConcurrentLearning,
            rsal.agents.patrol.strategy.ConscientiousReactive,
            rsal.agents.patrol.strategy.CyclicTour,
            rsal.agents.patrol.strategy.DynamicTasks,
            rsal.agents.patrol.strategy.ExpectedReactive,
            rsal.agents.patrol.strategy.GreedyBayesian,
            rsal.agents.patrol.strategy.HeuristicPathfinder,
            rsal.agents.patrol.strategy.HeuristicReactive,
            rsal.agents.patrol.strategy.PartitionTours,
            rsal.agents.patrol.strategy.RandomWalk,
            rsal.agents.patrol.strategy.StateExchange,
            rsal.agents.patrol.strategy.VoronoiCells;
    provides rsal.agents.pursuit.strategy.PursuitStrategyType with
            rsal.agents.pursuit.strategy.Direct,
            rsal.agents.pursuit.strategy.Encircle,
            rsal.agents.pursuit.strategy.RandomDrive;
    provides rsal.agents.swarm.SwarmRuleType with
            rsal.agents.swarm.Aggregation,
            rsal.agents.swarm.ConsensusFormation,
            rsal.agents.swarm.Dispersion,
            rsal.agents.swarm.Flocking;
    provides rsal.agent.StrategyComparison with
            rsal.agents.patrol.strategy.GraphComparison;
    provides rsal.agent.TopicProvider with
            rsal.agents.LibraryTopics;

    uses rsal.agents.patrol.strategy.PatrolStrategyType;
    uses rsal.agents.pursuit.strategy.PursuitStrategyType;
    uses rsal.agents.swarm.SwarmRuleType;
}
