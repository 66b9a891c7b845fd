package rsal.agent.message;

import java.util.List;
import rsal.agent.Topic;

/// The topics of this package, whose names nobody may use for something else.
public final class Topics {
    public static final List<Topic<?>> ALL = List.of(
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

    private Topics() {}
}
