package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.data.Covariance2d;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Rgb;
import rsal.data.Sketch;
import rsal.data.Stamped;
import rsal.device.Canvas;
import rsal.device.Device;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.GoalHandle;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.SensorCore;
import rsal.engine.report.Teammate;
import rsal.engine.robot.RobotTeam;
import rsal.model.RobotModels;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotSpec;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.time.LockstepScheduler;

class DrawnPlansTest {
    private static final RobotModel MODEL =
            new RobotModels(FileSource.resources(DrawnPlansTest.class, "/")).read("pioneer2dx", Location.of("test"));
    private static final RobotSpec SPEC = new RobotSpec("r1", "rover", MODEL, Optional.empty(), "#ff8000");

    private final LockstepScheduler time = new LockstepScheduler();
    private final RobotTeam team = new RobotTeam();
    private final DrawnPlans drawn = new DrawnPlans(team, time);
    private final Paper paper = new Paper();
    private final Guide guide = new Guide();
    private final Oracle oracle = new Oracle();

    /// Keeps all that was drawn.
    private static final class Paper extends DeviceCore implements Canvas {
        private final List<Sketch> shown = new ArrayList<>();

        Paper() {
            super(new DeviceInfo("r1", "canvas", "paper"));
        }

        @Override
        public void show(Sketch sketch) {
            shown.add(sketch);
        }

        List<Point2d> points() {
            Sketch newest = shown.getLast();
            return newest.strokes().isEmpty()
                    ? List.of()
                    : newest.strokes().getFirst().points();
        }
    }

    /// Has the way that a test says.
    private static final class Guide extends DeviceCore implements Navigator {
        private Path2d way = Path2d.EMPTY;

        Guide() {
            super(new DeviceInfo("r1", "navigator", "guide"));
        }

        @Override
        public GoalHandle<Progress, Result> goTo(Pose2d mapFromGoal, Tolerance tolerance) {
            throw new AssertionError("Nobody drives.");
        }

        @Override
        public void pause() {}

        @Override
        public void resume() {}

        @Override
        public boolean paused() {
            return false;
        }

        @Override
        public Optional<Pose2d> goal() {
            return Optional.empty();
        }

        @Override
        public Path2d path() {
            return way;
        }
    }

    /// Says where its robot is.
    private final class Oracle extends SensorCore<PoseEstimate> implements Localizer {
        Oracle() {
            super(new DeviceInfo("r1", "localizer", "oracle"));
        }

        void publish(Pose2d mapFromBase, String frame) {
            var estimate = PoseEstimate.of(mapFromBase, Covariance2d.ofDeviations(0.1, 0.1, 0.1));
            deliver(new Stamped<>(time.instant(), frame, estimate));
        }

        @Override
        public CompletionStage<Void> relocalize(PoseEstimate belief) {
            return CompletableFuture.completedStage(null);
        }
    }

    @BeforeEach
    void join() {
        join(List.of(paper, guide, oracle));
    }

    private void join(List<Device> devices) {
        team.join(
                new Robot("r1", "rover", MODEL, OptionalInt.empty(), devices),
                Optional.empty(),
                new Teammate(SPEC, Optional.empty()));
        drawn.join(SPEC);
    }

    private void beat() {
        time.advance(Duration.ofMillis(200));
    }

    @Test
    void theWayIsDrawnAsTheRobotSeesItAndMovesAlong() {
        guide.way = new Path2d(List.of(new Point2d(1, 1), new Point2d(1, 3)));
        oracle.publish(Pose2d.ofDegrees(1, 1, 90), "map");
        beat();
        assertThat(paper.shown.getLast().strokes())
                .singleElement()
                .satisfies(stroke -> assertThat(stroke.color()).isEqualTo(new Rgb(255, 128, 0)));
        assertPoints(new Point2d(0, 0), new Point2d(2, 0));
        oracle.publish(Pose2d.ofDegrees(1, 2, 90), "map");
        beat();
        assertPoints(new Point2d(-1, 0), new Point2d(1, 0));
        guide.way = Path2d.EMPTY;
        beat();
        assertThat(paper.points()).isEmpty();
    }

    private void assertPoints(Point2d... points) {
        assertThat(paper.points()).hasSize(points.length);
        for (int i = 0; i < points.length; i++) {
            assertThat(paper.points().get(i).distanceTo(points[i])).isCloseTo(0, within(1e-9));
        }
    }

    @Test
    void nothingIsDrawnOfARobotThatDoesNotKnowWhereItIs() {
        guide.way = new Path2d(List.of(new Point2d(1, 1), new Point2d(1, 3)));
        beat();
        assertThat(paper.points()).isEmpty();
        oracle.publish(Pose2d.ORIGIN, "r1/map");
        beat();
        assertThat(paper.points()).isEmpty();
    }

    @Test
    void aLongWayIsDrawnWithFewerPointsButToItsEnd() {
        var points = new ArrayList<Point2d>();
        for (int i = 0; i < 10_000; i++) {
            points.add(new Point2d(i * 0.1, 0));
        }
        guide.way = new Path2d(points);
        oracle.publish(Pose2d.ORIGIN, "map");
        beat();
        assertThat(paper.points())
                .hasSizeBetween(250, 501)
                .startsWith(points.getFirst())
                .endsWith(points.getLast());
    }

    @Test
    void whoHasLeftDrawsNothing() {
        beat();
        int before = paper.shown.size();
        assertThat(before).isPositive();
        team.leave("r1");
        beat();
        assertThat(paper.shown).hasSize(before);
    }
}
