package rsal.navigation.recovery;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import rsal.data.Twist2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Drives straight back a bit, then turns to the path. It ends early where something is behind.
public final class BackUpRecoveryType implements RecoveryType {
    static final Parameter<Double> AFTER =
            Parameter.number("after", 6, 0.5, 600, "s", "time without progress after which it begins");

    @Override
    public String key() {
        return "backUp";
    }

    @Override
    public String description() {
        return "Drives straight back, then turns to the path.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(AFTER);
    }

    @Override
    public Recovery create(Arguments arguments, Driven driven) {
        return new BackUp(driven, arguments.seconds(AFTER));
    }

    private static final class BackUp implements Recovery {
        private final Driven driven;
        private final Duration after;
        private final TurnToPath turn;
        private Instant until = Instant.MIN;
        private boolean isTurning;

        BackUp(Driven driven, Duration after) {
            this.driven = driven;
            this.after = after;
            this.turn = new TurnToPath(driven);
        }

        @Override
        public boolean isDue(Situation situation) {
            return situation.isStuck(after);
        }

        @Override
        public void begin(Situation situation) {
            isTurning = false;
            until = situation.now().plus(driven.partOf(driven.time()));
        }

        @Override
        public State state(Situation situation) {
            return isTurning ? turn.state(situation) : State.RUNNING;
        }

        @Override
        public Twist2d command(Situation situation) {
            if (!isTurning && (situation.stalled() || situation.now().isAfter(until))) {
                beginTurn(situation);
            }
            if (isTurning) {
                return turn.command(situation);
            }
            Twist2d safe = driven.controller()
                    .guarded(situation.obstacles(), Twist2d.drive(-driven.speed(), 0), situation.motion());
            if (safe.equals(Twist2d.STOP)) {
                beginTurn(situation);
            }
            return safe;
        }

        private void beginTurn(Situation situation) {
            isTurning = true;
            turn.begin(situation);
        }
    }
}
