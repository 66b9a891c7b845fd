package rsal.recording;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import rsal.agent.bdi.Mind;
import rsal.data.Covariance2d;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.PoseEstimate.Hypothesis;
import rsal.data.RangeArray;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Health;
import rsal.engine.report.DeviceView;
import rsal.engine.report.Reading;
import rsal.engine.report.RobotView;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunObserver;
import rsal.engine.report.SentMessage;
import rsal.engine.report.Snapshot;

/// Sees of a run that each robot has more devices: a second one of kinds of which one is drawn, one of a kind that
/// nobody knows, and one that tells no numbers. Each tells something ten times a second.
record MoreDevices(RunObserver reported) implements RunObserver {
    static final List<String> NAMES =
            List.of("rear", "more-sonars", "elsewhere", "trailer", "chart", "weather", "speech");

    public record Weather(Wind wind, double pressure, String words) {}

    public record Wind(double speed, double angle) {}

    /// What they tell at a time, as in [#NAMES].
    static List<Object> values(double seconds) {
        float[] ranges = {(float) seconds, Float.POSITIVE_INFINITY, 0.5F};
        return List.of(
                new LaserScan(new Pose2d(-0.2, 0, Math.PI), -1, 1, 0.02, 5.6, ranges),
                new RangeArray(List.of(Pose2d.ORIGIN, new Pose2d(1, 2, 3), new Pose2d(4, 5, 6)), 0.3, 0.1, 5, ranges),
                new PoseEstimate(
                        new Pose2d(seconds, 2, 0.5),
                        new Covariance2d(1, 0.5, 0, 2, 0, 0.25),
                        List.of(
                                new Hypothesis(
                                        0.5, new Pose2d(seconds, 2, 0.5), new Covariance2d(1, 0.5, 0, 2, 0, 0.25)),
                                new Hypothesis(
                                        0.25, new Pose2d(-1, seconds, -2), new Covariance2d(2, 0, 0, 1, 0, 0.5))),
                        0.5,
                        PoseEstimate.Quality.AMBIGUOUS),
                new Odometry(new Pose2d(1, 2, 0.5), new Twist2d(seconds, 0, -0.5), seconds > 1),
                new OccupancyGrid(2, 1, 0.05, -1, seconds, new byte[] {0, OccupancyGrid.UNKNOWN}),
                new Weather(new Wind(seconds, 1.5), Double.NaN, "fair"),
                "it is late");
    }

    @Override
    public Duration period() {
        return reported.period();
    }

    @Override
    public void sees(Snapshot now, String hash) {
        reported.sees(
                new Snapshot(
                        now.sequence(),
                        now.time(),
                        now.paused(),
                        now.stopped(),
                        now.speed(),
                        now.rate(),
                        now.outcome(),
                        now.robots().stream()
                                .map(robot -> withMore(robot, now.time()))
                                .toList(),
                        now.agents(),
                        now.team(),
                        now.things(),
                        now.links()),
                hash);
    }

    private static RobotView withMore(RobotView robot, Duration time) {
        var devices = new ArrayList<>(robot.devices());
        var readings = new ArrayList<>(robot.readings());
        List<Object> values = values(time.toMillis() / 1e3);
        for (int i = 0; i < NAMES.size(); i++) {
            String name = NAMES.get(i);
            var reported = new Stamped<>(Instant.EPOCH.plus(time), robot.id() + "/" + name, values.get(i));
            devices.add(new DeviceView(name, "test", "Test", Health.ok()));
            readings.add(new Reading(name, reported, Duration.ZERO));
        }
        return new RobotView(
                robot.id(),
                robot.role(),
                robot.color(),
                robot.model(),
                robot.gone(),
                robot.goneFor(),
                robot.truth(),
                robot.odometry(),
                robot.estimate(),
                robot.particles(),
                robot.scan(),
                robot.ranges(),
                robot.map(),
                robot.path(),
                robot.localPath(),
                robot.goal(),
                robot.inCharge(),
                robot.behavior(),
                robot.driver(),
                robot.gripper(),
                robot.stopped(),
                robot.switchedOff(),
                robot.lit(),
                robot.carried(),
                robot.real(),
                devices,
                readings);
    }

    @Override
    public void looksInto(Duration time, Map<String, Mind.View> minds) {
        reported.looksInto(time, minds);
    }

    @Override
    public void happened(RunEvent event, String hash) {
        reported.happened(event, hash);
    }

    @Override
    public void heard(SentMessage message, Object content) {
        reported.heard(message, content);
    }
}
