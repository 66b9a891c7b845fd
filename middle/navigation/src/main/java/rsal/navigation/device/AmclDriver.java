package rsal.navigation.device;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Optional;
import rsal.data.Covariance2d;
import rsal.data.OccupancyGrid;
import rsal.data.PoseEstimate;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.device.RangeSensor;
import rsal.device.SonarArray;
import rsal.navigation.amcl.Amcl;
import rsal.navigation.amcl.Kld;
import rsal.navigation.amcl.LocalizationMap;
import rsal.navigation.amcl.OdometryModel;
import rsal.navigation.amcl.OdometryModel.Base;
import rsal.navigation.amcl.SensorModel;
import rsal.robot.DeviceDriver;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.OdometryNoise;
import rsal.robot.RobotModel.Steering;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Makes localizers that use [Amcl] on a laser scanner or, where a robot has none, on its sonars. Robots of a run
/// share what is computed from the map.
public final class AmclDriver implements DeviceDriver {
    private static final double LEAST_DISTANCE_NOISE = 0.05; // m/√m; wheels slip more than their makers say
    private static final double LEAST_DRIVING_NOISE = 0.05; // rad/√m
    private static final double LEAST_TURNING_NOISE = 0.08; // rad/√rad

    private static final Logger LOG = System.getLogger(AmclDriver.class.getName());

    private record MapKey(OccupancyGrid map, double deviation, double randomShare) {}

    private final Shared<MapKey, LocalizationMap> maps = new Shared<>();

    @Override
    public String key() {
        return "amcl";
    }

    @Override
    public String description() {
        return "Says where the robot is on the map: a particle filter (adaptive Monte Carlo localization).";
    }

    @Override
    public Class<? extends Device> makes() {
        return Localizer.class;
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return List.of(DriveBase.class, RangeSensor.class);
    }

    @Override
    public List<Parameter> parameters() {
        return List.of(
                Parameter.choice(
                        "model",
                        "auto",
                        List.of("auto", "field", "beam"),
                        "how beams are judged: near walls (field) or as long as expected (beam); auto: beam for sonars"),
                Parameter.integer("beams", 60, 5, 1000, "", "beams of a laser scan to look at"),
                Parameter.number("maxRange", 30, 0.5, 200, "m", "ranges beyond this are not looked at"),
                Parameter.number("hitDeviation", 0.1, 0.01, 1, "m", "how far laser hits are from the map's walls"),
                Parameter.number("sonarDeviation", 0.25, 0.01, 1, "m", "the same for sonars"),
                Parameter.number(
                        "randomShare", 0.05, 0.001, 0.5, "", "share of readings that have nothing to do with the map"),
                Parameter.number("independentBeams", 15, 1, 1000, "", "how many beams a scan counts for"),
                Parameter.number("independentSonars", 3, 1, 1000, "", "how many of a round of sonars count"),
                Parameter.integer("minParticles", 150, 20, 100_000, "", "particles when it knows well where it is"),
                Parameter.integer("maxParticles", 5000, 100, 100_000, "", "particles when it knows least"),
                Parameter.number("updateDistance", 0.1, 0.01, 5, "m", "way after which it looks at a scan"),
                Parameter.number("updateAngle", 6, 0.5, 180, "deg", "turn after which it looks at a scan"),
                Parameter.number("initialDeviation", 0.2, 0, 100, "m", "how uncertain the start position is"),
                Parameter.number("initialAngleDeviation", 10, 0, 360, "deg", "how uncertain the start heading is"),
                Parameter.number(
                        "odometryDoubt", 2, 0.5, 20, "", "how many times worse odometry may be than the model says"));
    }

    @Override
    public Optional<String> advice(String option) {
        return ForeignOptions.OF_LOCALIZERS.advice(option, parameters());
    }

    @Override
    public Optional<String> refusal(Arguments arguments) {
        int least = arguments.integer("minParticles");
        int most = arguments.integer("maxParticles");
        return least <= most
                ? Optional.empty()
                : Optional.of(
                        "Of particles, no more than maxParticles (%d) can be kept, but no fewer than minParticles (%d)."
                                .formatted(most, least));
    }

    @Override
    public Device create(Context context, Arguments arguments) {
        var base = context.robot().require(DriveBase.class);
        Optional<LaserScanner> laser = context.robot().find(LaserScanner.class);
        double deviation = arguments.number(laser.isPresent() ? "hitDeviation" : "sonarDeviation");
        var map = maps.of(
                new MapKey(context.map(), deviation, arguments.number("randomShare")),
                key -> new LocalizationMap(key.map(), key.deviation(), key.randomShare()));
        if (context.mapFromBase().isEmpty() && !map.isSearchable()) {
            LOG.log(
                    Level.WARNING,
                    () ->
                            "(%s/%s) stays lost until it is told where it is: the map has %.0f m² of free floor, and is searched up to %.0f m²."
                                    .formatted(
                                            context.robot().id(),
                                            context.name(),
                                            map.freeFloor(),
                                            LocalizationMap.MOST_SEARCHED));
        }
        int minParticles = arguments.integer("minParticles");
        var settings = new Amcl.Settings(
                minParticles,
                arguments.integer("maxParticles"),
                arguments.number(laser.isPresent() ? "independentBeams" : "independentSonars"),
                arguments.number("updateDistance"),
                arguments.radians("updateAngle"),
                odometry(context.robot().model().drive(), arguments.number("odometryDoubt")),
                new Kld(0.05, 2.33),
                model(arguments.text("model"), laser.isPresent()));
        var deviations = Covariance2d.ofDeviations(
                arguments.number("initialDeviation"),
                arguments.number("initialDeviation"),
                arguments.radians("initialAngleDeviation"));
        var localizer = new AmclLocalizer(
                new DeviceInfo(context.robot().id(), context.name(), key()),
                new Amcl(map, settings, context.random()),
                context.map(),
                context.mapFromBase().map(pose -> PoseEstimate.of(pose, deviations)),
                context.scheduler());
        localizer.follow(base);
        double maxRange = arguments.number("maxRange");
        if (laser.isPresent()) {
            localizer.look(laser.get(), arguments.integer("beams"), maxRange);
        } else {
            localizer.look(context.robot().require(SonarArray.class), maxRange);
        }
        return localizer;
    }

    private static SensorModel.Kind model(String name, boolean laser) {
        return switch (name) {
            case "field" -> SensorModel.Kind.FIELD;
            case "beam" -> SensorModel.Kind.BEAM;
            default -> laser ? SensorModel.Kind.FIELD : SensorModel.Kind.BEAM;
        };
    }

    private static OdometryModel odometry(Drive drive, double doubt) {
        OdometryNoise noise = drive.odometryNoise();
        double distance = Math.max(LEAST_DISTANCE_NOISE, doubt * noise.distancePerMeter());
        double driving = Math.max(LEAST_DRIVING_NOISE, doubt * noise.headingPerMeter());
        double turning = Math.max(LEAST_TURNING_NOISE, doubt * noise.headingPerRadian());
        return drive.steering() instanceof Steering.Omnidirectional
                ? new OdometryModel(distance, driving, turning, distance, Base.OMNIDIRECTIONAL)
                : new OdometryModel(distance, driving, turning);
    }
}
