package rsal.recording;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import rsal.agent.bdi.Mind;
import rsal.data.Footprint;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Odometry;
import rsal.data.ParticleCloud;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Prism;
import rsal.data.RangeArray;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.data.Stamped;
import rsal.device.Health;
import rsal.device.SimulationControl.Carried;
import rsal.device.SimulationControl.Standing;
import rsal.engine.report.AgentView;
import rsal.engine.report.Answer;
import rsal.engine.report.DeviceView;
import rsal.engine.report.Link;
import rsal.engine.report.Reading;
import rsal.engine.report.RobotView;
import rsal.engine.report.RunEvent;
import rsal.engine.report.SentMessage;
import rsal.engine.report.Snapshot;
import rsal.engine.report.Teammate;
import rsal.mcap.ByteSink;
import rsal.recording.proto.MessageType;
import rsal.recording.proto.ProtoWriter;

/// Writes what is seen of a run as messages, each reading once. For one thread.
///
/// Longer than 500 lines, since it is a list: a method for each topic of a recording.
public final class Encoder {
    private static final long SECOND = 1_000_000_000;
    private static final String MAP = "map";

    private final MessageSink sink;
    private final long start; // of the run, on its own clock, in ns
    private final Map<String, Integer> channels = new HashMap<>(); // by topic
    private final Map<String, Object> last = new HashMap<>(); // what was written of a thing
    private final Map<String, String> frames = new HashMap<>(); // of bases, by robot
    private final Map<String, String> topics = new HashMap<>(); // by robot and device
    private final ContentWriter contents = new ContentWriter();
    private final Map<String, ContentWriter.Content> firstContents = new HashMap<>(); // by topic of agents
    private final ProtoWriter out = new ProtoWriter(new ByteSink(1 << 12));
    private List<Standing> things = List.of();
    private boolean thingsAgain;
    private int mates; // of the team that were told

    /// @param start of the run, on its own clock, in ns
    public Encoder(MessageSink sink, long start) {
        this.sink = sink;
        this.start = start;
    }

    /// Writes all once more, when it is seen next: for who has come late.
    public void writeAgain() {
        last.clear();
        thingsAgain = true;
        mates = 0;
    }

    /// The map that robots know, once.
    public void map(OccupancyGrid map) throws IOException {
        grid(map, start, MAP);
        write("/map", Foxglove.GRID, start, start, Map.of());
    }

    /// Opens the channels of events, before any has happened: for who wants to know of all that will.
    ///
    /// @return these channels
    public Set<Integer> openEvents() throws IOException {
        return Set.of(open(ChannelNames.EVENTS, Own.EVENT, Map.of()), open(ChannelNames.LOG, Foxglove.LOG, Map.of()));
    }

    public void event(RunEvent event, String hash) throws IOException {
        long time = time(event.time());
        out.clear();
        timestamp(1, time);
        out.varint(2, event.sequence());
        out.string(3, event.kind());
        out.string(4, event.subject());
        out.string(5, event.text());
        out.string(6, hash);
        event.said().ifPresent(said -> {
            int begun = out.begin(7);
            out.string(1, said.to());
            out.string(2, said.topic());
            out.string(3, said.conversation());
            out.string(4, said.protocol());
            out.string(5, said.act());
            out.end(begun);
        });
        write(ChannelNames.EVENTS, Own.EVENT, time, time, Map.of());

        out.clear();
        timestamp(1, time);
        out.varint(2, level(event.kind()));
        out.string(3, event.kind() + ": " + event.text());
        out.string(4, event.subject().isEmpty() ? "run" : event.subject());
        write(ChannelNames.LOG, Foxglove.LOG, time, time, Map.of());
    }

    private static int level(String kind) {
        return switch (kind) {
            case "fault" -> 4; // error
            case "collision", "health", "unreached" -> 3; // warning
            default -> 2; // info
        };
    }

