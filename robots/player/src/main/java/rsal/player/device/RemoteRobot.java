package rsal.player.device;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import rsal.device.Canvas;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.Localizer;
import rsal.device.Mapper;
import rsal.device.Navigator;
import rsal.player.message.Interface;
import rsal.player.wire.Address;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.time.Scheduler;

/// A robot whose devices Player servers have: for each part of its model the one that fits. All on the
/// scheduler's thread.
public final class RemoteRobot {
    private static final String DRIVER = "player";

    private final RobotSpec spec;
    private final List<Seen> seen;
    private final List<RobotModel> before;
    private final Duration watchdog;
    private final Scheduler scheduler;
    private final Map<Kind, Integer> taken = new EnumMap<>(Kind.class);
    private final List<Device> devices = new ArrayList<>();
    private final List<Remote> remotes = new ArrayList<>(); // its base first
    private final List<CompletionStage<Void>> connecting = new ArrayList<>();
    private final PlayerBase base;

    /// A server with what it has.
    private record Seen(RemoteServer server, ServerOffer offer) {}

    private record Found(RemoteServer server, Address address) {}

    /// What servers have of robots.
    private enum Kind {
        BASE,
        LASER,
        SONARS,
        BUMPER,
        BATTERY,
        CAMERA,
        MARKERS,
        GRIPPER,
        JOINT,
        INPUTS,
        LOCALIZER,
        PLANNER,
        MAP,
        CANVAS;

        private static final Map<Class<? extends Device>, Kind> OWN =
                Map.of(Localizer.class, LOCALIZER, Navigator.class, PLANNER, Mapper.class, MAP, Canvas.class, CANVAS);

        /// How many of them a robot has.
        private int of(RobotModel model) {
            return this == BASE
                    ? 1
                    : (int) model.sensors().values().stream().filter(this::isOf).count();
        }

        private boolean isOf(Part part) {
            return switch (part) {
                case Part.Laser _ -> this == LASER;
                case Part.Sonars _ -> this == SONARS;
                case Part.Bumper _ -> this == BUMPER;
                case Part.Battery _ -> this == BATTERY;
                case Part.BlobFinder _ -> this == CAMERA;
                case Part.FiducialFinder _ -> this == MARKERS;
                case Part.Gripper its -> this == GRIPPER || this == INPUTS || (this == JOINT && its.hasLift());
                case Part.Actuator _ -> this == JOINT;
                case Part.Own own -> this == OWN.get(own.makes());
                case Part.Light _, Part.Registered _ -> false;
            };
        }

        /// All of a server, in their order: what is told of a scanner or of sonars as `ranger` goes before what
        /// is told of the same one otherwise.
        private List<Address> of(ServerOffer offer) {
            return switch (this) {
                case BASE -> offer.of(Interface.POSITION2D);
                case LASER -> offer.scanners().isEmpty() ? offer.of(Interface.LASER) : offer.scanners();
                case SONARS -> offer.rings().isEmpty() ? offer.of(Interface.SONAR) : offer.rings();
                case BUMPER -> offer.of(Interface.BUMPER);
                case BATTERY -> offer.of(Interface.POWER);
                case CAMERA -> offer.of(Interface.BLOBFINDER);
                case MARKERS -> offer.of(Interface.FIDUCIAL);
                case GRIPPER -> offer.of(Interface.GRIPPER);
                case JOINT -> offer.of(Interface.ACTARRAY);
                case INPUTS -> offer.of(Interface.DIO);
                case LOCALIZER -> offer.of(Interface.LOCALIZE);
                case PLANNER -> offer.of(Interface.PLANNER);
                case MAP -> offer.of(Interface.MAP);
                case CANVAS -> offer.of(Interface.GRAPHICS2D);
            };
        }

        /// Whether robots may all have the same one.
        private boolean isShared() {
            return this == MAP;
        }
    }

    /// @param servers that are [known][RemoteServer#known]
    /// @param before models of the robots that these servers have before it
    /// @param watchdog after which it stands when nothing more is commanded
    /// @param armed whether its motors are on from the beginning
    /// @throws IOException when these servers have no device for a part of its model
    public RemoteRobot(
            RobotSpec spec,
            List<RemoteServer> servers,
            List<RobotModel> before,
            Duration watchdog,
            boolean armed,
            Scheduler scheduler)
            throws IOException {
        this.spec = spec;
        this.before = List.copyOf(before);
        this.watchdog = watchdog;
        this.scheduler = scheduler;
        this.seen =
                servers.stream().map(server -> new Seen(server, server.offer())).toList();
        this.base = add(
                Kind.BASE,
                "base",
                (info, at) ->
                        new PlayerBase(info, at.address, at.server, spec.model().drive(), watchdog, armed, scheduler));
        for (Map.Entry<String, Part> part : spec.model().sensors().entrySet()) {
            add(part.getKey(), part.getValue());
        }
    }

    /// Whether Player has something like a part.
    public static boolean has(Part part) {
        return switch (part) {
            case Part.Light _, Part.Registered _ -> false;
            case Part.Own own -> Kind.OWN.containsKey(own.makes());
            default -> true;
        };
    }

