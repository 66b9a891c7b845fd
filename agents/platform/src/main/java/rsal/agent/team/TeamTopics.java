package rsal.agent.team;

import java.util.List;
import rsal.agent.Topic;
import rsal.agent.TopicProvider;

/// The topics on which members of a team negotiate.
public final class TeamTopics implements TopicProvider {
    @Override
    public List<Topic<?>> topics() {
        return List.of(AuctionBids.TOPIC);
    }
}
