package rsal.agent.message;

import java.util.List;
import rsal.agent.Topic;
import rsal.agent.TopicProvider;

/// The topics of this package.
public final class CommonTopics implements TopicProvider {
    @Override
    public List<Topic<?>> topics() {
        return List.of(GoalReached.TOPIC, Hello.TOPIC, NewGoal.TOPIC, PoseReport.TOPIC, PoseRequest.TOPIC, Text.TOPIC);
    }
}
