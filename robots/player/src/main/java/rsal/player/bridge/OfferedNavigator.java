package rsal.player.bridge;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.GoalHandle;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.Navigator.Progress;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.device.Subscription;
import rsal.player.message.Interface;
import rsal.player.message.PlannerInterface;
import rsal.player.message.Pose;
import rsal.player.wire.MalformedException;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.time.Scheduler;

/// A navigator as `planner`. It works on a client's goal until it is there, or no client is left.
final class OfferedNavigator extends Offered implements ExclusiveControl.Holder {
    private static final Duration PERIOD = Duration.ofMillis(250); // as Player's wavefront tells of itself
    private static final Pose NOWHERE = new Pose(0, 0, 0);

    private final Navigator navigator;
    private final Optional<Localizer> localizer;
    private final Tolerance tolerance;
    private final ExclusiveControl control;
    private @Nullable GoalHandle<Progress, Result> drive; // that a client wants
    private @Nullable Pose2d mapFromGoal; // that a client wanted last
    private boolean reached;
    private boolean paused; // by a client

    OfferedNavigator(
            int index,
            Navigator navigator,
            Optional<Localizer> localizer,
            Tolerance tolerance,
            ExclusiveControl control,
            Scheduler scheduler) {
        super(Interface.PLANNER, index, navigator.info(), scheduler);
        this.navigator = navigator;
        this.localizer = localizer;
        this.tolerance = tolerance;
        this.control = control;
    }

    @Override
    Subscription listen() {
        return scheduler().every(PERIOD, this::publish)::cancel;
    }

    private void publish() {
        List<Pose> waypoints = waypoints();
        boolean done = reached && navigator.goal().isEmpty();
        Pose goal = navigator
                .goal()
                .or(() -> Optional.ofNullable(mapFromGoal))
                .map(Pose::of)
                .orElse(NOWHERE);
        publish(
                PlannerInterface.STATE,
                scheduler().instant(),
                new PlannerInterface.State(
                        done || !waypoints.isEmpty() ? 1 : 0,
                        done ? 1 : 0,
                        localizer
                                .flatMap(Localizer::latest)
                                .map(Stamped::value)
                                .map(estimate -> Pose.of(estimate.mapFromBase()))
                                .orElse(NOWHERE),
                        goal,
                        waypoints.isEmpty() ? NOWHERE : waypoints.getFirst(),
                        waypoints.isEmpty() ? -1 : 0,
                        waypoints.size()));
    }

    /// Those ahead: where the robot is comes first in a path, but is none.
    private List<Pose> waypoints() {
        return navigator.path().points().stream()
                .skip(1)
                .map(point -> new Pose(point.x(), point.y(), 0))
                .toList();
    }

    @Override
    public boolean understands(MessageKind kind, int subtype) {
        return switch (kind) {
            case COMMAND -> subtype == PlannerInterface.GOAL;
            case REQUEST -> subtype == PlannerInterface.WAYPOINTS || subtype == PlannerInterface.ENABLE;
            default -> false;
        };
    }

    @Override
    Optional<Answer> answer(Packet request) throws MalformedException {
        return switch (request.header().subtype()) {
            case PlannerInterface.WAYPOINTS ->
                Optional.of(new Answer.Reported(
                        new PlannerInterface.Waypoints(navigator.path().length(), waypoints())));
            case PlannerInterface.ENABLE -> {
                if (request.body(PlannerInterface.Enable.class).on() == 0) {
                    paused |= !navigator.paused();
                    navigator.pause();
                } else {
                    resume();
                }
                yield Optional.of(new Answer.Done());
            }
            default -> Optional.empty();
        };
    }

    /// Nobody else's pause ends by it.
    private void resume() {
        if (paused) {
            paused = false;
            navigator.resume();
        }
    }

    @Override
    void obey(Packet command) throws MalformedException {
        if (command.header().subtype() == PlannerInterface.GOAL) {
            Pose2d wanted =
                    command.body(PlannerInterface.Place.class).mapFromPlace().to2d();
            if (drive == null || !wanted.equals(mapFromGoal)) {
                goTo(wanted);
            }
        }
    }

    private void goTo(Pose2d wanted) {
        GoalHandle<Progress, Result> going = navigator.goTo(wanted, tolerance); // refuses what is not finite
        control.take(this);
        mapFromGoal = wanted;
        reached = false;
        drive = going;
        going.result().thenAccept(result -> {
            if (going.equals(drive)) {
                drive = null;
                reached = result instanceof Result.Reached;
            }
        });
    }

    @Override
    public void letGo() {
        GoalHandle<Progress, Result> last = drive;
        drive = null;
        if (last != null) {
            last.cancel();
        }
    }

    @Override
    void idle() {
        letGo();
        resume();
    }
}
