package rsal.agents.rescue;

import java.time.Duration;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import rsal.agent.AgentContext;
import rsal.agent.team.Worker;
import rsal.agents.driving.GoalService;
import rsal.agents.driving.NavigationClient;
import rsal.agents.driving.PlannedPaths;
import rsal.agents.exploration.Exploring;
import rsal.agents.parts.AgentTypeBase;
import rsal.agents.parts.PoseReporter;
import rsal.agents.parts.RequiredRobot;
import rsal.device.FiducialFinder;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.Planner;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Tells of victims that its robot sees while that explores or waits. Driving where it is told comes first.
public abstract class Rescuer extends AgentTypeBase {
    static final Parameter<Boolean> RETURNS = Parameter.flag(
            "returns",
            true,
            "Whether a robot without a task drives back to its start, so that it blocks no other robot.");

    Rescuer(String key, String description, List<Parameter<?>> own) {
        super(
                key,
                description,
                Stream.concat(own.stream(), Stream.of(RETURNS, PoseReporter.PERIOD))
                        .toList(),
                List.of(Navigator.class, Localizer.class, FiducialFinder.class));
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        Robot robot = RequiredRobot.of(self);
        var parts = new Parts(
                self,
                robot,
                new NavigationClient(self, robot.require(Navigator.class)),
                new PoseReporter(self, robot, arguments, _ -> {}),
                new Scouting(self, robot),
                Exploring.of(self, robot));
        BooleanSupplier free = work(parts, arguments);
        parts.reporter.begin();
        parts.scouting.begin();
        parts.exploring.begin(free);
        if (arguments.get(RETURNS)) {
            new Homing(
                            self,
                            parts.driver,
                            parts.reporter::mapFromBase,
                            () -> free.getAsBoolean() && parts.exploring.isDone())
                    .begin();
        }
    }

    /// Begins what else it does.
    ///
    /// @return whether nobody wants the robot
    abstract BooleanSupplier work(Parts parts, Arguments arguments);

    /// What all of them have.
    record Parts(
            AgentContext self,
            Robot robot,
            NavigationClient driver,
            PoseReporter reporter,
            Scouting scouting,
            Exploring exploring) {}

    /// Only looks for victims.
    public static final class Scout extends Rescuer {
        public Scout() {
            super("scout", "Reports victims that its robot sees while the robot explores.", List.of());
        }

        @Override
        BooleanSupplier work(Parts parts, Arguments arguments) {
            var goals = new GoalService(
                    parts.self, parts.robot.id(), parts.driver, parts.exploring::pause, parts.exploring::goOn);
            goals.begin();
            return () -> !goals.busy();
        }
    }

    /// Helps victims, too.
    public static final class Helper extends Rescuer {
        static final Parameter<Double> REACH = Parameter.number(
                "reach",
                1.2,
                0.3,
                10,
                "m",
                "Maximum distance between the centers of robot and victim to help the victim.");
        static final Parameter<Double> STAY_TIME =
                Parameter.number("stayTime", 10, 0, 600, "s", "Time for which a robot stays with a victim to help it.");

        public Helper() {
            super(
                    "helper",
                    "Bids for victims that need help, drives to the victims that it wins, and reports victims that it"
                            + " sees.",
                    List.of(REACH, STAY_TIME));
        }

        @Override
        BooleanSupplier work(Parts parts, Arguments arguments) {
            AgentContext self = parts.self;
            NavigationClient driver = parts.driver;
            Exploring exploring = parts.exploring;
            double reach = arguments.get(REACH);
            Duration stay = arguments.seconds(STAY_TIME);
            var wavefront = new PlannedPaths(parts.robot.find(Planner.class), HelpVictim.near(reach));
            var worker = new Worker(self, wavefront, parts.reporter::mapFromBase, now -> {
                if (now.job().isEmpty()) {
                    exploring.say();
                }
            });
            worker.learn(Help.class, new HelpVictim(parts, reach, stay));
            var goals = new GoalService(
                    self,
                    parts.robot.id(),
                    driver,
                    () -> {
                        worker.unfit("on an errand");
                        exploring.pause();
                    },
                    () -> {
                        exploring.goOn();
                        worker.fit();
                    });
            goals.begin();
            worker.begin();
            return () -> worker.job().isEmpty() && !goals.busy();
        }
    }
}
