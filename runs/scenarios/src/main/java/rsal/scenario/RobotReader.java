package rsal.scenario;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import rsal.data.FreeSpace;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.device.Device;
import rsal.model.RobotColors;
import rsal.model.RobotModels;
import rsal.robot.RobotSpec;
import rsal.scenario.DeviceReader.Equipment;
import rsal.scenario.RunPlan.Mrs;
import rsal.scenario.RunPlan.PlannedDevice;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scenario.installed.Catalog;
import rsal.scenario.installed.MapFacts;
import rsal.settings.ColorNames;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Value;

/// Reads the robots of a scenario: what they are, what they carry, where they start.
final class RobotReader {
    static final String MEMBERS = "members";
    private static final String COUNT = Format.COUNT.name();
    private static final String ROBOTS = "robots";
    static final String OPEN = "auto"; // poses

    private final DeviceReader devices;
    private final SystemReader systems;
    private final DeviceSelector outfitter;
    private final Optional<OccupancyGrid> map;
    private final MapFacts mapFacts;
    private final Seeds seeds;
    private final Problems problems;
    private final List<Pose2d> taken = new ArrayList<>();

    RobotReader(
            Catalog catalog,
            SystemReader systems,
            FileSource files,
            Optional<OccupancyGrid> map,
            MapFacts mapFacts,
            Seeds seeds,
            Problems problems) {
        this.systems = systems;
        this.devices = new DeviceReader(catalog, new RobotModels(files), problems);
        this.outfitter = new DeviceSelector(catalog, seeds);
        this.map = map;
        this.mapFacts = mapFacts;
        this.seeds = seeds;
        this.problems = problems;
    }

    /// Where robots are at first, of those that say so.
    List<Pose2d> taken() {
        return List.copyOf(taken);
    }

    /// Robots that a scenario calls by one name.
    ///
    /// @param settings of each, by id
    /// @param has types of the devices that each of them has
    /// @param complete false when an error left something out
    record Role(
            String name,
            List<PlannedRobot> robots,
            Map<String, Section> settings,
            List<Class<? extends Device>> has,
            boolean complete) {
        /// Robots that have the same settings.
        static Role of(
                String name,
                Section settings,
                List<PlannedRobot> robots,
                List<Class<? extends Device>> has,
                boolean complete) {
            var byId = new LinkedHashMap<String, Section>();
            robots.forEach(robot -> byId.put(robot.spec().id(), settings));
            return new Role(name, robots, byId, has, complete);
        }

        /// These and others.
        Role and(Role more) {
            var all = new ArrayList<>(robots);
            all.addAll(more.robots);
            var byId = new LinkedHashMap<>(settings);
            byId.putAll(more.settings);
            var both = has.stream().filter(more.has::contains).toList();
            return new Role(name, all, byId, both, complete && more.complete);
        }

        boolean has(String robot) {
            return settings.containsKey(robot);
        }

        /// Where something is written about one of its robots: in a list of one for each, its own.
        Location placeOf(String robot, String key) {
            Section own = Objects.requireNonNull(settings.get(robot));
            var alike = settings.keySet().stream()
                    .filter(id -> own.equals(settings.get(id)))
                    .toList();
            return own.mapping()
                    .find(key)
                    .filter(Value.Sequence.class::isInstance)
                    .map(value -> ((Value.Sequence) value).items())
                    .filter(items -> items.size() > alike.indexOf(robot)
                            && items.stream().allMatch(Value.Sequence.class::isInstance))
                    .map(items -> items.get(alike.indexOf(robot)).location())
                    .orElse(own.locationOf(key));
        }

        List<Class<? extends Device>> missing(List<Class<? extends Device>> needs) {
            return DeviceReader.missing(has, needs);
        }
    }

    /// @param others that the world brings along
    /// @param needed whether there must be any at all
    List<Role> read(Section robots, List<RobotSpec> others, boolean needed) {
        var drafts = new ArrayList<Draft>();
        int role = 0;
        for (String name : robots.names()) {
            drafts.addAll(drafts(name, robots.section(name), RobotColors.of(role++)));
        }
        robots.done();
        if (needed && drafts.isEmpty() && others.isEmpty()) {
            robots.problem(
                    robots.location(),
                    "There are no robots.",
                    "Add a group 'robots' with at least one role, or take a world that has some.");
        }
        boolean tooMany = checkNumber(robots, drafts, others);
        others.forEach(other -> other.mapFromBase().ifPresent(taken::add));
        for (Draft draft : drafts) {
            taken.addAll(draft.start.fixed()); // before any free place is chosen
        }
        var roles = new LinkedHashMap<String, Role>();
        for (Draft draft : drafts) {
            roles.merge(draft.name, role(draft, draft.complete && !tooMany), Role::and);
        }
        return List.copyOf(roles.values());
    }

