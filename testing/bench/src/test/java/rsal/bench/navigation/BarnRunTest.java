package rsal.bench.navigation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.bench.navigation.BarnRun.Outcome;
import rsal.bench.navigation.BarnWorld.Cylinder;
import rsal.data.Point2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.mpc.Mpc;
import rsal.testkit.LongTest;

class BarnRunTest {
    /// A wall across the way with an opening on the right.
    private static final BarnWorld WALL = wall();

    private static BarnWorld wall() {
        var cylinders = new ArrayList<Cylinder>();
        for (double x = -4.5; x < -1.6; x += 0.15) {
            cylinders.add(new Cylinder(new Point2d(x, 7), 0.075));
        }
        return new BarnWorld(1, cylinders, List.of(new Point2d(-1, 7)));
    }

    @Test
    @LongTest
    void whoLooksAheadGetsThroughTheSameWayEachTime() {
        Outcome outcome = new BarnRun(WALL, mpc(), 1).run();
        assertThat(outcome.reached()).isTrue();
        assertThat(outcome.touched()).isFalse();
        assertThat(outcome.seconds()).isBetween(4.5, 10.0);
        assertThat(new BarnRun(WALL, mpc(), 1).run()).isEqualTo(outcome);
        assertThat(new BarnRun(WALL, mpc(), 2).run()).isNotEqualTo(outcome);
    }

    @Test
    void whoDrivesBlindlyTouches() {
        Outcome outcome = new BarnRun(WALL, new Blind(), 1).run();
        assertThat(outcome.touched()).isTrue();
        assertThat(outcome.reached()).isFalse();
    }

    @Test
    void scoresAsTheChallengeDoes() {
        var open = new BarnWorld(1, List.of(), List.of());
        assertThat(open.length()).isCloseTo(10, within(1e-9));
        assertThat(open.score(5)).isEqualTo(0.5);
        assertThat(open.score(20)).isEqualTo(0.25);
        assertThat(open.score(90)).isEqualTo(0.125);
    }

    @Test
    void readsWorlds(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("worlds.json");
        Files.writeString(file, "[{\"world\": 3, \"cylinders\": [[-0.1, 2, 0.075]], \"path\": [[1, 5.5], [1, 6]]}]");
        assertThat(BarnWorld.read(file))
                .containsExactly(new BarnWorld(
                        3,
                        List.of(new Cylinder(new Point2d(-0.1, 2), 0.075)),
                        List.of(new Point2d(1, 5.5), new Point2d(1, 6))));
    }

    private static Controller mpc() {
        return new Mpc(BarnRun.FOOTPRINT, BarnRun.LIMITS, Mpc.Settings.DEFAULT, BarnRun.REACTION, BarnRun.BEAT);
    }

    private static final class Blind implements Controller {
        @Override
        public Twist2d drive(Obstacles obstacles, Target target, Motion motion) {
            return Twist2d.drive(1, 0);
        }

        @Override
        public Twist2d turn(Obstacles obstacles, double angle, Motion motion) {
            return Twist2d.STOP;
        }

        @Override
        public Twist2d guarded(Obstacles obstacles, Twist2d wanted, Motion motion) {
            return wanted;
        }

        @Override
        public void reset() {}
    }
}
