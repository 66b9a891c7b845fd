package rsal.agents.pursuit;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import rsal.agent.AgentContext;
import rsal.agent.message.PoseReport;
import rsal.agent.team.Skill;
import rsal.agent.team.TaskRoute;
import rsal.agent.team.Work;
import rsal.agents.driving.NavigationClient;
import rsal.agents.parts.TargetTracks;
import rsal.data.Pose2d;
import rsal.device.Navigator.Tolerance;
import rsal.device.PlaceFinder;
import rsal.device.Planner;
import rsal.robot.LineOfSight;
import rsal.robot.Robot;

/// The skill to go for a prey, alone or as one of several. While hunters are near enough to it that it may run, it
/// goes where it can stop the prey on the way that it would take ([Evasion]), so that several stop all of its ways;
/// else where the prey is. Without a planner and a place finder it always goes where it is.
final class Chasing implements Skill<Catch> {
    private static final double NOT_WORTH_A_NEW_PLAN = 0.1; // m
    private static final double NEAR = 10.0; // m, in which prey may see hunters

    private final AgentContext self;
    private final Robot robot;
    private final NavigationClient driver;
    private final TargetTracks sightings;
    private final Supplier<Optional<Pose2d>> mapFromBase;
    private final Optional<Evasion> evasion;
    private final double catchDistance;
    private final Duration updateInterval;
    private final Tolerance tolerance;

    Chasing(
            AgentContext self,
            Robot robot,
            NavigationClient driver,
            TargetTracks sightings,
            Supplier<Optional<Pose2d>> mapFromBase,
            double catchDistance,
            Duration updateInterval) {
        this.self = self;
        this.robot = robot;
        this.driver = driver;
        this.sightings = sightings;
        this.mapFromBase = mapFromBase;
        boolean guesses = robot.find(Planner.class).isPresent()
                && robot.find(PlaceFinder.class).isPresent();
        this.evasion = guesses ? Optional.of(new Evasion(self, robot)) : Optional.empty();
        this.catchDistance = catchDistance;
        this.updateInterval = updateInterval;
        this.tolerance = Tolerance.position(catchDistance / 2);
    }

    @Override
    public Optional<TaskRoute> course(Catch job) {
        return sightings.of(job.prey()).map(TaskRoute::at);
    }

    @Override
    public void begin(Catch job, Work work) {
        self.state(job.name());
        self.publish(Chase.TOPIC, new Chase(robot.id(), job.prey()));
        var updates = self.scheduler().every(updateInterval, () -> pursue(job, work));
        work.onEnd(() -> {
            updates.cancel();
            driver.stop();
        });
        pursue(job, work);
    }

    private void pursue(Catch job, Work work) {
        Optional<Pose2d> mapFromPrey = sightings.of(job.prey());
        Optional<Pose2d> here = mapFromBase.get();
        if (mapFromPrey.isEmpty()) {
            work.fail("Nothing is heard of %s any more.".formatted(job.prey()));
            return;
        }
        if (here.isEmpty()) {
            return; // until it knows
        }
        evasion.ifPresent(guess -> guess.learn(here.get()));
        Pose2d prey = mapFromPrey.get();
        List<Pose2d> hunters = huntersNear(prey, here.get());
        if (LineOfSight.reaches(robot, here.get(), prey, catchDistance)) {
            driver.stop();
        } else if (evasion.isEmpty() || hunters.isEmpty()) {
            go(prey);
        } else {
            evasion.get().flee(prey, hunters, Optional.empty(), path -> {
                if (path.isEmpty()) {
                    goOn(work, prey);
                } else {
                    evasion.get().intercept(here.get(), path.get(), place -> goOn(work, place.orElse(prey)));
                }
            });
        }
    }

    private List<Pose2d> huntersNear(Pose2d mapFromPrey, Pose2d here) {
        var hunters = new ArrayList<>(sightings
                .of(report ->
                        report.role().equals(robot.role()) && !report.robot().equals(robot.id()))
                .values());
        hunters.add(here);
        hunters.removeIf(hunter -> hunter.distanceTo(mapFromPrey) > NEAR);
        return hunters;
    }

    private void goOn(Work work, Pose2d aim) {
        if (!work.isOver()) {
            go(aim);
        }
    }

    private void go(Pose2d aim) {
        if (!driver.isOnItsWayTo(aim, NOT_WORTH_A_NEW_PLAN)) {
            driver.goTo(aim, tolerance, _ -> {});
        }
    }

    /// Stops at once when it has come near to its prey.
    void look(PoseReport report, Optional<Catch> job) {
        boolean near = job.filter(now -> now.prey().equals(report.robot())).isPresent()
                && mapFromBase
                        .get()
                        .filter(here -> LineOfSight.reaches(robot, here, report.mapFromBase(), catchDistance))
                        .isPresent();
        if (near) {
            driver.stop();
        }
    }
}