    private void add(String name, Part part) throws IOException {
        switch (part) {
            case Part.Laser laser -> add(Kind.LASER, name, (info, at) -> new PlayerLaser(info, at.address, laser));
            case Part.Sonars sonars -> add(Kind.SONARS, name, (info, at) -> new PlayerSonars(info, at.address, sonars));
            case Part.Bumper bumper ->
                add(Kind.BUMPER, name, (info, at) -> new PlayerBumpers(info, at.address, bumper));
            case Part.Battery _ -> add(Kind.BATTERY, name, (info, at) -> new PlayerBattery(info, at.address));
            case Part.BlobFinder camera ->
                add(Kind.CAMERA, name, (info, at) -> new PlayerCamera(info, at.address, camera));
            case Part.FiducialFinder finder ->
                add(Kind.MARKERS, name, (info, at) -> new PlayerMarkers(info, at.address, finder));
            case Part.Gripper gripper -> add(Kind.GRIPPER, name, (info, at) -> gripper(info, at, gripper));
            case Part.Actuator actuator ->
                add(
                        Kind.JOINT,
                        name,
                        (info, at) ->
                                new PlayerActuator(info, at.address, at.server, base, actuator, watchdog, scheduler));
            case Part.Own own
            when own.makes().equals(Localizer.class) ->
                add(
                        Kind.LOCALIZER,
                        name,
                        (info, at) -> new PlayerLocalizer(info, at.address, at.server, base, scheduler));
            case Part.Own own
            when own.makes().equals(Mapper.class) ->
                add(Kind.MAP, name, (info, at) -> new PlayerMap(info, at.address, at.server, scheduler));
            case Part.Own own
            when own.makes().equals(Canvas.class) ->
                add(Kind.CANVAS, name, (info, at) -> new PlayerCanvas(info, at.address, at.server));
            case Part.Own _ ->
                add(
                        Kind.PLANNER,
                        name,
                        (info, at) -> new PlayerNavigator(info, at.address, at.server, base, scheduler));
            case Part.Light _, Part.Registered _ ->
                throw new IllegalArgumentException("'%s' was refused before.".formatted(part.name()));
        }
    }

    /// With what the servers have of its lift and its beams.
    private PlayerGripper gripper(DeviceInfo info, Found at, Part.Gripper part) {
        Optional<PlayerLift> lift = part.hasLift()
                ? next(Kind.JOINT).map(joint -> connect(joint, new PlayerLift(joint.address, joint.server)))
                : Optional.empty();
        Optional<PlayerBeams> beams = next(Kind.INPUTS).map(inputs -> connect(inputs, new PlayerBeams(inputs.address)));
        return new PlayerGripper(info, at.address, at.server, base, lift, beams, scheduler);
    }

    /// Makes a device for the next of a kind.
    private <D extends Device & Remote> D add(Kind kind, String name, BiFunction<DeviceInfo, Found, D> make)
            throws IOException {
        Found at = next(kind)
                .orElseThrow(() -> new IOException("Robot '%s' has no device for its '%s': %s."
                        .formatted(
                                spec.id(),
                                name,
                                seen.stream()
                                        .map(one -> "'%s' has %s".formatted(one.server.name(), one.offer.words()))
                                        .collect(Collectors.joining(", ")))));
        D device = connect(at, make.apply(new DeviceInfo(spec.id(), name, DRIVER), at));
        devices.add(device);
        return device;
    }

    /// Robots that share their servers have their devices of a kind one after the other; where there are fewer
    /// of what they may share, the last one.
    private Optional<Found> next(Kind kind) {
        int number = before.stream().mapToInt(kind::of).sum() + taken.merge(kind, 1, Integer::sum) - 1;
        List<Found> all = seen.stream()
                .flatMap(one -> kind.of(one.offer).stream().map(address -> new Found(one.server, address)))
                .toList();
        if (number < all.size()) {
            return Optional.of(all.get(number));
        }
        return kind.isShared() && !all.isEmpty() ? Optional.of(all.getLast()) : Optional.empty();
    }

    private <R extends Remote> R connect(Found at, R device) {
        remotes.add(device);
        connecting.add(at.server.add(device));
        return device;
    }

    /// The robot, once all of its devices are there.
    ///
    /// @return exceptionally when one of them does not start
    public CompletionStage<Robot> robot() {
        CompletionStage<Void> all = CompletableFuture.allOf(
                connecting.stream().map(CompletionStage::toCompletableFuture).toArray(CompletableFuture[]::new));
        return all.thenApply(_ -> new Robot(spec.id(), spec.role(), spec.model(), spec.marker(), devices));
    }

    /// The run has it from now on, and has said whether its motors are to be on.
    public void join() {
        base.join();
    }

    /// Whether this is it.
    public boolean is(Robot robot) {
        return spec.id().equals(robot.id());
    }

    /// Stops it, for good: first what drives its base, then that.
    public void end() {
        remotes.reversed().forEach(Remote::end);
    }
}
