package rsal.agents.patrol.strategy;

import java.util.List;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Compares one cycle that all robots share, a tour for each robot, and everything between, and takes what
/// promises the shortest longest time between visits plus half of the mean; then robots visit overdue places of
/// others when their own can wait.
public final class BalancedTours implements PatrolStrategyType {
    private static final Parameter<Boolean> HELP = Parameter.flag(
            "help", true, "Whether robots visit overdue places of other tours when their own places can wait.");

    @Override
    public String key() {
        return "balanced";
    }

    @Override
    public String description() {
        return "Tours for groups of robots, with the shortest longest time between visits; robots help with overdue places.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(HELP);
    }

    @Override
    public PatrolStrategy create(Arguments arguments) {
        return new TourFollower(
                (graph, members) -> new TourSearch(graph).best(members), TourSearch.SPACING, arguments.get(HELP));
    }
}
