package rsal.navigation.device;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
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
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.avoid.LocalPlanner;
import rsal.navigation.avoid.MultiPointTurn;
import rsal.navigation.avoid.Outline;
import rsal.navigation.dwa.Dwa;
import rsal.navigation.mpc.Mpc;
import rsal.navigation.nd.Nd;
import rsal.navigation.snd.Snd;
import rsal.navigation.spread.ReachableSpace;
import rsal.navigation.vfh.Vfh;
import rsal.robot.DeviceDriver;
import rsal.robot.RobotModel;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Makes navigators: a [rsal.navigation.wavefront.Wavefront] plans the way, a [LocalPlanner] drives along it.
public final class NavigatorDriver implements DeviceDriver {
    private static final double LOOKAHEAD_TIME = 2.0; // s
    private static final double LEAST_LOOKAHEAD = 0.6; // m
    private static final double VIEW = 5; // m
    private static final double REACTION = 2 * PathNavigator.BEAT_SECONDS;

    private final Ways ways = new Ways();

    @Override
    public String key() {
        return "navigator";
    }

    @Override
    public String description() {
        return "Drives the robot to places: plans a way over the map and avoids what stands in it.";
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
    public List<Parameter> parameters() {
        var parameters = new ArrayList<Parameter>();
        parameters.add(Parameter.choice(
                "global",
                "wavefront",
                List.of("wavefront"),
                "plans the way; a jumppoint planner is a device of its own, which agents ask for ways"));
        parameters.add(Parameter.choice("local", "vfh", List.of("vfh", "nd", "snd", "dwa", "mpc"), "drives along it"));
        parameters.add(Parameter.number("maxSpeed", 0.4, 0.05, 3, "m/s", "never faster"));
        parameters.add(Parameter.number("maxTurnRate", 70, 5, 360, "deg/s", "never turns faster"));
        parameters.add(Parameter.number("maxAcceleration", 10, 0.05, 10, "m/s²", "never speeds up or brakes harder"));
        parameters.addAll(VfhOptions.parameters());
        parameters.add(Parameter.number(
                "avoidDist", 0.5, 0.05, 3, "m", "from what is nearer to its edge nd turns away and slows down"));
        parameters.add(Parameter.number("safetyDist", 0, 0, 1, "m", "room around it that nd counts as part of it"));
        parameters.add(Parameter.number("obstacleAvoidDist", 0.6, 0.05, 5, "m", "what avoidDist is, for snd"));
        parameters.add(Parameter.number(
                "minGapWidth", 0.5, 0.05, 3, "m", "by how much ranges must jump where snd sees a gap"));
        parameters.add(Parameter.number(
                "robotRadius", 0, 0, 3, "m", "of the circle that snd takes it for; 0: one as large as it is"));
        parameters.add(Parameter.number("replanPeriod", 4, 0.2, 60, "s", "how often it looks for a better way"));
        parameters.add(Parameter.number("escapeSpeed", 0.1, 0.02, 0.5, "m/s", "how fast it backs off when blocked"));
        parameters.add(Parameter.number("escapeTime", 5, 0.5, 30, "s", "how long it does so at most"));
        parameters.add(Parameter.number("patience", 45, 5, 600, "s", "without getting nearer, until it is stuck"));
        parameters.addAll(Ways.parameters());
        return parameters;
    }

    @Override
    public Optional<String> advice(String option) {
        return ForeignOptions.OF_NAVIGATORS.advice(option, parameters());
    }

    @Override
    public Optional<String> refusal(RobotModel model) {
        return model.drive().turnsInPlace()
                ? Optional.empty()
                : Optional.of(
                        "It plans ways for robots that turn in place, which a car (%s) can't.".formatted(model.name()));
    }

    @Override
    public Optional<String> refusal(Arguments arguments) {
        return arguments.text("local").equals("vfh") ? VfhOptions.refusal(arguments) : Optional.empty();
    }

    @Override
    public SortedMap<Integer, String> misplaced(Places asked, Arguments arguments) {
        var wrong = new TreeMap<Integer, String>();
        double clearance = Ways.clearance(asked.model().footprint(), arguments).radius();
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
        double speed = Math.min(arguments.number("maxSpeed"), model.drive().maxSpeed());
        var limits = new DriveLimits(
                speed,
                Math.min(arguments.radians("maxTurnRate"), model.drive().maxTurnRate()),
                Math.min(arguments.number("maxAcceleration"), model.drive().maxAcceleration()),
                model.drive().maxTurnAcceleration());
        double lookahead = LEAST_LOOKAHEAD + LOOKAHEAD_TIME * speed;
        var navigator = new PathNavigator(
                new DeviceInfo(context.robot().id(), context.name(), key()),
                new PathNavigator.Parts(
                        context.robot().require(DriveBase.class),
                        context.robot().require(Localizer.class),
                        laser,
                        sonars,
                        avoidance(arguments, model.footprint(), limits, lookahead),
                        new MultiPointTurn(model.footprint(), limits, REACTION),
                        ways.of(context.map(), model.footprint(), arguments),
                        ways.field(context.map())),
                new PathNavigator.Settings(
                        limits,
                        lookahead,
                        view(arguments, lookahead + 2 * model.footprint().circumscribedRadius()),
                        model.footprint().circumscribedRadius(),
                        arguments.seconds("replanPeriod"),
                        arguments.number("escapeSpeed"),
                        arguments.seconds("escapeTime"),
                        arguments.seconds("patience")),
                context.scheduler(),
                context.random());
        navigator.start();
        return navigator;
    }

    /// Planners that look for gaps or ahead see farther than the next step.
    private static double view(Arguments arguments, double atLeast) {
        return arguments.text("local").equals("vfh")
                ? Math.max(atLeast, VfhOptions.window(arguments, atLeast) + atLeast)
                : Math.max(atLeast, VIEW);
    }

    private static LocalPlanner avoidance(
            Arguments arguments, Footprint footprint, DriveLimits limits, double lookahead) {
        return switch (arguments.text("local")) {
            case "dwa" -> new Dwa(footprint, limits, Dwa.Settings.of(0.25, lookahead), REACTION);
            case "nd" ->
                new Nd(
                        footprint,
                        limits,
                        new Nd.Settings(arguments.number("avoidDist"), arguments.number("safetyDist")),
                        REACTION);
            case "snd" ->
                new Snd(
                        footprint,
                        limits,
                        new Snd.Settings(
                                arguments.number("robotRadius") > 0
                                        ? arguments.number("robotRadius")
                                        : Outline.radius(footprint),
                                arguments.number("minGapWidth"),
                                arguments.number("obstacleAvoidDist")),
                        REACTION);
            case "mpc" -> new Mpc(footprint, limits, Mpc.Settings.DEFAULT, REACTION, PathNavigator.BEAT_SECONDS);
            default -> new Vfh(footprint, limits, VfhOptions.settings(arguments, lookahead), REACTION);
        };
    }
}
