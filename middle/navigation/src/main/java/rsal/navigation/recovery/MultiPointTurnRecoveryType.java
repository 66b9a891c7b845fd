package rsal.navigation.recovery;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.Angles;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.MultiPointTurn;
import rsal.navigation.avoid.MultiPointTurn.Leg;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.avoid.Shunt;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Turns in several short legs, forward and back ([MultiPointTurn]), where the robot stands between walls that
/// leave no room to turn in place and nobody is near. It fails where it finds no such legs, or they come to nothing.
public final class MultiPointTurnRecoveryType implements RecoveryType {
    private static final Parameter<Double> AGAIN =
            Parameter.number("again", 1.5, 0.5, 600, "s", "the same, directly after progress by this recovery");

    @Override
    public String key() {
        return "multiPointTurn";
    }

    @Override
    public String description() {
        return "Turns in several legs, forward and backward, if walls leave no room to turn in place.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(BackUpRecoveryType.AFTER, AGAIN);
    }

    @Override
    public Recovery create(Arguments arguments, Driven driven) {
        return new Turn(driven, arguments.seconds(BackUpRecoveryType.AFTER), arguments.seconds(AGAIN));
    }

    private static final class Turn implements Recovery {
        private static final double COMPANY = 1.5; // m; nearer ones may move out of the way
        private static final double STANDING = 0.15; // m; less is no progress at all
        private static final double NEAR = 1; // m; from where it last began
        private static final double ONWARD = 0.3; // m that it must be able to go on when it has turned
        private static final Duration SEARCHING = Duration.ofSeconds(5);
        private static final double MOVED = 0.05; // m; with less, and less of a turn, it came to nothing
        private static final double TURNED = Math.toRadians(10);
        private static final double SLOWLY = 2; // times the time that it should take
        private static final int MOST_REFUSED = 6; // commands in a row

        private final Driven driven;
        private final Duration after;
        private final Duration again;
        private @Nullable MultiPointTurn turns; // made when first needed: most goals are reached without
        private @Nullable Shunt shunt; // what it found
        private @Nullable Throwable error; // of the search
        private boolean inVain; // the search
        private int searches;
        private Instant until = Instant.MIN;
        private Pose2d mapFromBegin = Pose2d.ORIGIN;
        private boolean atGoal; // as it began
        private Pose2d mapFromLast = Pose2d.ORIGIN; // where it was at its last command
        private int refused; // commands in a row that were not safe

        Turn(Driven driven, Duration after, Duration again) {
            this.driven = driven;
            this.after = after;
            this.again = again;
        }

        @Override
        public boolean followsOwnPath() {
            return true;
        }

        @Override
        public boolean isDue(Situation situation) {
            boolean cameOn = shunt != null && mapFromLast.distanceTo(mapFromBegin) > STANDING;
            boolean isOnIt = cameOn && situation.mapFromBase().distanceTo(mapFromBegin) < NEAR;
            return !situation.stalled()
                    && situation.withoutProgress().compareTo(isOnIt ? again : after) > 0
                    && isBetweenWalls(situation);
        }

        /// Whether it is walls that hold it up, all of which it knows: nobody is near whom it could wait for. Sonars
        /// that look ahead leave unknown what is behind.
        private static boolean isBetweenWalls(Situation situation) {
            if (!situation.knowsBehind()) {
                return false;
            }
            Obstacles around = situation.obstacles();
            for (int i = 0; i < around.count(); i++) {
                if (around.room(i) > 0 && Math.hypot(around.x(i), around.y(i)) < COMPANY) {
                    return false;
                }
            }
            return situation.mapFromBase().distanceTo(situation.mapFromProgress()) < STANDING;
        }

        @Override
        public void begin(Situation situation) {
            shunt = null;
            inVain = false;
            refused = 0;
            atGoal = situation.atGoal();
            mapFromBegin = situation.mapFromBase();
            mapFromLast = mapFromBegin;
            until = situation.now().plus(SEARCHING);
            int search = ++searches;
            double ahead = Math.min(ONWARD, situation.ahead());
            Pose2d odomFromBase = situation.motion().odomFromBase();
            driven.scheduler()
                    .compute(turns().search(situation.obstacles(), situation.turn(), ahead))
                    .whenComplete((legs, failure) -> {
                        if (search == searches) {
                            error = failure;
                            adopt(failure == null ? legs : Optional.empty(), ahead, odomFromBase);
                        }
                    });
        }

        private MultiPointTurn turns() {
            MultiPointTurn known = turns;
            if (known == null) {
                known = new MultiPointTurn(driven.footprint(), driven.limits(), driven.reaction());
                turns = known;
            }
            return known;
        }

        /// Drives on by what the search found open, too: a controller that wants more room would stand there.
        private void adopt(Optional<List<Leg>> legs, double ahead, Pose2d odomFromBase) {
            inVain = legs.isEmpty();
            legs.ifPresent(found -> {
                var all = new ArrayList<Leg>(found);
                if (ahead > 0) {
                    all.add(new Leg(ahead, 0));
                }
                var next = new Shunt(all, driven.speed(), odomFromBase);
                shunt = next;
                until = driven.scheduler().instant().plusMillis((long) (SLOWLY * next.seconds() * 1000));
            });
        }

        @Override
        public State state(Situation situation) {
            if (error != null) {
                throw new IllegalStateException("The search for a multi-point turn failed.", error);
            }
            if (inVain) {
                return State.FAILED;
            }
            boolean isThere = !atGoal && situation.atGoal(); // its legs lead on, past the goal
            boolean isOver = (shunt != null && shunt.done()) || refused == MOST_REFUSED;
            if (!isThere && !isOver && !situation.now().isAfter(until)) {
                return State.RUNNING;
            }
            Pose2d mapFromBase = situation.mapFromBase();
            boolean moved = mapFromBase.distanceTo(mapFromBegin) >= MOVED
                    || Math.abs(Angles.difference(mapFromBase.theta(), mapFromBegin.theta())) >= TURNED;
            return moved || isThere ? State.DONE : State.FAILED;
        }

        @Override
        public Twist2d command(Situation situation) {
            mapFromLast = situation.mapFromBase();
            if (shunt == null) {
                return Twist2d.STOP;
            }
            Twist2d safe = turns().guarded(
                            shunt.drive(situation.motion()), situation.motion().velocity(), situation.obstacles());
            refused = safe.equals(Twist2d.STOP) ? refused + 1 : 0;
            return safe;
        }
    }
}
