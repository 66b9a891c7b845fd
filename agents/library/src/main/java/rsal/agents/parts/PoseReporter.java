package rsal.agents.parts;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rsal.agent.AgentContext;
import rsal.agent.message.PoseReport;
import rsal.agent.message.PoseRequest;
import rsal.data.Pose2d;
import rsal.device.DriveBase;
import rsal.device.Localizer;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Tells the others where a robot believes to be: whenever its localizer knows better, at most once a period, and
/// when somebody asks. What comes too early is not lost: the newest pose goes out when the period is over.
///
/// A robot without a localizer reports its odometry, once a second at most, which is right in the map as far as
/// its odometry started there.
public final class PoseReporter {
    public static final Parameter<Double> PERIOD = Parameter.number(
            "period", 0.5, 0, 60, "s", "Minimum time between two reports of its pose; 0 reports each pose.");

    private static final Duration WITHOUT_LOCALIZER = Duration.ofSeconds(1);

    private final AgentContext self;
    private final Robot robot;
    private final Duration period;
    private final Consumer<? super PoseReport> said;
    private final boolean tells;
    private final Optional<Localizer> localizer;
    private final Supplier<Optional<Pose2d>> belief;
    private Instant due = Instant.MIN;
    private boolean waiting;

    /// @param said told what it has said
    public PoseReporter(AgentContext self, Robot robot, Arguments arguments, Consumer<? super PoseReport> said) {
        this(self, robot, arguments, said, true);
    }

    /// @param said told what it says, or would
    /// @param tells false keeps it from others
    public PoseReporter(
            AgentContext self, Robot robot, Arguments arguments, Consumer<? super PoseReport> said, boolean tells) {
        this.self = self;
        this.robot = robot;
        this.period = arguments.seconds(PERIOD);
        this.said = said;
        this.tells = tells;
        this.localizer = robot.find(Localizer.class);
        this.belief = belief(robot);
    }

    public void begin() {
        self.subscribe(PoseRequest.TOPIC, message -> {
            if (message.content().isFor(robot.id())) {
                report();
            }
        });
        localizer.ifPresentOrElse(
                device -> self.subscribe(device, _ -> reportWhenDue()),
                () -> self.scheduler().every(WITHOUT_LOCALIZER, this::reportWhenDue));
    }

    /// Where the robot believes to be now; empty while it does not know.
    public Optional<Pose2d> mapFromBase() {
        return belief.get();
    }

    /// Where a robot believes to be whenever it is asked; empty while it does not know.
    public static Supplier<Optional<Pose2d>> belief(Robot robot) {
        Supplier<Optional<Pose2d>> newest =
                robot.find(Localizer.class).map(PoseReporter::fromLocalizer).orElseGet(() -> fromOdometry(robot));
        return () -> newest.get().filter(Pose2d::isFinite);
    }

    private static Supplier<Optional<Pose2d>> fromLocalizer(Localizer localizer) {
        return () -> localizer.latest().map(reading -> reading.value().mapFromBase());
    }

    private static Supplier<Optional<Pose2d>> fromOdometry(Robot robot) {
        var base = robot.require(DriveBase.class);
        return () -> base.latest().map(reading -> reading.value().odomFromBase());
    }

    private void reportWhenDue() {
        if (waiting) {
            return;
        }
        Instant now = self.scheduler().instant();
        if (!now.isBefore(due)) {
            report();
            return;
        }
        waiting = true;
        self.scheduler().after(Duration.between(now, due), () -> {
            waiting = false;
            report();
        });
    }

    private void report() {
        mapFromBase().ifPresent(mapFromBase -> {
            due = self.scheduler().instant().plus(period);
            var report = new PoseReport(robot.id(), robot.role(), mapFromBase);
            if (tells) {
                self.publish(PoseReport.TOPIC, report);
            }
            said.accept(report);
        });
    }
}
