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
import rsal.navigation.parameter.AmclParameters;
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

    private final ComputedOnce<MapKey, LocalizationMap> maps = new ComputedOnce<>();

    @Override
    public String key() {
        return "amcl";
    }

    @Override
    public String description() {
        return "Estimates the robot's pose on the map by a particle filter (adaptive Monte Carlo localization).";
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
    public List<Parameter<?>> parameters() {
        return AmclParameters.ALL;
    }

    @Override
    public Optional<String> advice(String option) {
        return ForeignOptions.OF_LOCALIZERS.advice(option, parameters());
    }

    @Override
    public Optional<String> refusal(Arguments arguments) {
        int least = arguments.get(AmclParameters.MIN_PARTICLES);
        int most = arguments.get(AmclParameters.MAX_PARTICLES);
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
        double deviation =
                arguments.get(laser.isPresent() ? AmclParameters.HIT_DEVIATION : AmclParameters.SONAR_DEVIATION);
        var map = maps.of(
                new MapKey(context.map(), deviation, arguments.get(AmclParameters.RANDOM_SHARE)),
                key -> new LocalizationMap(key.map(), key.deviation(), key.randomShare()));
        if (context.mapFromBase().isEmpty() && !map.isSearchable()) {
            LOG.log(
                    Level.WARNING,
                    () ->
                            "'%s/%s' stays lost until it gets a pose: the map has %.0f m² of free floor, and is searched up to %.0f m²."
                                    .formatted(
                                            context.robot().id(),
                                            context.name(),
                                            map.freeFloor(),
                                            LocalizationMap.MOST_SEARCHED));
        }
        int minParticles = arguments.get(AmclParameters.MIN_PARTICLES);
        var settings = new Amcl.Settings(
                minParticles,
                arguments.get(AmclParameters.MAX_PARTICLES),
                arguments.get(laser.isPresent() ? AmclParameters.INDEPENDENT_BEAMS : AmclParameters.INDEPENDENT_SONARS),
                arguments.get(AmclParameters.UPDATE_DISTANCE),
                arguments.radians(AmclParameters.UPDATE_ANGLE),
                odometry(context.robot().model().drive(), arguments.get(AmclParameters.ODOMETRY_NOISE_SCALE)),
                new Kld(0.05, 2.33),
                model(arguments.get(AmclParameters.MODEL), laser.isPresent()));
        var deviations = Covariance2d.ofDeviations(
                arguments.get(AmclParameters.INITIAL_DEVIATION),
                arguments.get(AmclParameters.INITIAL_DEVIATION),
                arguments.radians(AmclParameters.INITIAL_ANGLE_DEVIATION));
        var localizer = new AmclLocalizer(
                new DeviceInfo(context.robot().id(), context.name(), key()),
                new Amcl(map, settings, context.random()),
                context.map(),
                context.mapFromBase().map(pose -> PoseEstimate.of(pose, deviations)),
                context.scheduler());
        localizer.follow(base);
        localizer.knows(new TeamPoses(context.team(), context.scheduler())::now);
        double maxRange = arguments.get(AmclParameters.MAX_RANGE);
        if (laser.isPresent()) {
            localizer.look(laser.get(), arguments.get(AmclParameters.BEAMS), maxRange);
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
