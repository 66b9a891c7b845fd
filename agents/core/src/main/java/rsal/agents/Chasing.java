package rsal.agents;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import rsal.agent.AgentContext;
import rsal.agent.message.Chase;
import rsal.agent.message.PoseReport;
import rsal.agent.team.Course;
import rsal.agent.team.Skill;
import rsal.agent.team.Work;
import rsal.data.Pose2d;
import rsal.device.Navigator.Tolerance;
import rsal.robot.Robot;

/// The skill to go for a prey, as one of several: some go where it is, others where it would go to if it ran from
/// those,
/// so that it runs into them.
final class Chasing implements Skill<Catch> {
    private static final double AHEAD = 3.0; // m on the prey's other side
    private static final double NOT_WORTH_A_NEW_PLAN = 0.1; // m

    private final AgentContext self;
    private final Robot robot;
    private final Driver driver;
    private final Sightings sightings;
    private final Supplier<Optional<Pose2d>> mapFromBase;
    private final double catchDistance;
    private final Duration updateInterval;
    private final Tolerance tolerance;
    private final Map<String, String> chases = new TreeMap<>(); // prey by hunter that goes where it is

    Chasing(
            AgentContext self,
            Robot robot,
            Driver driver,
            Sightings sightings,
            Supplier<Optional<Pose2d>> mapFromBase,
            double catchDistance,
            Duration updateInterval) {
        this.self = self;
        this.robot = robot;
        this.driver = driver;
        this.sightings = sightings;
        this.mapFromBase = mapFromBase;
        this.catchDistance = catchDistance;
        this.updateInterval = updateInterval;
        this.tolerance = Tolerance.position(catchDistance / 2);
        self.subscribe(Chase.TOPIC, message -> note(message.content()));
    }

    private void note(Chase chase) {
        chases.put(chase.hunter(), chase.prey());
    }

    @Override
    public Optional<Course> course(Catch job) {
        return aim(job).map(Course::at);
    }

    /// Where to go for it now; empty while it is not seen.
    private Optional<Pose2d> aim(Catch job) {
        Optional<Pose2d> mapFromPrey = sightings.of(job.prey());
        return job.fromBehind() ? mapFromPrey : mapFromPrey.map(prey -> otherSide(job.prey(), prey));
    }

    /// Beyond the prey, as seen from the nearest of those who go where it is.
    private Pose2d otherSide(String prey, Pose2d mapFromPrey) {
        Optional<Pose2d> mapFromHunter = chases.entrySet().stream()
                .filter(chase ->
                        chase.getValue().equals(prey) && !chase.getKey().equals(robot.id()))
                .flatMap(chase -> sightings.of(chase.getKey()).stream())
                .min((a, b) -> Double.compare(a.distanceTo(mapFromPrey), b.distanceTo(mapFromPrey)));
        if (mapFromHunter.isEmpty()) {
            return mapFromPrey;
        }
        double away = Math.atan2(
                mapFromPrey.y() - mapFromHunter.get().y(),
                mapFromPrey.x() - mapFromHunter.get().x());
        return new Pose2d(
                mapFromPrey.x() + AHEAD * Math.cos(away),
                mapFromPrey.y() + AHEAD * Math.sin(away),
                mapFromPrey.theta());
    }

    @Override
    public void begin(Catch job, Work work) {
        self.state(job.name());
        var chase = new Chase(robot.id(), job.fromBehind() ? job.prey() : "");
        self.publish(Chase.TOPIC, chase);
        var updates = self.scheduler().every(updateInterval, () -> pursue(job, work));
        work.onEnd(() -> {
            updates.cancel();
            driver.stop();
        });
        pursue(job, work);
    }

    private void pursue(Catch job, Work work) {
        Optional<Pose2d> mapFromPrey = sightings.of(job.prey());
        if (mapFromPrey.isEmpty()) {
            work.fail("Nothing is heard of %s any more.".formatted(job.prey()));
            return;
        }
        boolean near = mapFromBase
                .get()
                .filter(here -> here.distanceTo(mapFromPrey.get()) < catchDistance)
                .isPresent();
        if (near) {
            driver.stop();
            return;
        }
        Pose2d aim = aim(job).orElseThrow(); // it is seen
        boolean underWay = driver.mapFromGoal()
                .filter(goal -> goal.distanceTo(aim) < NOT_WORTH_A_NEW_PLAN)
                .isPresent();
        if (!underWay) {
            driver.goTo(aim, tolerance, _ -> {});
        }
    }

    /// Stops at once when it has come near to its prey.
    void look(PoseReport report, Optional<Catch> job) {
        boolean near = job.filter(now -> now.prey().equals(report.robot())).isPresent()
                && mapFromBase
                        .get()
                        .filter(here -> here.distanceTo(report.mapFromBase()) < catchDistance)
                        .isPresent();
        if (near) {
            driver.stop();
        }
    }
}
