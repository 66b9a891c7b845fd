package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.recovery.Recovery;
import rsal.navigation.recovery.Recovery.Situation;
import rsal.navigation.recovery.Recovery.State;

class RecoveryListTest {
    private static final Situation SOMEWHERE = new Situation(
            Instant.EPOCH,
            Pose2d.ORIGIN,
            new Motion(Pose2d.ORIGIN, Twist2d.STOP),
            false,
            new Obstacles(5),
            true,
            true,
            false,
            0,
            1,
            Duration.ofSeconds(7),
            Pose2d.ORIGIN,
            0);

    private final Script first = new Script(0.1, false);
    private final Script second = new Script(0.2, false);
    private final Script third = new Script(0.3, false);
    private final RecoveryList list = list(first, second, third);

    private static final class Script implements Recovery {
        private final double speed;
        private final boolean ownPath;
        private boolean due = true;
        private State state = State.RUNNING;
        private int begun;

        Script(double speed, boolean ownPath) {
            this.speed = speed;
            this.ownPath = ownPath;
        }

        @Override
        public boolean isDue(Situation situation) {
            return due;
        }

        @Override
        public void begin(Situation situation) {
            begun++;
        }

        @Override
        public State state(Situation situation) {
            return state;
        }

        @Override
        public Twist2d command(Situation situation) {
            return Twist2d.drive(speed, 0);
        }

        @Override
        public boolean followsOwnPath() {
            return ownPath;
        }
    }

    private static RecoveryList list(Script... scripts) {
        return new RecoveryList(List.of(scripts).stream()
                .map(script -> new RecoveryList.Named("s" + script.speed, script))
                .toList());
    }

    private double speed() {
        return list.command(SOMEWHERE).vx();
    }

    @Test
    void theFirstThatIsDueDrives() {
        first.due = false;
        assertThat(list.isAnyDue(SOMEWHERE)).isTrue();
        list.begin(SOMEWHERE);
        assertThat(speed()).isEqualTo(0.2);
        assertThat(list.endsNow(SOMEWHERE)).isFalse();
        second.state = State.DONE;
        assertThat(list.endsNow(SOMEWHERE)).isTrue();
        assertThat(list.isRunning()).isFalse();
        assertThat(speed()).isZero();
        assertThat(list.endsNow(SOMEWHERE)).as("again").isFalse();
    }

    @Test
    void afterOneThatFailsTheNextBeginsAtOnce() {
        list.begin(SOMEWHERE);
        first.state = State.FAILED;
        second.due = false;
        assertThat(list.endsNow(SOMEWHERE)).isFalse();
        assertThat(speed()).isEqualTo(0.3);
        third.state = State.FAILED;
        assertThat(list.endsNow(SOMEWHERE)).as("none is left").isTrue();
        assertThat(list.counts()).isEqualTo(Map.of("s0.1", 1, "s0.3", 1));
    }

    /// A robot that turns around and is sent a bit farther meanwhile goes on to turn to where it wanted to.
    @Test
    void anotherGoalTakesOverWhatRuns() {
        list.begin(SOMEWHERE);
        RecoveryList next = list(new Script(0.5, false));
        next.succeed(list);
        assertThat(next.command(SOMEWHERE).vx()).isEqualTo(0.1);
        assertThat(first.begun).isEqualTo(1);
        first.state = State.DONE;
        assertThat(next.endsNow(SOMEWHERE)).isTrue();
    }

    @Test
    void anotherGoalDoesNotTakeOverAPathToTheFormerOne() {
        RecoveryList old = list(new Script(0.1, true));
        old.begin(SOMEWHERE);
        assertThat(old.followsOwnPath()).isTrue();
        list.succeed(old);
        assertThat(list.isRunning()).isFalse();
    }

    @Test
    void noneIsDueInAnEmptyList() {
        assertThat(list().isAnyDue(SOMEWHERE)).isFalse();
    }
}
