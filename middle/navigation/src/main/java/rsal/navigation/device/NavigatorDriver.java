package rsal.navigation.device;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.SortedMap;
import java.util.TreeMap;
import rsal.data.Footprint;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.RangeSensor;
import rsal.device.SonarArray;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.control.ControllerType;
import rsal.navigation.control.GoalCheckerType;
import rsal.navigation.control.PlannerType;
import rsal.navigation.control.ProgressCheckerType;
import rsal.navigation.recovery.RecoveryType;
import rsal.navigation.spread.ReachableSpace;
import rsal.navigation.traffic.TrafficRule;
import rsal.navigation.traffic.TrafficType;
import rsal.robot.DeviceDriver;
import rsal.robot.RobotModel;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.settings.PluginChoice;
import rsal.settings.PluginKind;

/// Makes navigators: a global planner plans the way, a controller drives along it. Recoveries
/// drive when it makes no progress. All are plugins, as what decides about goals and progress is.
public final class NavigatorDriver implements DeviceDriver {
    private static final Parameter<Double> ESCAPE_TIME =
            Parameter.number("escapeTime", 5, 0.5, 30, "s", "maximum time of recoveries backward");
    private static final Parameter<Double> ESCAPE_SPEED =
            Parameter.number("escapeSpeed", 0.1, 0.02, 0.5, "m/s", "speed of recoveries backward");
    private static final Parameter<Double> TIMEOUT =
            Parameter.number("timeout", 45, 5, 600, "s", "time without progress after which it gives up");
    private static final Parameter<Double> REPLAN_PERIOD =
            Parameter.number("replanPeriod", 4, 0.2, 60, "s", "time between two searches for a better path");
    private static final Parameter<Double> MAX_ACCELERATION =
            Parameter.number("maxAcceleration", 10, 0.05, 10, "m/s²", "maximum acceleration and deceleration");
    private static final Parameter<Double> MAX_TURN_RATE =
            Parameter.number("maxTurnRate", 70, 5, 360, "deg/s", "maximum turn rate");
    private static final Parameter<Double> MAX_SPEED =
            Parameter.number("maxSpeed", 0.4, 0.05, 3, "m/s", "maximum speed");
    private static final double LOOKAHEAD_TIME = 2.0; // s
    private static final double LEAST_LOOKAHEAD = 0.6; // m
    private static final double REACTION = 2 * PathNavigator.BEAT_SECONDS;

    private static final PluginKind CONTROLLERS =
            PluginKind.of("controller", ControllerType.class, ServiceLoader.load(ControllerType.class));
    private static final Parameter<PluginChoice> CONTROLLER =
            Parameter.plugin("controller", "vfh", CONTROLLERS, "drives along the path and around obstacles");

    private static final PluginKind PLANNERS =
            PluginKind.of("planner", PlannerType.class, ServiceLoader.load(PlannerType.class));
    private static final Parameter<PluginChoice> PLANNER =
            Parameter.plugin("planner", "wavefront", PLANNERS, "plans the path over the map");

    private static final PluginKind GOAL_CHECKERS =
            PluginKind.of("goalChecker", GoalCheckerType.class, ServiceLoader.load(GoalCheckerType.class));
    private static final Parameter<PluginChoice> GOAL_CHECKER =
            Parameter.plugin("goalChecker", "tolerance", GOAL_CHECKERS, "decides when a goal is reached");

    private static final PluginKind PROGRESS_CHECKERS =
            PluginKind.of("progressChecker", ProgressCheckerType.class, ServiceLoader.load(ProgressCheckerType.class));
    private static final Parameter<PluginChoice> PROGRESS_CHECKER = Parameter.plugin(
            "progressChecker", "path", PROGRESS_CHECKERS, "defines progress; without progress, a recovery begins");

    private static final PluginKind RECOVERY_TYPES =
            PluginKind.of("recovery", RecoveryType.class, ServiceLoader.load(RecoveryType.class));
    private static final Parameter<List<PluginChoice>> RECOVERIES = Parameter.plugins(
            "recoveries",
            List.of("multiPointTurn", "turnAround", "backUp"),
            RECOVERY_TYPES,
            "recoveries without progress: the first one that is due begins");
    private static final Parameter<PluginChoice> LOST_RECOVERY =
            Parameter.plugin("lostRecovery", "lookAround", RECOVERY_TYPES, "recovery while the robot is not localized");

    private static final PluginKind TRAFFIC_TYPES =
            PluginKind.of("traffic", TrafficType.class, ServiceLoader.load(TrafficType.class));
    private static final Parameter<PluginChoice> TRAFFIC = Parameter.plugin(
            "traffic", "rightOfWay", TRAFFIC_TYPES, "decides which robot goes first where two cannot pass");

    private static final Parameter<Boolean> PREDICT_MOVERS = Parameter.flag(
            "predictMovers", true, "predict where people and others go that a laser sees moving, and yield to them");

    private final GlobalPlanners planners = new GlobalPlanners();

    @Override
    public String key() {
        return "navigator";
    }

    @Override
    public String description() {
        return "Drives the robot to places: plans a path over the map and avoids obstacles on it.";
    }

    @Override
    public Class<? extends Device> makes() {
        return Navigator.class;
    }

    /// Where a robot has both a laser scanner and sonars, sonars look where the laser doesn't.
    @Override
    public List<Class<? extends Device>> needs() {
        return List.of(DriveBase.class, RangeSensor.class, Localizer.class);
    }

