package rsal.ros2.simulation;

import static java.util.concurrent.CompletableFuture.completedStage;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Placement;
import rsal.device.SimulationControl.Standing;
import rsal.robot.Robot;
import rsal.ros2.action.Services;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.RosNetwork;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.settings.Suggestion;
import rsal.system.RunControl;
import rsal.system.RunControl.Spawnable;
import rsal.time.Scheduler;

/// What of `simulation_interfaces` is about single entities, in both of its versions: robots and things are
/// listed, read, placed, spawned and deleted. Entities are in the plane; heights and tilts of poses are
/// passed over.
final class EntityServices {
    private static final String PACKAGE = "simulation_interfaces/srv/";
    private static final String SPAWNABLES = PACKAGE + "GetSpawnables";
    private static final String SCHEME = "rsal:"; // of what can be spawned
    private static final List<String> FRAMES = List.of("", "map", "world"); // all are the map's
    private static final String NAME = "[A-Za-z][A-Za-z0-9_-]{0,63}";
    private static final int OBJECT = 0; // categories
    private static final int ROBOT = 1;
    private static final int INVALID_POSE = 101; // of SetEntityState; the others are of SpawnEntity
    private static final int NAME_NOT_UNIQUE = 101;
    private static final int NAME_INVALID = 102;
    private static final int UNSUPPORTED_FORMAT = 103;
    private static final int NO_RESOURCE = 104;
    private static final int NAMESPACE_INVALID = 105;
    private static final int INVALID_SPAWN_POSE = 109;

    /// Hash of responses that have what version 2 of the package added.
    private static final Optional<String> NEW_SPAWNABLES =
            TypeLibrary.of(Distribution.LYRICAL).hash(SPAWNABLES + "_Response");

    private final SimulationControl world;
    private final RunControl control;
    private final TruthTracker truth;
    private final Function<String, Optional<Robot>> robots;
    private final Scheduler scheduler;

    /// What is to be changed of an entity.
    private record StateOrder(String entity, RosMessage state, boolean pose, boolean velocity, boolean acceleration) {}

    /// @param robots by id
    EntityServices(
            SimulationControl world,
            RunControl control,
            TruthTracker truth,
            Function<String, Optional<Robot>> robots,
            Scheduler scheduler) {
        this.world = world;
        this.control = control;
        this.truth = truth;
        this.robots = robots;
        this.scheduler = scheduler;
    }

    /// @param prefix of names: `/rsal/`
    void serve(Services services, String prefix) {
        services.serve(prefix + "get_entities", PACKAGE + "GetEntities", this::list);
        services.serve(prefix + "get_entities_states", PACKAGE + "GetEntitiesStates", this::listStates);
        services.serve(prefix + "get_entity_state", PACKAGE + "GetEntityState", this::state);
        services.serve(prefix + "get_entity_info", PACKAGE + "GetEntityInfo", this::info);
        MessageCodec order = services.codec(PACKAGE + "SetEntityState");
        services.serve(
                prefix + "set_entity_state",
                PACKAGE + "SetEntityState",
                bytes -> order(order, bytes),
                (wanted, _) -> completedStage(place(wanted).toBytes()));
        MessageCodec sources = services.codec(SPAWNABLES);
        services.serve(
                prefix + "get_spawnables",
                SPAWNABLES,
                sources::read,
                (request, hash) -> completedStage(spawnables(request, hash)));
        services.serve(prefix + "spawn_entity", PACKAGE + "SpawnEntity", this::spawn);
        services.serve(prefix + "delete_entity", PACKAGE + "DeleteEntity", this::delete);
    }

    private static void texts(CdrWriter to, List<String> texts) {
        to.int32(texts.size());
        texts.forEach(to::text);
    }

    /// @param withStates also where each is
    private byte[] list(RosMessage request, boolean withStates) {
        var response = new CdrWriter();
        EntityFilter.Read read = EntityFilter.of(request.message("filters"));
        List<String> chosen = List.of();
        ResultCode result = ResultCode.OK;
        switch (read) {
            case EntityFilter.Read.Refused(ResultCode why) -> result = why;
            case EntityFilter.Read.Filter(EntityFilter filter) -> {
                List<String> all = world.entities();
                int[] categories = all.stream().mapToInt(this::category).toArray();
                Optional<List<String>> matching = filter.matching(all, categories);
                chosen = matching.orElse(List.of());
                result = matching.isPresent()
                        ? ResultCode.OK
                        : ResultCode.failed("The filter takes too long. Write a simpler expression.");
            }
        }
        result.write(response);
        texts(response, chosen);
        if (withStates) {
            response.int32(chosen.size());
            chosen.forEach(entity -> writeState(response, entity));
        }
        return response.toBytes();
    }

