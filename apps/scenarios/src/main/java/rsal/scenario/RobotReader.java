package rsal.scenario;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.device.Device;
import rsal.map.FreeSpace;
import rsal.robot.RobotColors;
import rsal.robot.RobotModels;
import rsal.robot.RobotSpec;
import rsal.scenario.DeviceReader.Equipment;
import rsal.scenario.RunPlan.PlannedDevice;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.settings.FileSource;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Value;

/// Reads the robots of a scenario: what they are, what they carry, where they start.
final class RobotReader {
    private static final Pattern COLOR = Pattern.compile("#[0-9a-fA-F]{6}");

    private final DeviceReader devices;
    private final Outfitter outfitter;
    private final Optional<OccupancyGrid> map;
    private final Seeds seeds;
    private final Problems problems;
    private final List<Pose2d> taken = new ArrayList<>();

    RobotReader(Catalog catalog, FileSource files, Optional<OccupancyGrid> map, Seeds seeds, Problems problems) {
        this.devices = new DeviceReader(catalog, new RobotModels(files), problems);
        this.outfitter = new Outfitter(catalog, seeds);
        this.map = map;
        this.seeds = seeds;
        this.problems = problems;
    }

    /// Robots of one kind.
    ///
    /// @param has types of the devices that each of them has
    /// @param complete false when a mistake left something out
    record Role(
            String name,
            Section section,
            List<PlannedRobot> robots,
            List<Class<? extends Device>> has,
            boolean complete) {
        List<Class<? extends Device>> missing(List<Class<? extends Device>> needs) {
            return DeviceReader.missing(has, needs);
        }
    }