    /// @param content what was said; its fields are written besides, when it is a record
    public void said(SentMessage said, Object content) throws IOException {
        long time = time(said.time());
        out.clear();
        timestamp(1, time);
        out.string(2, said.from());
        out.string(3, said.to());
        out.string(4, said.topic());
        out.string(5, said.conversation());
        out.string(6, said.protocol());
        out.string(7, said.act());
        out.string(8, said.words());
        write(ChannelNames.MESSAGES, Own.MESSAGE, time, time, Map.of());
        Optional<ContentWriter.Content> kind = contents.of(content.getClass());
        if (kind.isPresent()) {
            content(said, kind.get(), content, time);
        }
    }

    private void content(SentMessage said, ContentWriter.Content kind, Object content, long time) throws IOException {
        out.clear();
        timestamp(1, time);
        try {
            ContentWriter.write(out, kind, said.from(), said.to(), said.conversation(), content);
        } catch (RuntimeException _) { // its author's own code, which throws, or changes it meanwhile
            return;
        }
        // a topic may be of several kinds: acts of conversations, or records of one interface
        boolean isFirst = said.act().isEmpty() && kind == firstContents.computeIfAbsent(said.topic(), _ -> kind);
        String which = isFirst ? "" : kind.name();
        write(ChannelNames.content(said.topic(), which), kind.type(), time, time, Map.of());
    }

    public void minds(Duration at, Map<String, Mind.View> minds) throws IOException {
        long time = time(at);
        for (var mind : minds.entrySet()) {
            if (isNew(ChannelNames.about(ChannelNames.MINDS, mind.getKey()), mind.getValue())) {
                out.clear();
                timestamp(1, time);
                out.string(2, mind.getKey());
                pairs(3, mind.getValue().beliefs());
                for (Mind.GoalView goal : mind.getValue().goals()) {
                    int begun = out.begin(4);
                    out.string(1, goal.name());
                    out.string(2, goal.state().name());
                    out.number(3, goal.urgency());
                    goal.plans().forEach(plan -> out.string(4, plan));
                    goal.steps().forEach(step -> out.string(5, step));
                    out.string(6, goal.failure());
                    out.end(begun);
                }
                write(ChannelNames.MINDS, Own.MIND, time, time, Map.of());
            }
        }
    }

    public void state(Snapshot now, String hash) throws IOException {
        long time = time(now.time());
        team(now.team(), time);
        state(now, hash, time);
        transforms(now, time);
        things(now.things(), time);
        for (RobotView robot : now.robots()) {
            readings(robot, time);
        }
        for (AgentView agent : now.agents()) {
            agent(agent, time);
        }
        links(now.links(), time);
    }

    private void links(Answer.Linked reported, long time) throws IOException {
        if (!isNewOrGone(ChannelNames.LINKS, reported, Answer.Linked.NONE)) {
            return;
        }
        out.clear();
        timestamp(1, time);
        for (Link link : reported.links()) {
            int begun = out.begin(2);
            out.string(1, link.one());
            out.string(2, link.other());
            out.bool(3, link.there().open());
            out.bool(4, link.back().open());
            out.bool(5, link.there().used());
            out.bool(6, link.back().used());
            out.end(begun);
        }
        out.bool(3, reported.ofChosen());
        write(ChannelNames.LINKS, Own.LINKS, time, time, Map.of());
    }

    private void state(Snapshot now, String hash, long time) throws IOException {
        out.clear();
        timestamp(1, time);
        out.string(2, hash);
        out.bool(3, now.stopped());
        for (RobotView robot : now.robots()) {
            int begun = out.begin(4);
            robot(robot);
            out.end(begun);
        }
        write(ChannelNames.STATE, Own.STATE, time, time, Map.of());
    }