    @Override
    public List<Parameter<?>> parameters() {
        var parameters = new ArrayList<Parameter<?>>();
        parameters.add(PLANNER);
        parameters.add(CONTROLLER);
        parameters.add(GOAL_CHECKER);
        parameters.add(PROGRESS_CHECKER);
        parameters.add(RECOVERIES);
        parameters.add(LOST_RECOVERY);
        parameters.add(TRAFFIC);
        parameters.add(PREDICT_MOVERS);
        parameters.add(MAX_SPEED);
        parameters.add(MAX_TURN_RATE);
        parameters.add(MAX_ACCELERATION);
        parameters.add(REPLAN_PERIOD);
        parameters.add(ESCAPE_SPEED);
        parameters.add(ESCAPE_TIME);
        parameters.add(TIMEOUT);
        parameters.addAll(GlobalPlanners.parameters());
        return parameters;
    }

    @Override
    public Optional<String> advice(String option) {
        return ForeignOptions.OF_NAVIGATORS.advice(option, parameters()).or(() -> adviceOfControllers(option));
    }

    /// What can be set of a controller stands in its own group.
    private static Optional<String> adviceOfControllers(String option) {
        return CONTROLLERS.all().stream()
                .flatMap(controller -> controller.parameters().stream()
                        .filter(parameter -> ForeignOptions.isSame(parameter.name(), option))
                        .map(parameter -> "It belongs to the controller: 'controller: {type: %s, %s: …}'."
                                .formatted(controller.key(), parameter.name())))
                .findFirst();
    }

    @Override
    public Optional<String> refusal(RobotModel model) {
        return model.drive().turnsInPlace()
                ? Optional.empty()
                : Optional.of("It plans paths for robots that turn in place, which a car '%s' can't."
                        .formatted(model.name()));
    }

    @Override
    public SortedMap<Integer, String> misplaced(Places asked, Arguments arguments) {
        var wrong = new TreeMap<Integer, String>();
        double clearance =
                GlobalPlanners.clearance(asked.model().footprint(), arguments).radius();
        try {
            ReachableSpace.check(asked.map(), clearance, asked.mapFromStarts(), asked.mapFromPlaces(), asked.within())
                    .forEach(place -> wrong.put(place.index(), place.why()));
        } catch (IllegalArgumentException e) { // they fit nowhere
            for (int i = 0; i < asked.mapFromPlaces().size(); i++) {
                wrong.put(i, String.valueOf(e.getMessage()));
            }
        }
        return wrong;
    }

    @Override
    public Device create(Context context, Arguments arguments) {
        RobotModel model = context.robot().model();
        Optional<LaserScanner> laser = context.robot().find(LaserScanner.class);
        Optional<SonarArray> sonars = context.robot().find(SonarArray.class);
        context.robot().require(RangeSensor.class); // or it would drive blindly
        double speed = Math.min(arguments.get(MAX_SPEED), model.drive().maxSpeed());
        var limits = new DriveLimits(
                speed,
                Math.min(arguments.radians(MAX_TURN_RATE), model.drive().maxTurnRate()),
                Math.min(arguments.get(MAX_ACCELERATION), model.drive().maxAcceleration()),
                model.drive().maxTurnAcceleration());
        double lookahead = LEAST_LOOKAHEAD + LOOKAHEAD_TIME * speed;
        var driven =
                new ControllerType.Driven(model.footprint(), limits, lookahead, PathNavigator.BEAT_SECONDS, REACTION);
        PluginChoice chosen = arguments.get(CONTROLLER);
        ControllerType type = chosen.as(ControllerType.class);
        Controller controller = type.create(chosen.arguments(), driven);
        var navigator = new PathNavigator(
                new DeviceInfo(context.robot().id(), context.name(), key()),
                new PathNavigator.Parts(
                        context.robot().require(DriveBase.class),
                        context.robot().require(Localizer.class),
                        laser,
                        sonars,
                        controller,
                        planners.planner(context.map(), model.footprint(), arguments, arguments.get(PLANNER)),
                        plugins(context, arguments, driven, controller),
                        planners.field(context.map()),
                        traffic(context, arguments)),
                new PathNavigator.Settings(
                        limits,
                        lookahead,
                        Math.max(
                                type.view(chosen.arguments(), driven),
                                lookahead + 2 * model.footprint().circumscribedRadius()),
                        model.footprint().circumscribedRadius(),
                        arguments.seconds(REPLAN_PERIOD),
                        arguments.seconds(TIMEOUT),
                        arguments.get(PREDICT_MOVERS)),
                context.scheduler());
        navigator.start();
        return navigator;
    }

    private TrafficRule traffic(Context context, Arguments arguments) {
        PluginChoice chosen = arguments.get(TRAFFIC);
        Footprint footprint = context.robot().model().footprint();
        return chosen.as(TrafficType.class)
                .create(
                        chosen.arguments(),
                        new TrafficType.Participant(
                                context.robot().id(),
                                footprint.circumscribedRadius(),
                                context.team(),
                                () -> context.scheduler()
                                        .compute(() -> planners.passages(context.map(), footprint, arguments)),
                                context.scheduler().instant()));
    }

    private static TaskPlugins plugins(
            Context context, Arguments arguments, ControllerType.Driven driven, Controller controller) {
        return new TaskPlugins(
                arguments.get(GOAL_CHECKER),
                arguments.get(PROGRESS_CHECKER),
                arguments.get(RECOVERIES),
                arguments.get(LOST_RECOVERY),
                new RecoveryType.Driven(
                        driven.footprint(),
                        driven.limits(),
                        driven.lookahead(),
                        driven.reaction(),
                        arguments.get(ESCAPE_SPEED),
                        arguments.seconds(ESCAPE_TIME),
                        controller,
                        context.scheduler(),
                        context.random()));
    }
}