    /// @param others that the world brings along
    /// @param needed whether there must be any at all
    List<Role> read(Section robots, List<RobotSpec> others, boolean needed) {
        var drafts = new ArrayList<Draft>();
        for (String name : robots.names()) {
            drafts.add(draft(name, robots.section(name), drafts.size()));
        }
        robots.done();
        if (needed && drafts.isEmpty() && others.isEmpty()) {
            robots.problem(
                    robots.location(),
                    "There are no robots.",
                    "Add a group (robots) with at least one role, or take a world that has some.");
        }
        boolean tooMany = checkNumber(robots, drafts, others);
        others.forEach(other -> other.mapFromBase().ifPresent(taken::add));
        for (Draft draft : drafts) {
            taken.addAll(draft.fixed); // before any free place is chosen
        }
        return drafts.stream()
                .map(draft -> role(draft, draft.complete && !tooMany))
                .toList();
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
                    robots.location(), "Two robots have the same name among %s.".formatted(ids), "Rename a role.");
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
                        "The world has robots called (%s), too.".formatted(draft.name),
                        "Rename the role.");
            }
        }
    }

    /// A role as far as it can be read by itself.
    ///
    /// @param fixed poses, as many as robots, or none
    /// @param free where to look for a place; null when poses are fixed or unknown
    private record Draft(
            String name,
            Section section,
            List<String> ids,
            Equipment equipment,
            List<Pose2d> fixed,
            @Nullable Free free,
            String color,
            boolean complete) {}

    /// @param within x and y of the lower left and the upper right corner [m]; null for anywhere
    private record Free(double clearance, double @Nullable [] within) {
        boolean holds(Pose2d pose) {
            return within == null
                    || (pose.x() >= within[0]
                            && pose.y() >= within[1]
                            && pose.x() <= within[2]
                            && pose.y() <= within[3]);
        }
    }

    private Draft draft(String name, Section section, int index) {
        int before = problems.all().size();
        if (!PlanReader.isName(name)) {
            section.problem(section.location(), "(%s) can't be the role of robots.".formatted(name), "");
        }
        List<String> ids = ids(name, section);
        Equipment equipment = devices.read(section);
        Free free = section.isMapping("pose") ? free(section.section("pose")) : null;
        List<Pose2d> fixed = free == null ? poses(section, ids.size()) : List.of();
        String color = section.text("color", RobotColors.of(index));
        if (!COLOR.matcher(color).matches()) {
            section.problem(
                    "color", "(%s) must be like #1f77b4, not (%s).".formatted(section.path("color"), color), "");
        }
        section.done();
        boolean complete = problems.all().size() == before;
        return new Draft(name, section, ids, equipment, fixed, free, color, complete);
    }

    private static List<String> ids(String role, Section section) {
        if (!section.has("count")) {
            return List.of(role);
        }
        int count = Math.toIntExact((Long) section.value(Format.COUNT).orElse(1L));
        var ids = new ArrayList<String>();
        for (int i = 1; i <= count; i++) {
            ids.add(role + "-" + i);
        }
        return ids;
    }

    private static Free free(Section pose) {
        if (!Boolean.TRUE.equals(pose.value(Format.FREE).orElse(true)) || !pose.has("free")) {
            pose.problem(
                    pose.location(),
                    "(%s) must be [x, y, degrees], a list of those, or {free: true}.".formatted(pose.path("")),
                    "");
        }
        double clearance = (Double) pose.value(Format.CLEARANCE).orElse(0.4);
        double[] within = pose.numbers("within", 4).orElse(null);
        if (within != null && !(within[0] < within[2] && within[1] < within[3])) {
            pose.problem("within", "(within) must be [least x, least y, greatest x, greatest y].", "");
        }
        pose.done();
        return new Free(clearance, within);
    }

    private static List<Pose2d> poses(Section section, int count) {
        Optional<Value> value = section.find("pose");
        if (value.isEmpty()) {
            return List.of();
        }
        if (!(value.get() instanceof Value.Sequence sequence)) {
            section.expected("pose", "[x, y, degrees], a list of those, or {free: true}", value.get());
            return List.of();
        }
        boolean several =
                !sequence.items().isEmpty() && sequence.items().stream().allMatch(Value.Sequence.class::isInstance);
        List<Value> written = several ? sequence.items() : List.of(sequence);
        var poses = written.stream()
                .flatMap(pose -> section.numbers("pose", pose, 3).stream())
                .map(n -> Pose2d.ofDegrees(n[0], n[1], n[2]))
                .toList();
        if (written.size() < count) {
            section.problem(
                    "pose",
                    "(%s) has %d for %d robots.".formatted(section.path("pose"), written.size(), count),
                    "Write a list of poses, or {free: true}.");
        }
        return poses.size() < count ? List.of() : poses.subList(0, count);
    }

    private Role role(Draft draft, boolean readable) {
        var robots = new ArrayList<PlannedRobot>();
        boolean complete = readable;
        Free free = draft.free;
        FreeSpace space = free == null || map.isEmpty() ? null : new FreeSpace(map.get(), free.clearance);
        for (int i = 0; i < draft.ids.size() && complete; i++) {
            String id = draft.ids.get(i);
            Optional<Pose2d> mapFromBase = draft.fixed.isEmpty() ? Optional.empty() : Optional.of(draft.fixed.get(i));
            if (free != null && space != null) {
                mapFromBase = place(free, space, id);
                if (mapFromBase.isEmpty()) {
                    draft.section.problem(
                            "pose",
                            "There is no free place for robot (%s).".formatted(id),
                            "Maybe the clearance is too large, or the map too small for so many robots.");
                    complete = false;
                }
            }
            robots.add(robot(draft, id, mapFromBase));
        }
        return new Role(draft.name, draft.section, robots, draft.equipment.has(), complete);
    }

    private Optional<Pose2d> place(Free free, FreeSpace space, String id) {
        var place = space.choose(
                new SplittableRandom(seeds.of("pose/" + id)),
                pose -> free.holds(pose)
                        && taken.stream().noneMatch(other -> other.distanceTo(pose) < 2 * free.clearance));
        place.ifPresent(taken::add);
        return place;
    }

    private PlannedRobot robot(Draft draft, String id, Optional<Pose2d> mapFromBase) {
        var spec = new RobotSpec(id, draft.name, draft.equipment.model().orElseThrow(), mapFromBase, draft.color);
        return outfitter.robot(
                spec,
                draft.equipment.drivers().stream()
                        .map(d -> new PlannedDevice(
                                d.name(), d.driver(), d.options(), seeds.of("device/" + id + "/" + d.name())))
                        .toList());
    }
}