    private void robot(RobotView robot) {
        out.string(1, robot.id());
        out.bool(2, robot.gone());
        robot.truth().ifPresent(mapFromBase -> pose(3, mapFromBase));
        if (robot.odometry().isPresent()) {
            Odometry odometry = robot.odometry().get().value();
            pose(4, odometry.odomFromBase());
            out.number(5, odometry.velocity().vx());
            out.number(6, odometry.velocity().vy());
            out.number(7, odometry.velocity().omega());
            out.bool(8, odometry.stalled());
        }
        robot.estimate().ifPresent(estimate -> {
            int begun = out.begin(9);
            PoseEstimate belief = estimate.value();
            out.string(1, estimate.frame());
            pose(2, belief.mapFromBase());
            out.number(3, belief.covariance().xx());
            out.number(4, belief.covariance().xy());
            out.number(5, belief.covariance().yy());
            out.number(6, belief.covariance().thetaTheta());
            out.number(7, belief.confidence());
            out.string(8, belief.quality().name());
            Own.hypotheses(out, 9, belief);
            out.end(begun);
        });
        robot.goal().ifPresent(goal -> pose(10, goal));
        out.string(11, robot.inCharge());
        out.string(12, robot.behavior());
        out.string(13, robot.driver());
        robot.gripper().ifPresent(gripper -> {
            out.number(14, gripper.value().closed());
            out.bool(15, gripper.value().holding());
            out.bool(16, true);
        });
        out.bool(17, robot.lit());
        robot.real().flatMap(RobotView.Real::standIn).ifPresent(standIn -> pose(18, standIn));
        out.bool(19, robot.stopped());
        out.bool(26, robot.switchedOff());
        robot.goneFor().ifPresent(time -> out.number(27, time.toNanos() / 1e9));
        robot.real().ifPresent(real -> {
            out.bool(20, true);
            out.bool(21, real.proxy());
            real.silence().ifPresent(silence -> out.number(22, silence.toNanos() / 1e9));
        });
        lacks(robot.id(), ChannelNames.SCAN, robot.scan());
        lacks(robot.id(), ChannelNames.RANGES, robot.ranges());
        lacks(robot.id(), ChannelNames.PARTICLES, robot.particles());
        lacks(robot.id(), ChannelNames.MAP, robot.map());
        silentDevices(robot);
        robot.gripper().ifPresent(gripper -> out.number(24, gripper.value().raised()));
        for (Carried load : robot.carried()) {
            int begun = out.begin(25);
            pose(1, load.baseFromMoved());
            out.number(2, load.rise());
            out.numbers(3, load.pieces().stream().mapToDouble(piece -> piece).toArray());
            load.devices().forEach(device -> out.string(4, device));
            out.end(begun);
        }
    }

    /// What was there once, and is no more.
    private void lacks(String id, String what, Optional<?> reading) {
        if (reading.isEmpty() && last.containsKey(id + " " + what)) {
            out.string(23, what);
        }
    }

    private void silentDevices(RobotView robot) {
        if (robot.readings().size() < robot.devices().size()) {
            Set<String> publishing =
                    robot.readings().stream().map(Reading::device).collect(Collectors.toSet());
            robot.devices().stream()
                    .map(DeviceView::name)
                    .filter(device -> !publishing.contains(device))
                    .forEach(device -> lacks(robot.id(), ChannelNames.DEVICE + device, Optional.empty()));
        }
    }

    /// Where bases are, as Foxglove wants to know it: in truth where that is known.
    private void transforms(Snapshot now, long time) throws IOException {
        out.clear();
        for (RobotView robot : now.robots()) {
            Optional<Pose2d> mapFromBase = robot.truth()
                    .or(() -> robot.estimate().map(estimate -> estimate.value().mapFromBase()))
                    .or(() -> robot.real().flatMap(RobotView.Real::standIn));
            if (mapFromBase.isPresent()) {
                int begun = out.begin(1);
                timestamp(1, time);
                out.string(2, MAP);
                out.string(3, frame(robot.id()));
                vector(4, mapFromBase.get().x(), mapFromBase.get().y(), 0);
                quaternion(5, mapFromBase.get().theta());
                out.end(begun);
            }
        }
        write("/tf", Foxglove.FRAME_TRANSFORMS, time, time, Map.of());
    }