    private byte[] list(RosMessage request) {
        return list(request, false);
    }

    private byte[] listStates(RosMessage request) {
        return list(request, true);
    }

    private int category(String entity) {
        return robots.apply(entity).isPresent() ? ROBOT : OBJECT;
    }

    /// `simulation_interfaces/EntityState`; of one that is nowhere, zeros.
    private void writeState(CdrWriter to, String entity) {
        Twist2d velocity = truth.velocity(entity);
        RosMessages.write(to, scheduler.instant()).text("map");
        RosMessages.write(to, FrameTransform.of(truth.pose(entity).orElse(Pose2d.ORIGIN)));
        to.float64(velocity.vx()).float64(velocity.vy()).float64(0);
        to.float64(0).float64(0).float64(velocity.omega());
        to.float64s(new double[6]); // accelerations, which nobody knows
    }

    private ResultCode found(String entity) {
        return truth.pose(entity).isPresent()
                ? ResultCode.OK
                : ResultCode.notFound(
                        "There is no entity '%s'. %s".formatted(entity, Suggestion.among(entity, world.entities())));
    }

    private byte[] state(RosMessage request) {
        String entity = request.text("entity");
        CdrWriter response = found(entity).write(new CdrWriter());
        writeState(response, entity);
        return response.toBytes();
    }

    private byte[] info(RosMessage request) {
        String entity = request.text("entity");
        CdrWriter response = found(entity).write(new CdrWriter());
        response.int8((byte) category(entity)).text(description(entity)).int32(0); // no tags
        return response.toBytes();
    }

    private String description(String entity) {
        return robots.apply(entity)
                .map(robot -> "A robot: %s, with the role '%s'."
                        .formatted(robot.model().title(), robot.role()))
                .orElseGet(() -> world.things().stream()
                        .filter(thing -> thing.name().equals(entity))
                        .findFirst()
                        .map(EntityServices::description)
                        .orElse(""));
    }

    private static String description(Standing thing) {
        return thing.grippable() ? "A thing that grippers can hold." : "A thing.";
    }

    /// The second version of the package says at the end what is to be set. The first, which sets all, ends
    /// in numbers of 8 bytes, so that nothing follows to fill up.
    private static StateOrder order(MessageCodec codec, CdrReader bytes) throws InvalidCdr {
        RosMessage request = codec.read(bytes);
        boolean isAll = bytes.isAtEnd(1);
        boolean pose = isAll || bytes.bool();
        boolean velocity = isAll || bytes.bool();
        boolean acceleration = isAll || bytes.bool();
        return new StateOrder(request.text("entity"), request.message("state"), pose, velocity, acceleration);
    }

    private ResultCode place(StateOrder order) {
        ResultCode found = found(order.entity);
        if (!found.equals(ResultCode.OK)) {
            return found;
        }
        boolean isMoving = (order.velocity && !isZero(order.state.message("twist")))
                || (order.acceleration && !isZero(order.state.message("acceleration")));
        if (isMoving) {
            return ResultCode.unsupported("Entities are placed at rest. Leave velocities and accelerations at 0.");
        }
        if (!order.pose) {
            return ResultCode.OK;
        }
        String frame = order.state.message("header").text("frame_id");
        Optional<Pose2d> pose = pose(order.state.message("pose"), frame);
        if (pose.isEmpty()) {
            return new ResultCode(INVALID_POSE, badPose(frame));
        }
        ResultCode placed = ResultCode.of(control.place(order.entity, pose.get()));
        truth.moved(order.entity);
        return placed;
    }

    private static boolean isZero(RosMessage motion) {
        return Stream.of("linear", "angular")
                .map(motion::message)
                .allMatch(part -> part.number("x") == 0 && part.number("y") == 0 && part.number("z") == 0);
    }

    private static Optional<Pose2d> pose(RosMessage pose, String frame) {
        FrameTransform read = FrameTransform.of(pose, "position", "orientation");
        return FRAMES.contains(frame) && read.isFinite() ? Optional.of(read.planar()) : Optional.empty();
    }

    private static String badPose(String frame) {
        return FRAMES.contains(frame)
                ? "A pose must have finite numbers."
                : "Poses must be in the frame 'map', not '%s'.".formatted(frame);
    }

