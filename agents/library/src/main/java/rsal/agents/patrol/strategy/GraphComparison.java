package rsal.agents.patrol.strategy;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.ServiceLoader;
import java.util.SplittableRandom;
import java.util.TreeMap;
import rsal.agent.StrategyComparison;
import rsal.settings.Arguments;

/// Compares patrol strategies on a graph of patrolling_sim ([GraphFile]), in the ideal model ([IdealPatrol]). Metrics,
/// all
/// without the first quarter of a run, over places:
///
/// * `meanIdleness`: the mean time since the last visit
/// * `visitGap`: the mean of the mean times between two visits, with its standard deviation `visitGapDeviation`
/// * `worst`: the longest time without a visit
public final class GraphComparison implements StrategyComparison {
    private final TreeMap<String, PatrolStrategyType> types = new TreeMap<>();

    public GraphComparison() {
        ServiceLoader.load(PatrolStrategyType.class).forEach(type -> types.put(type.key(), type));
    }

    @Override
    public String key() {
        return "patrol";
    }

    @Override
    public List<String> strategies() {
        return List.copyOf(types.keySet());
    }

    @Override
    public String unit() {
        return "s";
    }

    @Override
    public List<Row> compare(String text, List<String> strategies, Team team) {
        PatrolGraph graph = GraphFile.read(text).graph(team.speed(), team.stop());
        var rows = new ArrayList<Row>();
        for (int robots : team.robots()) {
            types.forEach((key, type) -> {
                if (strategies.contains(key)) {
                    rows.add(row(graph, robots, type, team));
                }
            });
        }
        return rows;
    }

    private static Row row(PatrolGraph graph, int robots, PatrolStrategyType type, Team team) {
        double time = team.time();
        double idleness = 0;
        double gap = 0;
        double worst = 0;
        double deviation = 0;
        for (int seed = 1; seed <= team.seeds(); seed++) {
            int[] starts =
                    new SplittableRandom(seed).ints(robots, 0, graph.size()).toArray();
            VisitGaps gaps = IdealPatrol.run(
                    graph,
                    () -> type.create(Arguments.defaults(type.parameters())),
                    starts,
                    List.of(),
                    seed,
                    time / 4,
                    time);
            idleness += gaps.meanIdleness(time) / team.seeds();
            gap += gaps.meanGap(time) / team.seeds();
            worst += gaps.worst(time) / team.seeds();
            deviation += gaps.deviation(time) / team.seeds();
        }
        var means = new LinkedHashMap<String, Double>();
        means.put("meanIdleness", idleness);
        means.put("visitGap", gap);
        means.put("worst", worst);
        means.put("visitGapDeviation", deviation);
        return new Row(robots, type.key(), means);
    }
}