    /// Each reading once, by its time.
    private void readings(RobotView robot, long time) throws IOException {
        String id = robot.id();
        if (robot.scan().isPresent() && isNew(id + " scan", robot.scan().get().time())) {
            publish(id, ChannelNames.of(id, ChannelNames.SCAN), robot.scan().get(), time);
        }
        if (robot.ranges().isPresent()
                && isNew(id + " ranges", robot.ranges().get().time())) {
            publish(id, ChannelNames.of(id, ChannelNames.RANGES), robot.ranges().get(), time);
        }
        if (robot.estimate().isPresent()
                && isNew(id + " estimate", robot.estimate().get().time())) {
            Stamped<PoseEstimate> estimate = robot.estimate().get();
            out.clear();
            timestamp(1, nanos(estimate.time()));
            out.string(2, estimate.frame());
            foxglovePose(3, estimate.value().mapFromBase());
            write(
                    ChannelNames.of(id, ChannelNames.ESTIMATE),
                    Foxglove.POSE_IN_FRAME,
                    time,
                    nanos(estimate.time()),
                    Map.of());
        }
        if (robot.particles().isPresent()
                && isNew(id + " particles", robot.particles().get().time())) {
            particles(id, robot.particles().get(), time);
        }
        if (robot.map().isPresent() && isNew(id + " map", robot.map().get().time())) {
            Stamped<OccupancyGrid> map = robot.map().get();
            grid(map.value(), nanos(map.time()), map.frame());
            write(ChannelNames.of(id, ChannelNames.MAP), Foxglove.GRID, time, nanos(map.time()), Map.of());
        }
        if (isNew(id + " path", robot.path())) {
            path(id, ChannelNames.PATH, robot.path(), robot.color(), time);
        }
        if (isNewOrGone(id + " local path", robot.localPath(), Path2d.EMPTY)) {
            path(id, ChannelNames.LOCAL_PATH, robot.localPath(), robot.color(), time);
        }
        boolean moved = false;
        for (Reading reading : robot.readings()) {
            String topic = topic(robot, reading);
            moved |= !topic.equals(topics.put(id + " " + reading.device(), topic));
            String own = ChannelNames.DEVICE + reading.device();
            if (topic.equals(ChannelNames.of(id, own))
                    && isNew(id + " " + own, reading.value().time())) {
                publish(id, topic, reading.value(), time);
            }
        }
        if (isNew(id + " devices", robot.devices()) || moved) {
            for (DeviceView device : robot.devices()) {
                String topic = topics.getOrDefault(id + " " + device.name(), "");
                if (isNew(id + " view of " + device.name(), List.of(device, topic))) {
                    device(id, device, topic, time);
                }
            }
        }
    }

    /// Where what a device tells is written; empty when it is not.
    private static String topic(RobotView robot, Reading reading) {
        String id = robot.id();
        Stamped<?> reported = reading.value();
        if (is(robot.odometry(), reported)) {
            return ChannelNames.STATE;
        } else if (is(robot.scan(), reported)) {
            return ChannelNames.of(id, ChannelNames.SCAN);
        } else if (is(robot.ranges(), reported)) {
            return ChannelNames.of(id, ChannelNames.RANGES);
        } else if (is(robot.estimate(), reported)) {
            return ChannelNames.of(id, ChannelNames.ESTIMATE);
        } else if (is(robot.map(), reported)) {
            return ChannelNames.of(id, ChannelNames.MAP);
        }
        boolean says = !(recorded(reported.value()) instanceof Quantities(var numbers)) || !numbers.isEmpty();
        return says ? ChannelNames.of(id, ChannelNames.DEVICE + reading.device()) : "";
    }