    /// @return whether there are too many to go on with
    private static boolean checkNumber(Section robots, List<Draft> drafts, List<RobotSpec> others) {
        var ids = drafts.stream().flatMap(draft -> draft.ids.stream()).toList();
        if (ids.size() > Format.MAX_ROBOTS) {
            robots.problem(
                    robots.location(),
                    "There are %d robots; at most %d can be.".formatted(ids.size(), Format.MAX_ROBOTS),
                    "");
        }
        if (ids.stream().distinct().count() != ids.size()) {
            robots.problem(
                    robots.location(),
                    "Two robots have the same name among %s.".formatted(ids),
                    "Rename a role, or one of its members.");
        }
        checkOthers(robots, drafts, others);
        return ids.size() > Format.MAX_ROBOTS;
    }

    /// Robots of the world keep their names.
    private static void checkOthers(Section robots, List<Draft> drafts, List<RobotSpec> others) {
        var names = new HashSet<String>();
        others.forEach(other -> names.addAll(List.of(other.id(), other.role())));
        for (Draft draft : drafts) {
            if (names.contains(draft.name) || draft.ids.stream().anyMatch(names::contains)) {
                robots.problem(
                        draft.section.location(),
                        "The world has robots called '%s', too.".formatted(draft.name),
                        "Rename the role.");
            }
        }
    }

    /// Robots of a role with the same settings, as far as they can be read by themselves.
    ///
    /// @param name of the role
    /// @param mrs empty when it can't be read
    private record Draft(
            String name,
            Section section,
            List<String> ids,
            Optional<Mrs> mrs,
            Equipment equipment,
            Start start,
            String color,
            int firstMarker,
            boolean proxy,
            boolean overlay,
            boolean complete) {}

    private List<Draft> drafts(String name, Section section, String color) {
        if (!PlanReader.isName(name)) {
            section.problem(section.location(), "'%s' can't be the role of robots.".formatted(name), "");
        }
        return section.has(MEMBERS)
                ? members(name, section, color)
                : List.of(draft(name, section, Start.names(name, section), color, 0));
    }

    /// A scenario's own settings for a configuration that lies over them: where that names robots one by one, they are
    /// not counted any more, and the other way round.
    static Value.Mapping under(Value.Mapping settings, Value.Mapping over) {
        if (!(settings.find(ROBOTS).orElse(null) instanceof Value.Mapping below)
                || !(over.find(ROBOTS).orElse(null) instanceof Value.Mapping above)) {
            return settings;
        }
        var roles = new LinkedHashMap<>(below.entries());
        roles.replaceAll((role, own) ->
                own instanceof Value.Mapping its && above.find(role).orElse(null) instanceof Value.Mapping said
                        ? its.without(
                                said.find(MEMBERS).isPresent()
                                        ? COUNT
                                        : said.find(COUNT).isPresent() ? MEMBERS : "")
                        : own);
        var entries = new LinkedHashMap<>(settings.entries());
        entries.put(ROBOTS, new Value.Mapping(below.location(), roles, below.keys()));
        return new Value.Mapping(settings.location(), entries, settings.keys());
    }

    /// Those of a role that are named one by one: each has what the role says, and says itself what is otherwise.
    private List<Draft> members(String name, Section section, String color) {
        if (section.has(COUNT)) {
            section.problem(
                    COUNT,
                    "'%s' is not allowed where robots are listed one by one.".formatted(section.path(COUNT)),
                    "Remove it: there are as many as 'members'.");
        }
        Value.Mapping common = section.mapping().without(MEMBERS).without(COUNT);
        if (common.find("pose").filter(RobotReader::isListOfPoses).isPresent()) {
            section.problem(
                    "pose",
                    "'%s' can't be a list of poses where robots are named one by one.".formatted(section.path("pose")),
                    "Write 'pose' into 'members'.");
            common = common.without("pose");
        }
        var drafts = new ArrayList<Draft>();
        for (Section member : Format.groups(section, MEMBERS)) {
            String id = member.text("name", name + "-" + (drafts.size() + 1));
            if (!PlanReader.isName(id)) {
                member.problem("name", "'%s' can't be the name of a robot.".formatted(id), "");
            }
            Value.Mapping own = common.merge(member.mapping().without("name"));
            var settings = new Value.Mapping(member.location(), own.entries(), own.keys());
            int number = member.has(Format.FIDUCIAL.name()) ? 0 : drafts.size();
            drafts.add(draft(name, new Section(section.path(MEMBERS), settings, problems), List.of(id), color, number));
        }
        if (drafts.isEmpty()) {
            section.problem(MEMBERS, "'%s' has none.".formatted(section.path(MEMBERS)), "Maybe 'count: 1'?");
        }
        return drafts;
    }

