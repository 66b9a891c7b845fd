package rsal.bench;

import java.util.ArrayList;
import java.util.List;
import rsal.bench.mas.HostBench;
import rsal.bench.mas.LanguageBench;
import rsal.bench.mas.OverheadBench;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.MeasurementFailed;
import rsal.bench.navigation.BarnBench;
import rsal.bench.navigation.ExploreBench;
import rsal.bench.navigation.HonestyBench;
import rsal.bench.navigation.LocalizationBench;
import rsal.bench.navigation.MappingBench;
import rsal.bench.navigation.OfficeBench;
import rsal.bench.navigation.PlanningBench;
import rsal.bench.navigation.TightBench;
import rsal.bench.page.PageBench;
import rsal.bench.python.PythonBench;
import rsal.bench.robots.RemoteBench;
import rsal.bench.robots.RunBench;
import rsal.bench.robots.SwarmBench;
import rsal.bench.rtps.DiscoveryBench;
import rsal.bench.rtps.JoinBench;
import rsal.bench.rtps.LossBench;
import rsal.bench.rtps.MapBench;
import rsal.bench.rtps.TripBench;
import rsal.bench.scenario.AllotmentBench;
import rsal.bench.scenario.CollectBench;
import rsal.bench.scenario.CoverageBench;
import rsal.bench.scenario.FleetBench;
import rsal.bench.scenario.FormationBench;
import rsal.bench.scenario.HuntBench;
import rsal.bench.scenario.PatrolBench;
import rsal.bench.scenario.SpreadBench;

/// Benchmarks that belong together.
///
/// @param name `sim`
public record Area(String name, List<Bench> benches) {
    public Area {
        benches = List.copyOf(benches);
    }

    /// Names of what it measures, in its order. They are dotted and stay, as people compare by them.
    public List<String> names() {
        return benches.stream().flatMap(bench -> bench.names().stream()).toList();
    }

    /// Measures what is asked for. Takes minutes. A benchmark that fails does not end the others.
    ///
    /// @return why some could not be measured; empty if none failed
    public List<String> measure(BenchmarkRequest assignment) {
        var failures = new ArrayList<String>();
        for (Bench bench : benches) {
            if (assignment.wantsAny(bench.names())) {
                try {
                    bench.measure(assignment);
                } catch (MeasurementFailed e) {
                    failures.add("'%s' and those after it of the same benchmark were not all measured. %s"
                            .formatted(first(bench, assignment), e.getMessage()));
                }
            }
        }
        return failures;
    }

    private static String first(Bench bench, BenchmarkRequest assignment) {
        return bench.names().stream().filter(assignment::wants).findFirst().orElseThrow();
    }

    /// All that there are.
    public static List<Area> all() {
        return List.of(
                new Area("sim", List.of(new SwarmBench())),
                new Area("run", List.of(new RunBench())),
                new Area("mas", List.of(new HostBench(), new OverheadBench(), new LanguageBench())),
                new Area("player", List.of(RemoteBench.player())),
                new Area(
                        "ros2",
                        List.of(
                                RemoteBench.scannersOfRos2(),
                                RemoteBench.scannersOfPlayer(),
                                new LossBench(),
                                new MapBench(),
                                new DiscoveryBench(),
                                new TripBench(),
                                new JoinBench())),
                new Area("python", List.of(new PythonBench())),
                new Area("page", List.of(new PageBench())),
                new Area(
                        "navigation",
                        List.of(
                                new LocalizationBench(),
                                new HonestyBench(),
                                new PlanningBench(),
                                new BarnBench(),
                                new OfficeBench(),
                                new TightBench(),
                                new MappingBench(),
                                new ExploreBench())),
                new Area(
                        "scenarios",
                        List.of(
                                new SpreadBench(),
                                new AllotmentBench(),
                                new FleetBench(),
                                new FormationBench(),
                                new CoverageBench(),
                                new CollectBench(),
                                new HuntBench(),
                                new PatrolBench())));
    }
}
