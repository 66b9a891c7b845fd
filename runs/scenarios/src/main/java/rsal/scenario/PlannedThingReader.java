package rsal.scenario;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import rsal.data.FreeSpace;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Solid;
import rsal.device.SimulationControl.Marker;
import rsal.device.SimulationControl.Thing;
import rsal.model.BodyReader;
import rsal.scenario.PlannedThings.Depot;
import rsal.scenario.PlannedThings.PlannedThing;
import rsal.scenario.PlannedThings.Reach;
import rsal.scenario.RobotReader.Role;
import rsal.scenario.installed.MapFacts;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Suggestion;

/// Reads what a scenario puts into its simulated world besides robots: where, when, and where it is to be brought.
final class PlannedThingReader {
    private static final BodyReader BODIES = new BodyReader(new BodyReader.Limits(100, 200, 100, 0, 0.25));
    private static final Rgb GRAY = Rgb.of(0x808080);

    private final RobotNames robots;
    private final Optional<OccupancyGrid> map;
    private final MapFacts mapFacts;
    private final Set<String> known; // names of what else there is
    private final List<Pose2d> taken;
    private final Seeds seeds;
    private final Problems problems;

    /// @param known names of what else is in the world
    /// @param taken where robots are at first
    PlannedThingReader(
            RobotNames robots,
            Optional<OccupancyGrid> map,
            MapFacts mapFacts,
            Set<String> known,
            List<Pose2d> taken,
            Seeds seeds,
            Problems problems) {
        this.robots = robots;
        this.map = map;
        this.mapFacts = mapFacts;
        this.known = new HashSet<>(known);
        this.taken = new ArrayList<>(taken);
        this.seeds = seeds;
        this.problems = problems;
        for (Role role : robots.roles()) {
            this.known.add(role.name());
            role.robots().forEach(robot -> this.known.add(robot.spec().id()));
        }
    }

    List<PlannedThings> read(Section things) {
        var all = new ArrayList<PlannedThings>();
        for (String name : things.names()) {
            all.add(group(name, things.section(name)));
        }
        things.done();
        return all;
    }

    private PlannedThings group(String name, Section section) {
        int before = problems.all().size();
        List<String> names = Start.names(name, section);
        if (!PlanReader.isName(name) || !known.add(name) || names.stream().anyMatch(one -> isTaken(one, name))) {
            section.problem(
                    section.location(),
                    "'%s' can't be the name of things: robots or something in the world are called so.".formatted(name),
                    "Rename them.");
        }
        Start start = Start.read(section, names.size(), "things");
        if (!section.has("pose")) {
            section.problem(
                    section.location(), "'%s' is missing.".formatted(section.path("pose")), "Maybe {free: true}.");
        }
        Solid body = BODIES.read(section.section("body"));
        Rgb color = section.has("color") ? BodyReader.color(section, "color") : GRAY;
        boolean obstacle = Boolean.TRUE.equals(section.value(Format.OBSTACLE).orElse(true));
        boolean grippable = Boolean.TRUE.equals(section.value(Format.GRIPPABLE).orElse(false));
        int fiducial = Math.toIntExact((Long) section.value(Format.FIDUCIAL).orElse(0L));
        double power = (Double) section.value(Format.GIVING_POWER).orElse(0.0);
        double every = (Double) section.value(Format.COMES_EVERY).orElse(0.0);
        Optional<Depot> depot = section.has("depot") ? depot(section) : Optional.empty();
        Optional<Reach> reach = section.has("reach") ? reach(section.section("reach")) : Optional.empty();
        section.done();
        if (problems.all().size() > before || map.isEmpty()) {
            return new PlannedThings(name, List.of(), depot, reach);
        }
        List<Pose2d> poses = poses(section, start, names, depot);
        var random = new SplittableRandom(seeds.of("things/" + name));
        var each = new ArrayList<PlannedThing>();
        Duration comes = Duration.ZERO;
        for (int i = 0; i < poses.size(); i++) {
            Optional<Marker> marker = fiducial == 0 ? Optional.empty() : Optional.of(new Marker(fiducial + i, 0));
            each.add(new PlannedThing(
                    new Thing(names.get(i), poses.get(i), body, color, obstacle, grippable, marker, power), comes));
            comes = comes.plusMillis(Math.round(-StrictMath.log(1 - random.nextDouble()) * every * 1000));
        }
        return new PlannedThings(name, each, depot, reach);
    }

