package rsal.sim.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.robot.Shift;
import rsal.scene.Surface;
import rsal.testkit.Rounds;

class BumperGeometryTest {
    private static final Footprint BOX = RandomWorld.box(0.4, 0.3, 0, 0);
    private static final double LENGTH = 0.3;

    /// Tries a thousand points of what it feels.
    @Test
    void isPressedWhereSomethingIsUpToACentimeterOutsideOfIt() {
        int pressed = 0;
        int sure = 0;
        int worlds = Rounds.of(800, 4000);
        for (long seed = 0; seed < worlds; seed++) {
            var random = new RandomWorld(seed, 0.1, 0.02);
            var walls = RasterWalls.of(random.map);
            var world = new World(walls);
            Body robot = world.add("r1", CollisionShape.of(BOX), random.anywhere(), 0);
            Body other = world.add("r2", CollisionShape.of(BOX), random.anywhere(), 0);
            var baseFromLine = new Pose2d(0.2, 0, 0);
            boolean feels = new BumperGeometry(baseFromLine, LENGTH, 0.1).isPressed(world, robot, Shift.NONE);
            pressed += feels ? 1 : 0;
            boolean inside = false;
            for (int i = 0; i < 10 && !inside; i++) {
                for (int j = 0; j < 100 && !inside; j++) {
                    var line = new Point2d((i + 0.5) * 0.001, LENGTH * ((j + 0.5) / 100 - 0.5));
                    Point2d at = robot.pose().transform(baseFromLine.transform(line));
                    inside = !walls.isFree(at.x(), at.y())
                            || RandomWorld.shape(BOX, other.pose()).contains(at.x(), at.y());
                }
            }
            if (inside) {
                sure++;
                assertThat(feels).as("seed %d", seed).isTrue();
            }
        }
        assertThat(sure).isGreaterThan(worlds / 20);
        assertThat(pressed - sure).as("corners that fall between the points").isLessThan(pressed / 10);
    }

    @Test
    void feelsNothingAboveBelowOrThatIsInNobodysWay() {
        var world = new World(List.of(), new Extent(0, 0, 4, 4));
        Body robot = world.add("r1", CollisionShape.of(BOX), new Pose2d(2, 2, 0), 0);
        var feeler = new BumperGeometry(new Pose2d(0.2, 0, 0), LENGTH, 0.1);
        var beside = new Pose2d(2.405, 2, 0);
        Body high = world.add("high", List.of(bar(0.2, Surface.PLAIN)), beside, 0);
        assertThat(feeler.isPressed(world, robot, Shift.NONE)).isFalse();
        world.remove(high);
        Body paper = world.add("paper", List.of(bar(0, unsolid())), beside, 0);
        assertThat(feeler.isPressed(world, robot, Shift.NONE)).isFalse();
        world.remove(paper);
        world.add("box", List.of(bar(0, Surface.PLAIN)), beside, 0);
        assertThat(feeler.isPressed(world, robot, Shift.NONE)).isTrue();
    }

    /// At 0.1 m, half a centimeter up and down.
    @ParameterizedTest
    @CsvSource({"0.104, true", "0.106, false", "-0.106, false", "-0.104, true"})
    void isAsHighAsItIsDeep(double bottom, boolean pressed) {
        var world = new World(List.of(), new Extent(0, 0, 4, 4));
        Body robot = world.add("r1", CollisionShape.of(BOX), new Pose2d(2, 2, 0), 0);
        world.add("bar", List.of(bar(bottom, Surface.PLAIN)), new Pose2d(2.405, 2, 0), 0); // 0.2 m high
        assertThat(new BumperGeometry(new Pose2d(0.2, 0, 0), LENGTH, 0.1).isPressed(world, robot, Shift.NONE))
                .isEqualTo(pressed);
    }

    private static Surface unsolid() {
        return new Surface(Surface.PLAIN.color(), false, 1, true, 0, 0, false);
    }

    private static CollisionShape bar(double bottom, Surface surface) {
        return new CollisionShape.Prism(new ConvexOutline(BOX.corners()), bottom, bottom + 0.2, surface);
    }
}
