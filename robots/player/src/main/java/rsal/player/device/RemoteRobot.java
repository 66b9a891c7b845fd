package rsal.player.device;

import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.stream.Collectors;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.Localizer;
import rsal.player.message.Interface;
import rsal.player.wire.Address;
import rsal.robot.Robot;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.time.Scheduler;

/// A robot whose devices Player servers have: for each part of its model the one that fits. All on the scheduler's
/// thread.
public final class RemoteRobot {
    private static final String DRIVER = "player";

    private final RobotSpec spec;
    private final List<Seen> seen;
    private final int index;
    private final Duration watchdog;
    private final Scheduler scheduler;
    private final Map<Kind, Integer> taken = new EnumMap<>(Kind.class);
    private final List<Device> devices = new ArrayList<>();
    private final List<CompletionStage<Void>> connecting = new ArrayList<>();
    private final PlayerBase base;

    /// A server with what it has.
    private record Seen(RemoteServer server, Offer offer) {}

    private record Found(RemoteServer server, Address address) {}

    /// Of what a robot can have several.
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
        PLANNER;

        /// All of a server, in their order: what is told of a scanner or of sonars as `ranger` goes before what is told
        /// of the same one otherwise.
        private List<Address> of(Offer offer) {
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
            };
        }
    }

    /// @param servers that are [known][RemoteServer#known]
    /// @param index which robot of these servers it is
    /// @param watchdog after which it stands when nothing more is commanded
    /// @param armed whether its motors are on from the beginning
    /// @throws IllegalStateException when these servers have no device for a part of its model
    public RemoteRobot(
            RobotSpec spec,
            List<RemoteServer> servers,
            int index,
            Duration watchdog,
            boolean armed,
            Scheduler scheduler) {
        this.spec = spec;
        this.index = index;
        this.watchdog = watchdog;
        this.scheduler = scheduler;
        this.seen =
                servers.stream().map(server -> new Seen(server, server.offer())).toList();
        Found drive = next(Kind.BASE, "base", 1);
        this.base = new PlayerBase(
                info("base"), drive.address, drive.server, spec.model().drive(), watchdog, armed, scheduler);
        add(drive.server, base);
        for (Map.Entry<String, Part> part : spec.model().sensors().entrySet()) {
            add(part.getKey(), part.getValue());
        }
    }

    /// Whether Player has something like a part.
    public static boolean has(Part part) {
        return !(part instanceof Part.Light);
    }

    private DeviceInfo info(String name) {
        return new DeviceInfo(spec.id(), name, DRIVER);
    }

    private void add(String name, Part part) {
        switch (part) {
            case Part.Laser laser -> {
                Found at = next(Kind.LASER, name, count(Part.Laser.class));
                add(at.server, new PlayerLaser(info(name), at.address, laser));
            }
            case Part.Sonars sonars -> {
                Found at = next(Kind.SONARS, name, count(Part.Sonars.class));
                add(at.server, new PlayerSonars(info(name), at.address, sonars));
            }
            case Part.Bumper bumper -> {
                Found at = next(Kind.BUMPER, name, count(Part.Bumper.class));
                add(at.server, new PlayerBumpers(info(name), at.address, bumper));
            }
            case Part.Battery _ -> {
                Found at = next(Kind.BATTERY, name, count(Part.Battery.class));
                add(at.server, new PlayerBattery(info(name), at.address));
            }
            case Part.BlobFinder camera -> {
                Found at = next(Kind.CAMERA, name, count(Part.BlobFinder.class));
                add(at.server, new PlayerCamera(info(name), at.address, camera));
            }
            case Part.FiducialFinder finder -> {
                Found at = next(Kind.MARKERS, name, count(Part.FiducialFinder.class));
                add(at.server, new PlayerMarkers(info(name), at.address, finder));
            }
            case Part.Gripper gripper -> add(name, gripper);
            case Part.Actuator actuator -> {
                Found at = next(Kind.JOINT, name, joints());
                add(at.server, new PlayerActuator(info(name), at.address, at.server, actuator, watchdog, scheduler));
            }
            case Part.Own own
            when own.makes().equals(Localizer.class) -> {
                Found at = next(Kind.LOCALIZER, name, 1);
                add(at.server, new PlayerLocalizer(info(name), at.address, at.server, base, scheduler));
            }
            case Part.Own _ -> {
                Found at = next(Kind.PLANNER, name, 1);
                add(at.server, new PlayerNavigator(info(name), at.address, at.server, scheduler));
            }
            case Part.Light _ -> throw new IllegalArgumentException("(%s) is refused before.".formatted(part.name()));
        }
    }

    /// With what the servers have of its lift and its beams.
    private void add(String name, Part.Gripper part) {
        Found at = next(Kind.GRIPPER, name, count(Part.Gripper.class));
        Optional<PlayerLift> lift = part.hasLift()
                ? find(Kind.JOINT, joints()).map(joint -> connect(joint, new PlayerLift(joint.address, joint.server)))
                : Optional.empty();
        Optional<PlayerBeams> beams = find(Kind.INPUTS, count(Part.Gripper.class))
                .map(inputs -> connect(inputs, new PlayerBeams(inputs.address)));
        add(at.server, new PlayerGripper(info(name), at.address, at.server, lift, beams, scheduler));
    }

    /// How many joints each robot has: its actuators, and the lifts of its grippers.
    private int joints() {
        return (int) spec.model().sensors().values().stream()
                .filter(part -> part instanceof Part.Actuator || (part instanceof Part.Gripper its && its.hasLift()))
                .count();
    }

    private int count(Class<? extends Part> type) {
        return (int) spec.model().sensors().values().stream()
                .filter(type::isInstance)
                .count();
    }

    /// The next of a kind: robots that share their servers have their devices one after the other.
    ///
    /// @param each how many of this kind each robot has
    private Found next(Kind kind, String name, int each) {
        return find(kind, each)
                .orElseThrow(() -> new IllegalStateException("Robot (%s) has no device for its (%s): %s."
                        .formatted(
                                spec.id(),
                                name,
                                seen.stream()
                                        .map(one -> "(%s) has %s".formatted(one.server.name(), one.offer.words()))
                                        .collect(Collectors.joining(", ")))));
    }

    private Optional<Found> find(Kind kind, int each) {
        int number = index * each + taken.merge(kind, 1, Integer::sum) - 1;
        return seen.stream()
                .flatMap(one -> kind.of(one.offer).stream().map(address -> new Found(one.server, address)))
                .skip(number)
                .findFirst();
    }

    private <R extends Remote> R connect(Found at, R device) {
        connecting.add(at.server.add(device));
        return device;
    }

    private <D extends Device & Remote> void add(RemoteServer server, D device) {
        devices.add(device);
        connecting.add(server.add(device));
    }

    /// The robot, once all of its devices are there.
    ///
    /// @return exceptionally when one of them does not start
    public CompletionStage<Robot> robot() {
        CompletionStage<Void> all = CompletableFuture.completedStage(null);
        for (CompletionStage<Void> one : connecting) {
            all = all.thenCombine(one, (_, _) -> null);
        }
        return all.thenApply(_ -> new Robot(spec.id(), spec.role(), spec.model(), spec.marker(), devices));
    }

    /// Stops it, for good.
    public void end() {
        base.end();
    }
}
