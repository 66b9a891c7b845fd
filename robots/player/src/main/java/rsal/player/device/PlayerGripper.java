package rsal.player.device;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.GripperState;
import rsal.data.GripperState.Lift;
import rsal.data.GripperState.Paddles;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.device.Gripper;
import rsal.player.message.GripperInterface.State;
import rsal.player.wire.Address;

/// A gripper behind `gripper`; its lift and its beams are [behind devices][PlayerLift] [of their
/// own][PlayerBeams], where a server has them. Without the latter its beams are what Stage's gripper has as
/// bits 2 and 3.
///
/// Paddles that move do not say which way, and those that stand half open say that they move: both follows from
/// what they were told last. While its robot's motors are off it stands still, and goes on when they are on
/// again.
final class PlayerGripper extends PlayerSensor<GripperState> implements Gripper {
    private static final Duration PATIENCE = Duration.ofSeconds(15);
    private static final int OPEN = 1;
    private static final int CLOSED = 2;
    private static final int INNER = 4;
    private static final int OUTER = 8;

    private final RemoteServer server;
    private final PlayerBase base;
    private final InstantSource clock;
    private final Optional<PlayerLift> lift;
    private final Optional<PlayerBeams> beams;
    private final Motion paddles = new Motion();
    private final Motion lifting = new Motion();
    private @Nullable State reported;
    private Instant changed = Instant.EPOCH; // anything of it
    private boolean hasNewState;

    PlayerGripper(
            DeviceInfo info,
            Address address,
            RemoteServer server,
            PlayerBase base,
            Optional<PlayerLift> lift,
            Optional<PlayerBeams> beams,
            InstantSource clock) {
        super(info, address, info.id());
        this.server = server;
        this.base = base;
        this.clock = clock;
        this.lift = lift;
        this.beams = beams;
        base.onMotors(this::motors);
        lift.ifPresent(its -> its.onChange(this::changed));
        beams.ifPresent(its -> its.onChange(this::changed));
    }

    private void motors(boolean enabled) {
        if (enabled) {
            paddles.goOn(clock.instant());
            lifting.goOn(clock.instant());
        } else {
            stopPaddles();
            lift.ifPresent(PlayerLift::stop);
        }
    }

    private void stopPaddles() {
        server.command(address(), rsal.player.message.GripperInterface.STOP);
    }

    @Override
    Optional<GripperState> read(Record body) {
        throw new AssertionError("It is combined from readings of several devices.");
    }

    @Override
    public void take(Instant time, Record body) {
        if (body instanceof State state) {
            reported = state;
            heard(time);
            changed(time);
        }
    }

    private void changed(Instant time) {
        changed = time.isAfter(changed) ? time : changed;
        hasNewState = true;
    }

    @Override
    public void delivered() {
        if (hasNewState && reported != null) {
            hasNewState = false;
            GripperState state = state();
            publish(changed, state);
            latest().ifPresent(reading -> {
                paddles.publish(reading);
                lifting.publish(reading);
            });
            if (state.paddles() == (paddles.target == 1 ? Paddles.CLOSED : Paddles.OPEN)) {
                paddles.end(new Result.Reached(state));
            }
            if (state.lift() == (lifting.target == 1 ? Lift.UP : Lift.DOWN)) {
                lifting.end(new Result.Reached(state));
            }
        }
    }

    private GripperState state() {
        int beam = reported == null ? 0 : reported.beams();
        return new GripperState(
                paddles(),
                isAt(OPEN) ? 0 : isAt(CLOSED) ? 1 : Double.NaN,
                lift.map(its -> its.state(!isUnderway(lifting) ? 0 : lifting.target == 1 ? 1 : -1))
                        .orElse(Lift.DOWN),
                lift.map(PlayerLift::raised).orElse(0.0),
                beams.map(PlayerBeams::inner).orElse((beam & INNER) != 0),
                beams.map(PlayerBeams::outer).orElse((beam & OUTER) != 0),
                beams.map(PlayerBeams::left).orElse(false),
                beams.map(PlayerBeams::right).orElse(false),
                holds());
    }