    private boolean isTaken(String name, String group) {
        return !name.equals(group) && !known.add(name);
    }

    private List<Pose2d> poses(Section section, Start start, List<String> names, Optional<Depot> depot) {
        if (start.free().isEmpty()) {
            taken.addAll(start.fixed());
            return start.fixed();
        }
        Start.Free free = start.free().get();
        FreeSpace space = free.on(map.orElseThrow(), mapFacts);
        var poses = new ArrayList<Pose2d>();
        for (String name : names) {
            Optional<Pose2d> pose = free.choose(
                    space,
                    seeds.of("pose/" + name),
                    taken,
                    place -> depot.filter(d -> d.holds(place.position(), free.clearance()))
                            .isEmpty());
            if (pose.isEmpty()) {
                section.problem(
                        "pose",
                        "There is no free place for thing '%s'.".formatted(name),
                        "Maybe the clearance or the depot is too large, or the map too small for so many things.");
                return List.of();
            }
            taken.add(pose.get());
            poses.add(pose.get());
        }
        return poses;
    }

    private Optional<Depot> depot(Section section) {
        Section depot = section.section("depot");
        double radius = (Double) depot.value(Format.DEPOT_RADIUS).orElse(1.0);
        boolean around = depot.has("around");
        if (around == depot.has("at")) {
            depot.problem(
                    depot.location(),
                    around
                            ? "'%s' has both 'around' and 'at'.".formatted(section.path("depot"))
                            : "'%s' needs 'around' or 'at'.".formatted(section.path("depot")),
                    "Write {around: ROLE}, where robots of the role are at first, or {at: [[x, y]]}.");
        }
        List<Point2d> middles = around ? starts(depot) : places(depot);
        depot.done();
        return middles.isEmpty() ? Optional.empty() : Optional.of(new Depot(middles, radius));
    }

    private Optional<Reach> reach(Section reach) {
        String by = reach.text("by");
        double within = (Double) reach.value(Format.WITHIN).orElse(1.0);
        Duration stays = Duration.ofMillis(
                Math.round(1000 * (Double) reach.value(Format.DURATION).orElse(0.0)));
        if (!by.isEmpty() && !by.equals(Format.ALL) && robots.role(by).isEmpty() && !robots.open()) {
            noRole(reach, "by", by);
        }
        reach.done();
        return Optional.of(new Reach(Optional.of(by).filter(role -> !role.equals(Format.ALL)), within, stays));
    }

    private void noRole(Section section, String key, String name) {
        section.problem(
                key,
                "No robots have the role '%s'.".formatted(name),
                Suggestion.among(name, robots.roles().stream().map(Role::name).toList()));
    }

    private static List<Point2d> places(Section depot) {
        return depot.list("at").orElse(List.of()).stream()
                .flatMap(place -> depot.numbers("at", place, 2).stream())
                .map(xy -> new Point2d(xy[0], xy[1]))
                .toList();
    }

    private List<Point2d> starts(Section depot) {
        String name = depot.text("around");
        Optional<Role> role = robots.role(name);
        if (role.isEmpty()) {
            if (!robots.open()) {
                noRole(depot, "around", name);
            }
            return List.of();
        }
        List<Point2d> starts = role.get().robots().stream()
                .flatMap(robot -> robot.spec().mapFromBase().stream())
                .map(Pose2d::position)
                .toList();
        if (role.get().complete() && starts.size() < role.get().robots().size()) {
            depot.problem(
                    "around", "Robots of role '%s' don't say where they start.".formatted(name), "Give them a 'pose'.");
        }
        return starts;
    }
}
