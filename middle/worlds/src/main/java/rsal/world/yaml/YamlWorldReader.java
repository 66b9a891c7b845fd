package rsal.world.yaml;

import java.math.BigDecimal;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.scene.Entity;
import rsal.scene.NamedSeed;
import rsal.scene.Scene;
import rsal.scene.Touch;
import rsal.settings.FileSource;
import rsal.settings.FormatVersion;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Parameter;
import rsal.settings.Problem;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Value;
import rsal.world.MapPainter;
import rsal.world.Overlaps;
import rsal.world.Overlaps.Overlap;
import rsal.world.yaml.CrewReader.Member;

/// Reads a world: first all that has a place, then fields of obstacles, then robots that stand anywhere.
final class YamlWorldReader {
    private static final String PROGRAM = "wander";
    private static final int MOST_WARNINGS = 500;
    private static final double TURNING = 0.05; // around a robot that may turn in place [m]

    private final String path;
    private final Section root;
    private final FileSource files;
    private final long seed;
    private final Problems problems;
    private final List<Problem> warnings = new ArrayList<>();

    /// @param files beside the world
    /// @param seed for what is left to chance
    YamlWorldReader(String path, Value.Mapping root, FileSource files, long seed, Problems problems) {
        this.path = path;
        this.root = new Section("", root, problems);
        this.files = files;
        this.seed = seed;
        this.problems = problems;
    }

    /// @throws InvalidSettings with its errors
    Scene scene() {
        FormatVersion.check(root, "world", Keys.VERSION);
        String title = root.text("title", "");
        root.text("description", "");
        Optional<Duration> step = time(Keys.STEP);
        Optional<Duration> end = time(Keys.END);
        Touch touch = root.value(Keys.ON_COLLISION).flatMap(Touch::of).orElse(Touch.STALL);
        double[] area = FloorPlace.area(root, "area").orElse(null);
        var names = new Names(problems);
        var walls = new WallReader(files, names);
        walls.read(root);
        var things = new ThingReader(names);
        things.read(root.section("things"));
        var fields = new FieldReader(names);
        fields.read(root.section("fields"));
        var crew = new CrewReader(files, names, problems);
        crew.read(root.section("parts"), root.section("models"), root.section("robots"));
        root.done();
        crew.members().forEach(this::warn);
        problems.throwIfAny();
        try {
            return new Assembly(title, step, end, touch, area, walls, things, crew.members()).scene(fields);
        } catch (MapPainter.TooLarge e) {
            throw new InvalidSettings(Location.of(path), String.valueOf(e.getMessage()), "Maybe a 'pose' is wrong.");
        }
    }

    /// Robots of worlds that are converted may have such.
    private void warn(Member member) {
        if (member.program().filter(program -> !program.equals(PROGRAM)).isPresent()) {
            warn(
                    member.location(),
                    "There is no program '%s' here; the robot wanders instead."
                            .formatted(member.program().get()),
                    "{program: %s}".formatted(PROGRAM));
        }
        member.model().sensors().forEach((name, part) -> {
            if (part instanceof Part.Bumper bumper && bumper.pads().isEmpty()) {
                warn(
                        member.location(),
                        "Bumper '%s' of the model '%s' feels nothing: it has no 'bumpers'."
                                .formatted(name, member.model().name()),
                        "{bumpers: [[0.25, 0, 0, 0.4]]}");
            }
        });
    }

    private void warn(Location location, String message, String remedy) {
        if (problems.warnings().size() < MOST_WARNINGS) {
            problems.warn(new Problem(location, message, remedy));
        }
    }

    private Optional<Duration> time(Parameter<?> parameter) {
        return root.has(parameter.name())
                ? Optional.of(Keys.number(root, parameter))
                        .map(seconds -> Duration.ofNanos(
                                BigDecimal.valueOf(seconds).movePointRight(9).longValue()))
                : Optional.empty();
    }

    /// Puts together what was read.
    private final class Assembly {
        private final String title;
        private final Optional<Duration> step;
        private final Optional<Duration> end;
        private final Touch touch;
        private final double @Nullable [] area;
        private final WallReader walls;
        private final ThingReader read;
        private final List<Member> members;
        private final List<Entity> things = new ArrayList<>();
        private final List<Entity> fixed = new ArrayList<>(); // things that the map shows
        private final Map<String, FloorPlace> places = new HashMap<>();
        private final TreeMap<String, Integer> contents = new TreeMap<>();

