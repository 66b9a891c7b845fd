import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agents.pursuit.Caught;
import rsal.agent.message.PoseReport;
import rsal.data.Pose2d;
import rsal.device.Device;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.Navigator.Tolerance;
import rsal.robot.LineOfSight;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Goes for the newest pose of a prey until that has been caught.
public final class Hunter implements AgentType {
    private static final Parameter<String> PREY = Parameter.text("prey", "prey", "Role of the robots to hunt.");
    private static final Parameter<Double> CATCH_DISTANCE =
            Parameter.number("catchDistance", 1.5, 0.8, 3, "m", "It stops when nearer to its prey than this.");
    private static final Parameter<Double> PERIOD =
            Parameter.number("period", 0.5, 0.1, 10, "s", "How often it says where it is.");
    private static final Parameter<Double> INTERVAL =
            Parameter.number("interval", 2, 0.5, 60, "s", "How often it goes for the prey's newest pose.");

    @Override
    public String key() {
        return "hunter";
    }

    @Override
    public String description() {
        return "Goes for the newest pose of a prey until that has been caught.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(PREY, CATCH_DISTANCE, PERIOD, INTERVAL);
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return List.of(Localizer.class, Navigator.class);
    }

    @Override
    public Agent create(Arguments arguments) {
        return self -> new Hunt(self, self.robot().orElseThrow(), arguments).begin();
    }

    /// One hunter on its hunt. All of it runs on the agent's own thread: it never waits, but says what comes
    /// later.
    private static final class Hunt {
        private final AgentContext self;
        private final Robot robot;
        private final Navigator navigator;
        private final String role;
        private final double catchDistance;
        private final Duration period;
        private final Duration interval;
        private final Set<String> caught = new HashSet<>();
        private Optional<PoseReport> seen = Optional.empty();
        private Runnable stop = () -> {}; // cancels the current goal

        Hunt(AgentContext self, Robot robot, Arguments arguments) {
            this.self = self;
            this.robot = robot;
            this.navigator = robot.require(Navigator.class);
            this.role = arguments.get(PREY);
            this.catchDistance = arguments.get(CATCH_DISTANCE);
            this.period = arguments.seconds(PERIOD);
            this.interval = arguments.seconds(INTERVAL);
        }

        void begin() {
            self.subscribe(PoseReport.TOPIC, PoseReport.ofRobots(role), message -> see(message.content()));
            self.subscribe(Caught.TOPIC, message -> end(message.content()));
            self.atEnd(() -> stop.run());
            self.scheduler().every(period, this::report);
            self.scheduler().every(interval, this::hunt);
        }

        private Optional<Pose2d> here() {
            return robot.require(Localizer.class).latest().map(estimate -> estimate.value().mapFromBase());
        }

        private void report() {
            here().ifPresent(pose -> self.publish(PoseReport.TOPIC, new PoseReport(robot.id(), robot.role(), pose)));
        }

        private void see(PoseReport report) {
            if (!caught.contains(report.robot())) {
                seen = Optional.of(report);
            }
        }

        private void end(Caught reported) {
            caught.add(reported.prey());
            seen = seen.filter(prey -> !prey.robot().equals(reported.prey()));
            stop.run();
            self.state("%s has caught %s".formatted(reported.hunter(), reported.prey()));
        }

        private void hunt() {
            if (seen.isEmpty() || here().isEmpty()) {
                return;
            }
            Pose2d prey = seen.get().mapFromBase();
            if (LineOfSight.reaches(robot, here().get(), prey, catchDistance)) {
                stop.run();
                self.state("holding %s at bay".formatted(seen.get().robot()));
            } else {
                stop = navigator.goTo(prey, Tolerance.position(catchDistance / 2))::cancel;
                self.state("hunting %s".formatted(seen.get().robot()));
            }
        }
    }
}