    private static boolean is(Optional<? extends Stamped<?>> one, Stamped<?> reported) {
        return one.isPresent() && one.get().equals(reported);
    }

    /// As it is recorded: of a kind that nobody thought of here, the numbers in it.
    private static Object recorded(Object reported) {
        return ReadingType.of(reported).isPresent() ? reported : Quantities.of(reported);
    }

    private void publish(String id, String topic, Stamped<?> reported, long time) throws IOException {
        Object value = recorded(reported.value());
        ReadingType<?> type = ReadingType.of(value).orElseThrow();
        long taken = nanos(reported.time());
        boolean mounted = value instanceof LaserScan || value instanceof RangeArray; // poses say where on the base
        out.clear();
        timestamp(1, taken);
        out.string(2, mounted ? frame(id) : reported.frame());
        type.write(out, value);
        boolean first = !channels.containsKey(topic);
        write(
                topic,
                type.message(),
                time,
                taken,
                first && value instanceof LaserScan laser ? ReadingType.limits(laser) : Map.of());
    }

    private void particles(String id, Stamped<ParticleCloud> particles, long time) throws IOException {
        ParticleCloud cloud = particles.value();
        long taken = nanos(particles.time());
        var data = new ByteSink(16 * cloud.count());
        for (int i = 0; i < cloud.count(); i++) {
            for (int j = 0; j < 3; j++) {
                data.u32(Float.floatToRawIntBits(cloud.poses()[3 * i + j]));
            }
            data.u32(Float.floatToRawIntBits(cloud.weights()[i]));
        }
        out.clear();
        timestamp(1, taken);
        out.string(2, particles.frame());
        foxglovePose(3, Pose2d.ORIGIN);
        out.fixed32(4, 16);
        Foxglove.field(out, 5, "x", 0, 7);
        Foxglove.field(out, 5, "y", 4, 7);
        Foxglove.field(out, 5, "heading", 8, 7);
        Foxglove.field(out, 5, "weight", 12, 7);
        out.bytes(6, data.toArray());
        write(ChannelNames.of(id, ChannelNames.PARTICLES), Foxglove.POINT_CLOUD, time, taken, Map.of());
    }

    private void grid(OccupancyGrid map, long time, String frame) {
        out.clear();
        timestamp(1, time);
        out.string(2, frame);
        Foxglove.grid(out, map);
    }

    /// A line through its points; without any, the one before is taken away.
    private void path(String id, String what, Path2d path, String color, long time) throws IOException {
        out.clear();
        int entity = path.points().isEmpty() ? out.begin(1) : out.begin(2);
        if (path.points().isEmpty()) {
            timestamp(1, time);
            out.string(3, what);
        } else {
            timestamp(1, time);
            out.string(2, MAP);
            out.string(3, what);
            int line = out.begin(11);
            out.number(3, 0.04);
            path.points().forEach(point -> vector(5, point.x(), point.y(), 0.02));
            color(6, color);
            out.end(line);
        }
        out.end(entity);
        write(ChannelNames.of(id, what), Foxglove.SCENE_UPDATE, time, time, Map.of());
    }

    private void device(String id, DeviceView device, String topic, long time) throws IOException {
        out.clear();
        timestamp(1, time);
        out.string(2, id);
        out.string(3, device.name());
        out.string(4, device.driver());
        out.string(5, device.type());
        out.string(
                6,
                switch (device.health()) {
                    case Health.Ok _ -> "OK";
                    case Health.Stale _ -> "STALE";
                    case Health.Lost _ -> "LOST";
                });
        out.string(
                7,
                switch (device.health()) {
                    case Health.Ok _ -> "";
                    case Health.Stale stale -> stale.reason();
                    case Health.Lost lost -> lost.reason();
                });
        out.string(8, topic);
        write(ChannelNames.DEVICES, Own.DEVICE, time, time, Map.of());
    }