        Assembly(
                String title,
                Optional<Duration> step,
                Optional<Duration> end,
                Touch touch,
                double @Nullable [] area,
                WallReader walls,
                ThingReader read,
                List<Member> members) {
            this.title = title;
            this.step = step;
            this.end = end;
            this.touch = touch;
            this.area = area;
            this.walls = walls;
            this.read = read;
            this.members = members;
            things.addAll(walls.bodies());
            things.addAll(read.things());
            fixed.addAll(walls.bodies());
            fixed.addAll(read.fixed());
            members.forEach(member -> member.place().ifPresent(place -> places.put(member.id(), place)));
            count("wall", walls.number());
            count("thing", read.things().size());
        }

        private void count(String what, int number) {
            if (number > 0) {
                contents.merge(what, number, Integer::sum);
            }
        }

        Scene scene(FieldReader fields) {
            boolean searching = places.size() < members.size();
            if (searching || !fields.isEmpty()) {
                OccupancyGrid before = map();
                var room = new Room(before);
                read.moving().forEach(thing -> room.add(thing, false));
                members.stream().filter(this::placed).forEach(member -> room.add(body(member), true));
                List<Entity> grown = fields.grow(before, room, seed, warnings);
                grown.forEach(obstacle -> count(FieldReader.fieldOf(obstacle), 1));
                things.addAll(grown);
                fixed.addAll(grown);
                if (searching) {
                    search(grown.isEmpty() ? before : map(), room);
                }
            }
            return made();
        }

        private boolean placed(Member member) {
            return places.containsKey(member.id());
        }

        private Entity body(Member member) {
            FloorPlace place = places.getOrDefault(member.id(), FloorPlace.ORIGIN);
            return new Entity(member.id(), member.body(), place.pose(), place.height());
        }

        private OccupancyGrid map() {
            List<Entity> robots =
                    members.stream().filter(this::placed).map(this::body).toList();
            var painter = new MapPainter(walls.rasters(), fixed, robots).around(read.moving());
            if (area != null) {
                painter.around(area[0], area[1], area[2], area[3]);
            }
            return painter.map();
        }

        private void search(OccupancyGrid map, Room room) {
            var spaces = new Spaces(map);
            for (Member member : members) {
                if (!placed(member)) {
                    double radius = Room.radius(body(member));
                    double clearance = Math.max(member.free().clearance(), radius + TURNING);
                    Optional<Pose2d> pose = spaces.with(clearance, member.location())
                            .choose(
                                    new SplittableRandom(NamedSeed.of(seed, member.id())),
                                    p -> member.free().holds(p)
                                            && room.isFree(p.x(), p.y(), radius, 0, clearance - radius));
                    if (pose.isEmpty()) {
                        throw new InvalidSettings(
                                member.location(),
                                (room.isExhausted()
                                                ? "It takes too long to find a free place for robot '%s'."
                                                : "There is no free place for robot '%s'.")
                                        .formatted(member.id()),
                                "Maybe the clearance is too large, or the world too small for so many robots.");
                    }
                    places.put(member.id(), new FloorPlace(pose.get(), 0));
                    room.add(body(member), true);
                }
            }
        }

        private Scene made() {
            var robots = new ArrayList<RobotSpec>();
            var bodies = new HashMap<String, Entity>();
            var odometry = new HashMap<String, Pose2d>();
            var programs = new HashMap<String, String>();
            for (Member member : members) {
                Entity body = body(member);
                robots.add(new RobotSpec(
                        member.id(),
                        member.role(),
                        member.model(),
                        Optional.of(body.mapFromEntity()),
                        member.color().toString()));
                if (member.blocks().isPresent()) {
                    bodies.put(member.id(), body);
                }
                if (member.fromStart()) {
                    odometry.put(member.id(), body.mapFromEntity());
                }
                member.odometry().ifPresent(pose -> odometry.put(member.id(), pose));
                member.program().ifPresent(program -> programs.put(member.id(), program));
                count(member.role(), 1);
            }
            warnOfOverlaps();
            return new Scene(
                    title,
                    map(),
                    step,
                    end,
                    touch,
                    walls.rasters(),
                    things,
                    robots,
                    bodies,
                    odometry,
                    programs,
                    contents,
                    List.of(),
                    Stream.concat(problems.warnings().stream(), warnings.stream())
                            .toList());
        }

        private void warnOfOverlaps() {
            var locations = new HashMap<String, Location>();
            members.forEach(member -> locations.put(member.id(), member.location()));
            List<Entity> robots = members.stream().map(this::body).toList();
            for (Overlap overlap : Overlaps.of(walls.rasters(), things, robots)) {
                Location at = locations.getOrDefault(overlap.robot().name(), Location.of(path));
                warn(at, overlap.message(), Overlap.REMEDY);
            }
        }
    }
}
