package rsal.agents.patrol;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.function.Supplier;
import rsal.agent.AgentContext;
import rsal.agent.team.Skill;
import rsal.agent.team.TaskRoute;
import rsal.agent.team.Work;
import rsal.agents.driving.NavigationClient;
import rsal.agents.parts.AgentWords;
import rsal.agents.patrol.Intruders.Track;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;

/// The skill to go where an intruder was seen last, no matter who saw it, and to stay with it until it has stood for a
/// while.
public final class Meeting implements Skill<Meet> {
    private static final double BEFORE = 1.0; // m, where to stop in front of one that is in sight
    private static final double THERE = 1.3; // m, from where it was seen last
    private static final Tolerance NEAR = Tolerance.position(1.2);
    private static final Tolerance CLOSE = Tolerance.position(0.3);
    private static final Tolerance FACING = new Tolerance(0.5, Math.toRadians(10));
    private static final double MET = 2.5; // m
    private static final double STOOD = 0.5; // m that a sighting can be off
    private static final Duration SEEN = Duration.ofSeconds(2); // ago
    private static final double NOT_WORTH_A_NEW_PLAN = 0.5; // m
    private static final Duration PERIOD = Duration.ofSeconds(1);
    private static final Duration STAY_TIME = Duration.ofSeconds(5);

    private final AgentContext self;
    private final NavigationClient driver;
    private final Supplier<Optional<Pose2d>> mapFromBase;
    private final Intruders intruders = new Intruders();
    private Instant inSightUntil = Instant.MIN;

    public Meeting(AgentContext self, NavigationClient driver, Supplier<Optional<Pose2d>> mapFromBase) {
        this.self = self;
        this.driver = driver;
        this.mapFromBase = mapFromBase;
        self.subscribe(
                Alarm.TOPIC,
                message -> intruders.note(
                        message.content().mapFromIntruder(), self.scheduler().instant()));
    }

    /// Its own robot sees an intruder.
    public void see(Point2d mapFromIntruder) {
        Instant now = self.scheduler().instant();
        intruders.note(mapFromIntruder, now);
        inSightUntil = now.plus(SEEN);
    }

    private Track track(Meet job) {
        Instant now = self.scheduler().instant();
        return intruders
                .of(job.mapFromIntruder(), now)
                .orElseGet(() -> intruders.note(job.mapFromIntruder(), now)); // the alarm was not heard
    }

    @Override
    public Optional<TaskRoute> course(Meet job) {
        return Optional.of(TaskRoute.at(AgentWords.pose(track(job).mapFromIntruder())));
    }

    @Override
    public void begin(Meet job, Work work) {
        self.state(job.name());
        var pursuit = new Pursuit(track(job), work);
        var updates = self.scheduler().every(PERIOD, pursuit::goOn);
        work.onEnd(() -> {
            updates.cancel();
            driver.stop();
        });
        pursuit.goOn();
    }

    private final class Pursuit {
        private final Track track;
        private final Work work;
        private Duration near = Duration.ZERO;
        private Point2d mapFromStand; // where it was when it was seen to stand

        Pursuit(Track track, Work work) {
            this.track = track;
            this.work = work;
            this.mapFromStand = track.mapFromIntruder();
        }

        void goOn() {
            mapFromBase.get().ifPresent(this::goOn);
        }

        private void goOn(Pose2d here) {
            Instant now = self.scheduler().instant();
            Point2d there = track.mapFromIntruder();
            double distance = here.position().distanceTo(there);
            boolean met = distance < MET && track.age(now) <= SEEN.toSeconds();
            boolean stands = there.distanceTo(mapFromStand) < STOOD;
            near = met && stands ? near.plus(PERIOD) : Duration.ZERO;
            mapFromStand = stands ? mapFromStand : there;
            if (near.compareTo(STAY_TIME) > 0) {
                work.done("met at " + AgentWords.place(AgentWords.pose(track.mapFromIntruder())));
            } else if (distance > THERE) {
                boolean inSight = now.isBefore(inSightUntil);
                drive(inSight ? before(here, there) : AgentWords.pose(track.mapFromIntruder()), inSight ? CLOSE : NEAR);
            } else if (!met) {
                drive(new Pose2d(here.x(), here.y(), here.theta() + here.bearingTo(there)), FACING);
            }
        }

        /// On the straight way to it, where nothing is: navigators find no way to where something stands.
        private static Pose2d before(Pose2d here, Point2d there) {
            double share = 1 - BEFORE / here.position().distanceTo(there);
            return new Pose2d(
                    here.x() + share * (there.x() - here.x()), here.y() + share * (there.y() - here.y()), here.theta());
        }

        private void drive(Pose2d mapFromGoal, Tolerance tolerance) {
            if (!driver.isOnItsWayTo(mapFromGoal, NOT_WORTH_A_NEW_PLAN)) {
                driver.goTo(mapFromGoal, tolerance, this::ended);
            }
        }

        private void ended(Result result) {
            if (result instanceof Result.NoPath || result instanceof Result.Stuck) {
                work.fail(AgentWords.ending(result) + ". " + AgentWords.reason(result));
            }
        }
    }
}
