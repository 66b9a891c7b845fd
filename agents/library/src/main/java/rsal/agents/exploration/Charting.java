package rsal.agents.exploration;

import java.time.Duration;
import java.util.Comparator;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import rsal.agent.AgentContext;
import rsal.agent.team.PathCostEstimator;
import rsal.agent.team.Skill;
import rsal.agent.team.TaskRoute;
import rsal.agent.team.Work;
import rsal.agents.driving.NavigationClient;
import rsal.agents.parts.AgentWords;
import rsal.device.Mapper;
import rsal.device.Mapper.End;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;

/// The skill to go where the map ends, and to tell others where that is, if its map is theirs, too. Its robot has a
/// mapper, which leaves the driving to it from the first such job on.
public final class Charting implements Skill<Chart> {
    /// Two ends nearer to each other than this are one, as they move with each look [m].
    static final double SAME = 1.0;

    private static final Tolerance THERE = new Tolerance(0.3, 0.5); // m, rad
    private static final Duration LOOK = Duration.ofSeconds(1);
    private static final Duration REPEAT = Duration.ofSeconds(4);

    private final AgentContext self;
    private final String robot;
    private final NavigationClient driver;
    private final Mapper mapper;

    public Charting(AgentContext self, String robot, NavigationClient driver, Mapper mapper) {
        this.self = self;
        this.robot = robot;
        this.driver = driver;
        this.mapper = mapper;
    }

    public void begin() {
        self.subscribe(mapper, _ -> {});
        self.scheduler().every(REPEAT, this::publish);
    }

    private void publish() {
        boolean common =
                mapper.latest().filter(map -> map.frame().equals("map")).isPresent();
        if (common) { // a map of its own is no concern of others
            self.publish(
                    MapEnds.TOPIC,
                    new MapEnds(
                            robot,
                            mapper.ends().stream()
                                    .map(end -> new MapEnds.End(end.mapFromMiddle(), end.length()))
                                    .limit(MapEnds.MOST)
                                    .toList()));
        }
    }

    /// What ways cost: to where the map ends, as the mapper told last, without planning each; else by others.
    public PathCostEstimator pathCosts(PathCostEstimator others) {
        return (mapFromStart, mapFromGoal) -> mapper.ends().stream()
                .filter(end -> end.mapFromStand().equals(mapFromGoal))
                .findFirst()
                .map(end -> CompletableFuture.completedStage(end.cost()))
                .orElseGet(() -> others.cost(mapFromStart, mapFromGoal));
    }

    private Optional<End> end(Chart job) {
        return mapper.ends().stream()
                .filter(end -> distance(job, end) < SAME)
                .min(Comparator.comparingDouble(end -> distance(job, end)));
    }

    private static double distance(Chart job, End end) {
        return end.mapFromMiddle().distanceTo(job.mapFromEnd());
    }

    @Override
    public Optional<TaskRoute> course(Chart job) {
        return end(job).map(end -> TaskRoute.at(end.mapFromStand()));
    }

    @Override
    public void begin(Chart job, Work work) {
        mapper.pause(); // from now on the team decides
        self.state(job.name());
        var looks = self.scheduler().every(LOOK, () -> look(job, work));
        work.onEnd(() -> {
            looks.cancel();
            driver.stop();
        });
        end(job).ifPresentOrElse(end -> go(end, work), () -> work.done("is mapped"));
    }

    private void look(Chart job, Work work) {
        if (end(job).isEmpty()) {
            work.done("is mapped");
        }
    }

    private void go(End end, Work work) {
        driver.goTo(end.mapFromStand(), THERE, result -> {
            if (work.isOver()) {
                return; // somebody else's now
            }
            if (!(result instanceof Result.Cancelled)) {
                mapper.leaveAlone(end);
            }
            if (result instanceof Result.Reached) {
                work.done("was there");
            } else {
                work.fail(AgentWords.ending(result) + ". " + AgentWords.reason(result));
            }
        });
    }
}