    private static boolean isListOfPoses(Value pose) {
        return pose instanceof Value.Sequence several
                && several.items().stream().anyMatch(Value.Sequence.class::isInstance);
    }

    /// @param usual color
    /// @param number of the first of them in their role, from 0
    private Draft draft(String name, Section section, List<String> ids, String usual, int number) {
        int before = problems.all().size();
        Optional<Mrs> mrs = systems.of(section, "robot%s '%s'".formatted(ids.size() > 1 ? "s" : "", words(ids)));
        Equipment equipment = devices.read(section);
        Start start = isLeftOpen(section) ? Start.OPEN : Start.read(section, ids.size(), "robots");
        String color = section.find("color")
                .flatMap(read -> ColorNames.read(section, "color", read))
                .map(Rgb::toString)
                .orElse(usual);
        int marker = Math.toIntExact((Long) section.value(Format.FIDUCIAL).orElse(0L));
        int firstMarker = marker == 0 ? 0 : marker + number;
        boolean proxy = Boolean.TRUE.equals(section.value(Format.PROXY).orElse(false));
        boolean overlay = Boolean.TRUE.equals(section.value(Format.OVERLAY).orElse(false));
        section.done();
        boolean complete = problems.all().size() == before && mrs.isPresent();
        return new Draft(name, section, ids, mrs, equipment, start, color, firstMarker, proxy, overlay, complete);
    }

    /// Whether it is the robot system or the localizer that knows where they are.
    private static boolean isLeftOpen(Section section) {
        return section.find("pose")
                .filter(pose ->
                        pose instanceof Value.Scalar scalar && scalar.value().equals(OPEN))
                .isPresent();
    }

    private static String words(List<String> ids) {
        return ids.size() > 1 ? ids.getFirst() + " to " + ids.getLast() : ids.getFirst();
    }

    private Role role(Draft draft, boolean readable) {
        var robots = new ArrayList<PlannedRobot>();
        boolean complete = readable;
        List<Pose2d> fixed = draft.start.fixed();
        Start.Free free = draft.start.free().orElse(null);
        FreeSpace space = free == null || map.isEmpty() ? null : free.on(map.get(), mapFacts);
        for (int i = 0; i < draft.ids.size() && complete; i++) {
            String id = draft.ids.get(i);
            Optional<Pose2d> mapFromBase = fixed.isEmpty() ? Optional.empty() : Optional.of(fixed.get(i));
            if (free != null && space != null) {
                mapFromBase = free.choose(space, seeds.of("pose/" + id), taken, _ -> true);
                mapFromBase.ifPresent(taken::add);
                if (mapFromBase.isEmpty()) {
                    draft.section.problem(
                            "pose",
                            "There is no free place for robot '%s'.".formatted(id),
                            "Maybe the clearance is too large, or the map too small for so many robots.");
                    complete = false;
                }
            }
            robots.add(robot(draft, i, mapFromBase));
        }
        return Role.of(draft.name, draft.section, robots, draft.equipment.has(), complete);
    }

    private PlannedRobot robot(Draft draft, int number, Optional<Pose2d> mapFromBase) {
        String id = draft.ids.get(number);
        OptionalInt marker = draft.firstMarker == 0 ? OptionalInt.empty() : OptionalInt.of(draft.firstMarker + number);
        var spec =
                new RobotSpec(id, draft.name, draft.equipment.model().orElseThrow(), mapFromBase, draft.color, marker);
        List<PlannedDevice> drivers = draft.equipment.drivers().stream()
                .map(d ->
                        new PlannedDevice(d.name(), d.driver(), d.options(), seeds.of("device/" + id + "/" + d.name())))
                .toList();
        return outfitter
                .robot(spec, draft.mrs.orElseThrow(), drivers)
                .withProxy(draft.proxy)
                .withOverlay(draft.overlay);
    }
}