    private byte[] spawnables(RosMessage request, Supplier<Optional<String>> hash) {
        boolean isNew = hash.get().equals(NEW_SPAWNABLES);
        boolean isKnown = request.get("sources", List.class).isEmpty();
        ResultCode result = isKnown
                ? ResultCode.OK
                : ResultCode.unsupported("Spawnables come with RSAL only. Leave 'sources' empty.");
        List<Spawnable> all = isKnown ? control.spawnables() : List.of();
        CdrWriter response = result.write(new CdrWriter()).int32(all.size());
        for (Spawnable each : all) {
            response.text(SCHEME + each.name());
            if (isNew) {
                response.text(""); // resource_string
            }
            response.text(each.description()).int8((byte) 0).int32(0); // no bounds
        }
        return response.toBytes();
    }

    /// Either version: a resource has the same bytes as its two fields had before.
    private byte[] spawn(RosMessage request) {
        String kind = request.text("uri");
        String wanted = request.text("name");
        boolean mayRename = request.get("allow_renaming", Boolean.class);
        String name = mayRename ? free(wanted.isEmpty() ? kind.substring(kind.indexOf(':') + 1) : wanted) : wanted;
        RosMessage stamped = request.message("initial_pose");
        String frame = stamped.message("header").text("frame_id");
        Optional<Pose2d> pose = pose(stamped.message("pose"), frame);
        ResultCode result = refusal(kind, request.text("resource_string"), name, request.text("entity_namespace"))
                .orElseGet(() -> pose.map(there -> ResultCode.of(spawn(kind, name, there)))
                        .orElseGet(() -> new ResultCode(INVALID_SPAWN_POSE, badPose(frame))));
        return result.write(new CdrWriter())
                .text(result.equals(ResultCode.OK) ? name : "")
                .toBytes();
    }

    private Placement spawn(String uri, String name, Pose2d mapFromEntity) {
        return control.spawn(uri.substring(SCHEME.length()), name, mapFromEntity);
    }

    /// A name like one, that nothing has.
    private String free(String name) {
        int most = world.entities().size() + 1_000; // more names than were ever taken
        return isFree(name)
                ? name
                : IntStream.rangeClosed(2, most)
                        .mapToObj(number -> name + "_" + number)
                        .filter(this::isFree)
                        .findFirst()
                        .orElse(name);
    }

    /// Robots need a namespace of their own, too.
    private boolean isFree(String name) {
        return !name.matches(NAME)
                || (control.isFree(name)
                        && world.entities().stream()
                                .noneMatch(each -> RosNetwork.namespace(each).equals(RosNetwork.namespace(name))));
    }

    private Optional<ResultCode> refusal(String uri, String text, String name, String namespace) {
        if (uri.isEmpty()) {
            return Optional.of(
                    text.isEmpty()
                            ? new ResultCode(NO_RESOURCE, "Nothing is to be spawned: 'uri' is empty.")
                            : ResultCode.unsupported("Descriptions can't be spawned. Use a 'uri' of GetSpawnables."));
        }
        Map<String, Spawnable> kinds =
                control.spawnables().stream().collect(Collectors.toMap(kind -> SCHEME + kind.name(), kind -> kind));
        if (!uri.startsWith(SCHEME)) {
            return Optional.of(new ResultCode(
                    UNSUPPORTED_FORMAT,
                    "'%s' can't be spawned. %s".formatted(uri, Suggestion.among(uri, kinds.keySet()))));
        }
        if (!kinds.containsKey(uri)) {
            return Optional.of(
                    ResultCode.notFound("There is no '%s'. %s".formatted(uri, Suggestion.among(uri, kinds.keySet()))));
        }
        if (!name.matches(NAME)) {
            return Optional.of(new ResultCode(
                    NAME_INVALID,
                    "'%s' is not a name: it has 1 to 64 letters, digits, '_' or '-', and begins with a letter."
                            .formatted(name)));
        }
        if (!isFree(name)) {
            return Optional.of(
                    new ResultCode(NAME_NOT_UNIQUE, "'%s' is taken, or a robot was called so before.".formatted(name)));
        }
        String own = RosNetwork.namespace(name);
        boolean isOwn =
                namespace.isEmpty() || ("/" + namespace).replace("//", "/").equals(own);
        return isOwn
                ? Optional.empty()
                : Optional.of(new ResultCode(
                        NAMESPACE_INVALID,
                        "'%s' gets the namespace '%s'. Leave 'entity_namespace' empty.".formatted(name, own)));
    }

    private byte[] delete(RosMessage request) {
        String entity = request.text("entity");
        ResultCode found = found(entity);
        return (found.equals(ResultCode.OK) ? ResultCode.of(control.remove(entity)) : found).toBytes();
    }
}
