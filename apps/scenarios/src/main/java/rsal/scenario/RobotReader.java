package rsal.scenario;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Pattern;
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

    /// Where robots are at first, of those that say so.
    List<Pose2d> taken() {
        return List.copyOf(taken);
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
            taken.addAll(draft.start.fixed()); // before any free place is chosen
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
    private record Draft(
            String name,
            Section section,
            List<String> ids,
            Equipment equipment,
            Start start,
            String color,
            int firstMarker,
            boolean complete) {}

    private Draft draft(String name, Section section, int index) {
        int before = problems.all().size();
        if (!PlanReader.isName(name)) {
            section.problem(section.location(), "(%s) can't be the role of robots.".formatted(name), "");
        }
        List<String> ids = Start.names(name, section);
        Equipment equipment = devices.read(section);
        Start start = Start.read(section, ids.size(), "robots");
        String color = section.text("color", RobotColors.of(index));
        if (!COLOR.matcher(color).matches()) {
            section.problem(
                    "color", "(%s) must be like #1f77b4, not (%s).".formatted(section.path("color"), color), "");
        }
        int firstMarker = Math.toIntExact((Long) section.value(Format.FIDUCIAL).orElse(0L));
        section.done();
        boolean complete = problems.all().size() == before;
        return new Draft(name, section, ids, equipment, start, color, firstMarker, complete);
    }

    private Role role(Draft draft, boolean readable) {
        var robots = new ArrayList<PlannedRobot>();
        boolean complete = readable;
        List<Pose2d> fixed = draft.start.fixed();
        Start.Free free = draft.start.free().orElse(null);
        FreeSpace space = free == null || map.isEmpty() ? null : free.on(map.get());
        for (int i = 0; i < draft.ids.size() && complete; i++) {
            String id = draft.ids.get(i);
            Optional<Pose2d> mapFromBase = fixed.isEmpty() ? Optional.empty() : Optional.of(fixed.get(i));
            if (free != null && space != null) {
                mapFromBase = free.choose(space, seeds.of("pose/" + id), taken, _ -> true);
                mapFromBase.ifPresent(taken::add);
                if (mapFromBase.isEmpty()) {
                    draft.section.problem(
                            "pose",
                            "There is no free place for robot (%s).".formatted(id),
                            "Maybe the clearance is too large, or the map too small for so many robots.");
                    complete = false;
                }
            }
            robots.add(robot(draft, i, mapFromBase));
        }
        return new Role(draft.name, draft.section, robots, draft.equipment.has(), complete);
    }

    private PlannedRobot robot(Draft draft, int number, Optional<Pose2d> mapFromBase) {
        String id = draft.ids.get(number);
        OptionalInt marker = draft.firstMarker == 0 ? OptionalInt.empty() : OptionalInt.of(draft.firstMarker + number);
        var spec =
                new RobotSpec(id, draft.name, draft.equipment.model().orElseThrow(), mapFromBase, draft.color, marker);
        return outfitter.robot(
                spec,
                draft.equipment.drivers().stream()
                        .map(d -> new PlannedDevice(
                                d.name(), d.driver(), d.options(), seeds.of("device/" + id + "/" + d.name())))
                        .toList());
    }
}