    private void agent(AgentView agent, long time) throws IOException {
        var view = agent.view();
        var reported = List.of(view.status(), view.state(), view.beliefs());
        if (!isNew(ChannelNames.about(ChannelNames.AGENTS, view.agent().name()), reported)) {
            return;
        }
        out.clear();
        timestamp(1, time);
        out.string(2, view.agent().name());
        out.string(3, view.agent().role());
        out.string(4, view.agent().type());
        out.string(5, view.agent().robot());
        out.string(6, view.status().name());
        out.string(7, view.state());
        pairs(8, view.beliefs());
        write(ChannelNames.AGENTS, Own.AGENT, time, time, Map.of());
    }

    /// Robots that have come, and what they look like.
    private void team(List<Teammate> team, long time) throws IOException {
        for (Teammate mate : team.subList(Math.min(mates, team.size()), team.size())) {
            var spec = mate.spec();
            out.clear();
            timestamp(1, time);
            out.string(2, spec.id());
            out.string(3, spec.role());
            out.string(4, spec.color());
            out.string(5, spec.model().name());
            write(ChannelNames.ROBOTS, Own.ROBOT, time, time, Map.of());

            out.clear();
            int entity = out.begin(2);
            timestamp(1, time);
            out.string(2, frame(spec.id()));
            out.string(3, "robot " + spec.id());
            out.bool(5, true); // moves with its frame
            Solid body = mate.body().orElse(spec.model().body());
            for (Prism piece : body.pieces()) {
                piece(piece, piece.color().map(Object::toString).orElse(spec.color()), Pose2d.ORIGIN, 0);
            }
            out.end(entity);
            write("/world", Foxglove.SCENE_UPDATE, time, time, Map.of());
        }
        mates = team.size();
    }

    /// Things that have come, moved or gone.
    private void things(List<Standing> now, long time) throws IOException {
        if (now.equals(things) && !thingsAgain) {
            return;
        }
        var before = new HashMap<Integer, Standing>();
        things.forEach(thing -> before.put(thing.number(), thing));
        for (Standing thing : now) {
            if (thing.equals(before.remove(thing.number())) && !thingsAgain) {
                continue;
            }
            thing(thing, time);
            out.clear();
            int entity = out.begin(2);
            timestamp(1, time);
            out.string(2, MAP);
            out.string(3, "thing " + thing.number());
            int name = out.begin(6);
            out.string(1, "name");
            out.string(2, thing.name());
            out.end(name);
            for (Prism piece : thing.body().pieces()) {
                piece(
                        piece,
                        piece.color().map(Object::toString).orElse("#888888"),
                        thing.mapFromThing(),
                        thing.height());
            }
            out.end(entity);
            write("/world", Foxglove.SCENE_UPDATE, time, time, Map.of());
        }
        for (Integer gone : before.keySet()) {
            out.clear();
            int deletion = out.begin(1);
            timestamp(1, time);
            out.string(3, "thing " + gone);
            out.end(deletion);
            write("/world", Foxglove.SCENE_UPDATE, time, time, Map.of());

            out.clear();
            timestamp(1, time);
            out.varint(2, gone);
            out.bool(6, true);
            write(ChannelNames.THINGS, Own.THING, time, time, Map.of());
        }
        things = now;
        thingsAgain = false;
    }

    /// As it is, which scenes only show.
    private void thing(Standing thing, long time) throws IOException {
        out.clear();
        timestamp(1, time);
        out.varint(2, thing.number());
        out.string(3, thing.name());
        pose(4, thing.mapFromThing());
        out.number(5, thing.height());
        for (Prism piece : thing.body().pieces()) {
            int begun = out.begin(7);
            piece.color().ifPresent(color -> out.string(1, color.toString()));
            out.number(2, piece.bottom());
            out.number(3, piece.top());
            switch (piece.shape()) {
                case Shape.Disc disc -> {
                    out.number(4, disc.radius());
                    out.numbers(5, disc.center().x(), disc.center().y());
                }
                case Shape.Polygon polygon ->
                    out.numbers(
                            5,
                            polygon.corners().stream()
                                    .flatMapToDouble(corner -> DoubleStream.of(corner.x(), corner.y()))
                                    .toArray());
            }
            out.end(begun);
        }
        out.bool(8, thing.grippable());
        write(ChannelNames.THINGS, Own.THING, time, time, Map.of());
    }

