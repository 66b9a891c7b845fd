package rsal.engine;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Sketch;
import rsal.device.Canvas;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.engine.robot.RobotPoses;
import rsal.engine.robot.RobotTeam;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.scene.Surface;
import rsal.time.Phase;
import rsal.time.Scheduler;

/// Draws the ways of robots' navigators on those robots' canvases, in their colors, so that who looks there sees what
/// they are up to. As a canvas moves along with its robot, a way is drawn again while that drives, five times a second.
/// All calls on the run's thread.
final class DrawnPlans {
    private static final Duration BEAT = Duration.ofMillis(200);
    private static final int MOST_POINTS = 500;

    private final RobotTeam team;
    private final Scheduler scheduler;
    private final Set<RobotSpec> robots = new LinkedHashSet<>();
    private boolean beating;

    DrawnPlans(RobotTeam team, Scheduler scheduler) {
        this.team = team;
        this.scheduler = scheduler;
    }

    /// A robot of the team is there.
    void join(RobotSpec spec) {
        if (team.robot(spec.id()).flatMap(robot -> robot.find(Canvas.class)).isPresent()) {
            robots.add(spec);
        }
        if (!beating && !robots.isEmpty()) {
            beating = true;
            scheduler.every(BEAT, Phase.OBSERVE, () -> robots.forEach(this::draw));
        }
    }

    /// A robot has left for good.
    void leave(String robot) {
        robots.removeIf(spec -> spec.id().equals(robot));
    }

    private void draw(RobotSpec spec) {
        Optional<Robot> there = team.robot(spec.id());
        there.flatMap(robot -> robot.find(Canvas.class)).ifPresent(canvas -> {
            Optional<Pose2d> mapFromBase = there.flatMap(team::localizer)
                    .flatMap(Localizer::latest)
                    .filter(estimate -> estimate.frame().equals(RobotPoses.WORLD))
                    .map(estimate -> estimate.value().mapFromBase());
            Path2d way = there.flatMap(robot -> robot.find(Navigator.class))
                    .map(Navigator::path)
                    .orElse(Path2d.EMPTY);
            canvas.show(mapFromBase
                    .filter(_ -> way.points().size() > 1)
                    .map(at -> sketch(way, at.inverse(), Rgb.parse(spec.color()).orElse(Surface.PLAIN.color())))
                    .orElse(Sketch.EMPTY));
        });
    }

    /// Of a way that has more points than anybody sees some are left out.
    private static Sketch sketch(Path2d way, Pose2d baseFromMap, Rgb color) {
        List<Point2d> all = way.points();
        int step = (all.size() - 1) / MOST_POINTS + 1;
        var points = new ArrayList<Point2d>();
        for (int i = 0; i < all.size() - 1; i += step) {
            points.add(baseFromMap.transform(all.get(i)));
        }
        points.add(baseFromMap.transform(all.getLast()));
        return new Sketch(List.of(new Sketch.Line(points, color)));
    }
}
