package rsal.agents.rescue;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.team.Skill;
import rsal.agent.team.TaskRoute;
import rsal.agent.team.Work;
import rsal.agents.driving.NavigationClient;
import rsal.agents.exploration.Exploring;
import rsal.agents.parts.AgentWords;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.time.Task;

/// The skill to help a victim: to drive there, to see it within reach with the robot's own eyes, and to stay for a
/// while. Where it was said to be counts until the robot sees it.
final class HelpVictim implements Skill<Help> {
    private static final Duration LOOK = Duration.ofMillis(500);
    private static final double SPEED = 0.4; // m/s, to tell what staying is worth
    private static final double MOVED = 0.3; // m
    private static final double INSIDE = 0.9; // of its reach: how near it means to get
    private static final double WAY = 0.7; // of its reach: how near a way must lead that its navigator takes
    private static final double FACING = Math.toRadians(20);
    private static final int TRIES = 4;

    private final AgentContext self;
    private final NavigationClient driver;
    private final Scouting scouting;
    private final Supplier<Optional<Pose2d>> mapFromBase;
    private final Exploring exploring;
    private final double reach;
    private final Duration stay;

    /// @param reach how near to a victim's middle a robot's must be to help it [m]
    HelpVictim(Rescuer.Parts parts, double reach, Duration stay) {
        this.self = parts.self();
        this.driver = parts.driver();
        this.scouting = parts.scouting();
        this.mapFromBase = parts.reporter()::mapFromBase;
        this.exploring = parts.exploring();
        this.reach = reach;
        this.stay = stay;
    }

    /// How near to a victim a way must lead [m].
    static double near(double reach) {
        return WAY * reach;
    }

    @Override
    public Optional<TaskRoute> course(Help job) {
        Pose2d mapFromVictim = at(mapFromVictim(job), 0);
        return Optional.of(new TaskRoute(mapFromVictim, mapFromVictim, SPEED * stay.toMillis() / 1000.0));
    }

    @Override
    public void begin(Help job, Work work) {
        self.state(job.name());
        exploring.pause();
        new Mission(job, work).begin();
    }

    private Point2d mapFromVictim(Help job) {
        return scouting.mapFromVictim(job.victim()).orElse(job.mapFromVictim());
    }

    private static Pose2d at(Point2d place, double theta) {
        return new Pose2d(place.x(), place.y(), theta);
    }

    /// One of them.
    private final class Mission {
        private final Help job;
        private final Work work;
        private @Nullable Point2d goal; // the victim, as the drive under way has it
        private @Nullable Instant since; // it is within reach
        private int tries;

        Mission(Help job, Work work) {
            this.job = job;
            this.work = work;
        }

        void begin() {
            Task looking = self.scheduler().every(LOOK, this::look);
            work.onEnd(() -> {
                looking.cancel();
                driver.stop();
                exploring.goOn();
            });
            look();
        }

        private void look() {
            boolean within = scouting.baseFromVictim(job.victim())
                    .filter(place -> Math.hypot(place.x(), place.y()) <= reach)
                    .isPresent();
            if (!within) {
                since = null;
                approach();
                return;
            }
            Instant now = self.scheduler().instant();
            if (since == null) {
                since = now;
                goal = null;
                driver.stop();
                self.state("helping victim " + job.victim());
            } else if (!now.isBefore(since.plus(stay))) {
                work.done("helped");
            }
        }

        /// Drives on, unless it does already.
        private void approach() {
            Point2d mapFromVictim = mapFromVictim(job);
            boolean inProgress = goal != null && goal.distanceTo(mapFromVictim) < MOVED;
            Optional<Pose2d> here = mapFromBase.get();
            if (inProgress || here.isEmpty()) {
                return;
            }
            if (goal == null && ++tries > TRIES) {
                work.fail("I don't see it where it is said to be.");
                return;
            }
            goal = mapFromVictim;
            double bearing = Math.atan2(
                    mapFromVictim.y() - here.get().y(),
                    mapFromVictim.x() - here.get().x());
            boolean near = here.get().position().distanceTo(mapFromVictim) <= reach;
            // near it and not seen: maybe it is behind the robot
            Pose2d mapFromGoal = near ? at(here.get().position(), bearing) : at(mapFromVictim, bearing);
            driver.goTo(
                    mapFromGoal,
                    near ? new Tolerance(reach, FACING) : Tolerance.position(INSIDE * reach),
                    result -> arrived(mapFromVictim, result));
        }

        private void arrived(Point2d there, Result result) {
            if (work.isOver() || !there.equals(goal)) {
                return;
            }
            goal = null;
            switch (result) {
                case Result.Reached _, Result.Cancelled _ -> {} // the next look tells what is left to do
                case Result.NoPath _, Result.Stuck _ ->
                    work.fail(AgentWords.ending(result) + ". " + AgentWords.reason(result));
            }
        }
    }
}