    private boolean isUnderway(Motion motion) {
        return motion.goal != null && base.enabled();
    }

    private boolean isAt(int code) {
        return reported != null && reported.state() == code;
    }

    private Paddles paddles() {
        boolean moved = isUnderway(paddles);
        if (isAt(OPEN)) {
            return moved && paddles.target == 1 ? Paddles.CLOSING : Paddles.OPEN;
        }
        if (isAt(CLOSED)) {
            return moved && paddles.target == 0 ? Paddles.OPENING : Paddles.CLOSED;
        }
        return moved ? paddles.target == 1 ? Paddles.CLOSING : Paddles.OPENING : Paddles.STOPPED;
    }

    /// Stage does not say what is stored: then it is what breaks a beam between closed paddles.
    private boolean holds() {
        return reported != null
                && (reported.stored() != 0 || (isAt(CLOSED) && (reported.beams() & (INNER | OUTER)) != 0));
    }

    @Override
    public GoalHandle<GripperState, Result> open() {
        return move(0, rsal.player.message.GripperInterface.OPEN);
    }

    @Override
    public GoalHandle<GripperState, Result> close() {
        return move(1, rsal.player.message.GripperInterface.CLOSE);
    }

    private GoalHandle<GripperState, Result> move(int target, int command) {
        GoalHandle<GripperState, Result> goal =
                paddles.begin(target, clock.instant(), () -> server.command(address(), command), this::stopPaddles);
        begin(paddles);
        return goal;
    }

    /// As soon as it may.
    private void begin(Motion motion) {
        if (!server.isConnected()) {
            motion.end(new Result.Stuck(state(), server.reason()));
        } else if (base.enabled()) {
            motion.goOn(clock.instant());
        }
    }

    @Override
    public GoalHandle<GripperState, Result> lift() {
        return raise(1);
    }

    @Override
    public GoalHandle<GripperState, Result> lower() {
        return raise(0);
    }

    private GoalHandle<GripperState, Result> raise(int target) {
        GoalHandle<GripperState, Result> goal = lifting.begin(
                target,
                clock.instant(),
                () -> lift.ifPresent(its -> its.goTo(target)),
                () -> lift.ifPresent(PlayerLift::stop));
        if (lift.isEmpty()) {
            lifting.end(target == 0 ? new Result.Reached(state()) : new Result.Stuck(state(), "It has no lift."));
        } else {
            begin(lifting);
        }
        return goal;
    }

    @Override
    public void lost(String reason) {
        paddles.end(new Result.Stuck(state(), reason));
        lifting.end(new Result.Stuck(state(), reason));
        super.lost(reason);
    }

    @Override
    public void look(Instant now) {
        super.look(now);
        for (Motion motion : new Motion[] {paddles, lifting}) {
            if (isUnderway(motion) && motion.begun.isBefore(now.minus(PATIENCE))) {
                motion.end(new Result.Stuck(state(), "It does not get there."));
            }
        }
    }

    /// What paddles or lift are to do: be at 0 (open, down) or 1.
    private static final class Motion {
        private int target;
        private Instant begun = Instant.MIN;
        private Runnable move = () -> {};
        private @Nullable GoalSource<GripperState, Result> goal;

        /// The one before is cancelled.
        GoalHandle<GripperState, Result> begin(int place, Instant now, Runnable itsMove, Runnable stop) {
            end(new Result.Cancelled());
            target = place;
            begun = now;
            move = itsMove;
            GoalSource<GripperState, Result> next = new GoalSource<>(() -> {
                stop.run();
                end(new Result.Cancelled());
            });
            goal = next;
            return next;
        }

        /// Moves, or does so again.
        void goOn(Instant now) {
            if (goal != null) {
                begun = now;
                move.run();
            }
        }

        void publish(Stamped<GripperState> reading) {
            if (goal != null) {
                goal.publish(reading);
            }
        }

        void end(Result ending) {
            GoalSource<GripperState, Result> ended = goal;
            goal = null;
            if (ended != null) {
                ended.end(ending);
            }
        }
    }
}
