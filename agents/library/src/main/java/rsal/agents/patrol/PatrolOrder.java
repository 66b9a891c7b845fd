package rsal.agents.patrol;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import rsal.agent.MessageContent;
import rsal.agent.Topic;
import rsal.agent.message.MessageCheck;
import rsal.agents.patrol.strategy.PatrolGraph;
import rsal.agents.patrol.strategy.PatrolStrategyType;
import rsal.data.Point2d;
import rsal.settings.PluginChoice;

/// All robots of a team that hear this patrol these places from now on, each by its own decisions. Repeated for
/// those that come later; who repeats it may fail.
///
/// @param mapFromPlaces the places, in the map frame [m]; at most [PatrolGraph#MOST]
/// @param strategy a [PatrolStrategyType], by which each robot decides where it goes next
/// @param stayTime for which a robot stands at a place; not negative
public record PatrolOrder(List<Point2d> mapFromPlaces, PluginChoice strategy, Duration stayTime)
        implements MessageContent {
    public static final Topic<PatrolOrder> TOPIC = new Topic<>("patrol-order", PatrolOrder.class);

    public PatrolOrder {
        mapFromPlaces = List.copyOf(mapFromPlaces);
        mapFromPlaces.forEach(place -> MessageCheck.somewhere("place", place));
        MessageCheck.given("strategy", strategy);
        MessageCheck.given("stay time", stayTime);
        if (mapFromPlaces.size() > PatrolGraph.MOST) {
            throw new IllegalArgumentException("A patrol has at most %d places, not '%d'. Give it fewer places."
                    .formatted(PatrolGraph.MOST, mapFromPlaces.size()));
        }
        if (!(strategy.plugin() instanceof PatrolStrategyType)) {
            throw new IllegalArgumentException("A patrol's strategy is of kind 'patrolStrategy', which '%s' is not."
                    .formatted(strategy.plugin().key()));
        }
        if (stayTime.isNegative()) {
            throw new IllegalArgumentException(
                    "A robot stays at a place for at least 0 s, not '%s'.".formatted(stayTime));
        }
    }

    @Override
    public String words() {
        return "patrol %d places by '%s'".formatted(mapFromPlaces.size(), strategy);
    }

    /// It is said again and again.
    @Override
    public Optional<String> eventKind() {
        return Optional.empty();
    }
}