    /// A piece of a body as its convex outline has it: sides and top.
    private void piece(Prism piece, String color, Pose2d frameFromBody, double height) {
        Footprint hull = piece.shape().hull();
        List<Point2d> corners = hull.corners();
        double bottom = height + piece.bottom();
        double top = height + piece.top();
        int begun = out.begin(12);
        foxglovePose(1, frameFromBody);
        for (int i = 0; i < corners.size(); i++) {
            Point2d a = corners.get(i);
            Point2d b = corners.get((i + 1) % corners.size());
            vector(2, a.x(), a.y(), bottom);
            vector(2, b.x(), b.y(), bottom);
            vector(2, b.x(), b.y(), top);
            vector(2, a.x(), a.y(), bottom);
            vector(2, b.x(), b.y(), top);
            vector(2, a.x(), a.y(), top);
            if (i > 0 && i + 1 < corners.size()) {
                vector(2, corners.getFirst().x(), corners.getFirst().y(), top);
                vector(2, a.x(), a.y(), top);
                vector(2, b.x(), b.y(), top);
            }
        }
        color(3, color);
        out.end(begun);
    }

    private void pairs(int field, Map<String, String> pairs) {
        pairs.forEach((key, value) -> {
            int begun = out.begin(field);
            out.string(1, key);
            out.string(2, value);
            out.end(begun);
        });
    }

    private void pose(int field, Pose2d pose) {
        Own.pose(out, field, pose);
    }

    private void foxglovePose(int field, Pose2d pose) {
        Foxglove.pose(out, field, pose);
    }

    private void vector(int field, double x, double y, double z) {
        Foxglove.vector(out, field, x, y, z);
    }

    private void quaternion(int field, double heading) {
        Foxglove.quaternion(out, field, heading);
    }

    /// @param color `#rrggbb`
    private void color(int field, String color) {
        int rgb = Integer.parseInt(color.substring(1), 16);
        int begun = out.begin(field);
        out.number(1, (rgb >> 16 & 0xff) / 255.0);
        out.number(2, (rgb >> 8 & 0xff) / 255.0);
        out.number(3, (rgb & 0xff) / 255.0);
        out.number(4, 1);
        out.end(begun);
    }

    private void timestamp(int field, long nanos) {
        int begun = out.begin(field);
        out.varint(1, Math.floorDiv(nanos, SECOND));
        out.varint(2, Math.floorMod(nanos, SECOND));
        out.end(begun);
    }

    private String frame(String robot) {
        return frames.computeIfAbsent(robot, id -> id + "/base_link");
    }

    private boolean isNew(String what, Object value) {
        return !value.equals(last.put(what, value));
    }

    /// The same, but that there is nothing is new only where there was something.
    private boolean isNewOrGone(String what, Object value, Object nothing) {
        return (!value.equals(nothing) || last.containsKey(what)) && isNew(what, value);
    }

    private long time(Duration elapsed) {
        return start + elapsed.toNanos();
    }

    private static long nanos(Instant time) {
        return time.getEpochSecond() * SECOND + time.getNano();
    }

    /// Writes the message that is in the sink.
    private void write(String topic, MessageType type, long time, long taken, Map<String, String> about)
            throws IOException {
        sink.message(open(topic, type, about), time, taken, out.sink().written());
    }

    private int open(String topic, MessageType type, Map<String, String> about) throws IOException {
        Integer channel = channels.get(topic);
        if (channel == null) {
            channel = sink.open(topic, type.name(), type.descriptors(), about);
            channels.put(topic, channel);
        }
        return channel;
    }
}
