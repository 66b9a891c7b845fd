package rsal.navigation.device;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.WeakHashMap;
import rsal.data.Footprint;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.device.Mapper;
import rsal.device.Navigator;
import rsal.fault.FaultyLocalizer;
import rsal.robot.DeviceDriver;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Makes explorers, of robots with `localizer: {type: slam}` and a navigator. Those of a run that know where
/// they start explore together.
public final class ExplorerDriver implements DeviceDriver {
    private static final Parameter<Double> MAX_RANGE =
            Parameter.number("maxRange", 4, 0.5, 50, "m", "ranges of the laser beyond this are ignored");
    private static final Parameter<Double> MIN_FRONTIER_LENGTH =
            Parameter.number("minFrontierLength", 0.6, 0.1, 10, "m", "shorter frontiers of the map are ignored");
    private static final Parameter<Double> RESOLUTION =
            Parameter.number("resolution", 0.1, 0.02, 1, "m", "side of a cell of the map");
    private static final Parameter<Boolean> MAP_ONLY =
            Parameter.flag("mapOnly", false, "whether it only draws the map, and does not drive the robot");
    private static final String SLAM = "slam";
    private static final String NAVIGATOR = "navigator";

    private final Map<Object, WeakReference<Exploration>> teams =
            new WeakHashMap<>(); // by run; its explorers keep them

    @Override
    public String key() {
        return "explorer";
    }

    @Override
    public String description() {
        return "Drives the robot to the frontiers of its map until there is none; several robots divide the"
                + " frontiers.";
    }

    @Override
    public Class<? extends Device> makes() {
        return Mapper.class;
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return List.of(DriveBase.class, LaserScanner.class, Localizer.class, Navigator.class);
    }

    @Override
    public Optional<String> refusal(List<DeviceDriver> before) {
        String localizer = key(before, Localizer.class);
        String navigator = key(before, Navigator.class);
        return localizer.equals(SLAM) && navigator.equals(NAVIGATOR)
                ? Optional.empty()
                : Optional.of("It needs a localizer of type '%s' and a navigator of type '%s', not '%s' and '%s'."
                        .formatted(SLAM, NAVIGATOR, localizer, navigator));
    }

    private static String key(List<DeviceDriver> drivers, Class<? extends Device> made) {
        return drivers.stream()
                .filter(driver -> made.isAssignableFrom(driver.makes()))
                .map(DeviceDriver::key)
                .findFirst()
                .orElse("none");
    }

    @Override
    public List<Parameter<?>> parameters() {
        var parameters = new ArrayList<Parameter<?>>();
        parameters.add(RESOLUTION);
        parameters.add(MIN_FRONTIER_LENGTH);
        parameters.add(MAP_ONLY);
        parameters.add(MAX_RANGE);
        parameters.addAll(GlobalPlanners.parameters());
        return parameters;
    }

    @Override
    public Device create(Context context, Arguments arguments) {
        Localizer localizer = context.robot().require(Localizer.class);
        Localizer sound = localizer instanceof FaultyLocalizer faulty ? faulty.inner() : localizer;
        if (!(sound instanceof SlamLocalizer slam)
                || !(context.robot().require(Navigator.class) instanceof PathNavigator navigator)) {
            throw new IllegalArgumentException("'%s' has devices that an explorer can't work with."
                    .formatted(context.robot().id()));
        }
        Exploration team =
                context.mapFromBase().isPresent() ? team(context.scheduler().run(), arguments) : team(arguments);
        Footprint footprint = context.robot().model().footprint();
        var explorer = new Explorer(
                new DeviceInfo(context.robot().id(), context.name(), key()),
                localizer,
                slam,
                navigator,
                team,
                new Exploration.Body(footprint.circumscribedRadius(), GlobalPlanners.clearance(footprint, arguments)),
                arguments.get(MAP_ONLY),
                context.scheduler());
        explorer.start();
        return explorer;
    }

    /// That of a run; several may begin at the same time.
    private Exploration team(Object run, Arguments arguments) {
        synchronized (teams) {
            WeakReference<Exploration> known = teams.get(run);
            Exploration team = known == null ? null : known.get();
            if (team == null) {
                team = team(arguments);
                teams.put(run, new WeakReference<>(team));
            }
            return team;
        }
    }

    private static Exploration team(Arguments arguments) {
        return new Exploration(new Exploration.Settings(
                arguments.get(RESOLUTION), arguments.get(MIN_FRONTIER_LENGTH), arguments.get(MAX_RANGE)));
    }
}
