package rsal.agents;

import java.util.List;
import rsal.agent.Topic;
import rsal.agent.TopicProvider;
import rsal.agents.charging.ChargerTaken;
import rsal.agents.exploration.Lookout;
import rsal.agents.exploration.MapEnds;
import rsal.agents.foraging.CollectGoal;
import rsal.agents.foraging.Collected;
import rsal.agents.foraging.Depot;
import rsal.agents.formation.FormationSlots;
import rsal.agents.patrol.Alarm;
import rsal.agents.patrol.PatrolOrder;
import rsal.agents.patrol.PatrolReport;
import rsal.agents.patrol.Visited;
import rsal.agents.patrol.Watch;
import rsal.agents.pursuit.Caught;
import rsal.agents.pursuit.Chase;
import rsal.agents.pursuit.PursuitGoal;
import rsal.agents.pursuit.Sighting;
import rsal.agents.rescue.VictimFound;
import rsal.agents.rescue.VictimHelped;

/// The topics on which agents that come with RSAL work together.
public final class LibraryTopics implements TopicProvider {
    @Override
    public List<Topic<?>> topics() {
        return List.of(
                Alarm.TOPIC,
                Caught.TOPIC,
                ChargerTaken.TOPIC,
                Chase.TOPIC,
                CollectGoal.TOPIC,
                Collected.TOPIC,
                Depot.TOPIC,
                FormationSlots.TOPIC,
                Lookout.TOPIC,
                MapEnds.TOPIC,
                PatrolOrder.TOPIC,
                PatrolReport.TOPIC,
                PursuitGoal.TOPIC,
                Sighting.TOPIC,
                VictimFound.TOPIC,
                VictimHelped.TOPIC,
                Visited.TOPIC,
                Watch.TOPIC);
    }
}
