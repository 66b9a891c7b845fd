package rsal.navigation.recovery;

import java.time.Duration;
import java.time.Instant;
import rsal.data.Twist2d;
import rsal.navigation.recovery.Recovery.Situation;
import rsal.navigation.recovery.Recovery.State;
import rsal.navigation.recovery.RecoveryType.Driven;

/// How a recovery ends that has backed up: it turns to where the path goes on, for some seconds at most.
final class TurnToPath {
    private static final Duration LONGEST = Duration.ofSeconds(3);
    private static final double TURNED = 0.2; // rad; less is done

    private final Driven driven;
    private Instant until = Instant.MIN;
    private boolean isTurned;

    TurnToPath(Driven driven) {
        this.driven = driven;
    }

    void begin(Situation situation) {
        isTurned = false;
        until = situation.now().plus(driven.partOf(LONGEST));
    }

    State state(Situation situation) {
        return isTurned || situation.now().isAfter(until) ? State.DONE : State.RUNNING;
    }

    Twist2d command(Situation situation) {
        isTurned = Math.abs(situation.turn()) < TURNED && !situation.atGoal();
        return driven.controller().turn(situation.obstacles(), situation.turn(), situation.motion());
    }
}
