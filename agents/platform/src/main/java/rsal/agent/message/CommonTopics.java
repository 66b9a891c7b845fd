package rsal.agent.message;

import java.util.List;
import rsal.agent.Topic;
import rsal.agent.TopicProvider;

/// The topics of this package.
public final class CommonTopics implements TopicProvider {
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
                GoalReached.TOPIC,
                Hello.TOPIC,
                Lookout.TOPIC,
                MapEnds.TOPIC,
                NewGoal.TOPIC,
                PoseReport.TOPIC,
                PoseRequest.TOPIC,
                FormationSlots.TOPIC,
                Sighting.TOPIC,
                Text.TOPIC,
                VictimFound.TOPIC,
                VictimHelped.TOPIC,
                Visited.TOPIC,
                Watch.TOPIC);
    }
}
