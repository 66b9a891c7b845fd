package rsal.scenario;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.device.Navigator;
import rsal.robot.DeviceDriver;
import rsal.robot.RobotModel;
import rsal.scenario.PlannedThings.PlannedThing;
import rsal.scenario.PlannedThings.Reach;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.scenario.RunPlan.PlannedDevice;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.settings.Arguments;
import rsal.settings.Location;
import rsal.settings.Parameter;
import rsal.settings.Problem;
import rsal.settings.Value;

/// Places that a scenario gives robots to go to, but to which none of them gets: in a wall, in a table, too near to
/// one, behind a door that is too narrow. Their navigators tell, by the map and by where robots start.
final class Destinations {
    private static final double ARRIVED = Navigator.Tolerance.DEFAULT.distance();
    private static final double ARM = 0.8; // m; from the middle of a robot to what it picks up
    private static final int TOLD = 3; // places of one setting

    private final RunPlan plan;
    private final List<Given> given = new ArrayList<>();

    private Destinations(RunPlan plan) {
        this.plan = plan;
    }

    /// @param what the places are, for people: `(places) of agent (patrol)`
    /// @param robots ids of those that may go there
    /// @param within how near they must come [m]
    private record Given(String what, Location at, Set<String> robots, List<Point2d> mapFromPlaces, double within) {}

    /// Robots that get to the same places.
    private record Kind(DeviceDriver driver, Map<String, Object> options, RobotModel model) {}

    /// What is wrong, where it is written. Takes a while on large maps when there are such places.
    static List<Problem> misplaced(RunPlan plan) {
        var destinations = new Destinations(plan);
        destinations.gather();
        return destinations.problems();
    }

    private void gather() {
        Set<String> all = plan.robots().stream().map(robot -> robot.spec().id()).collect(Collectors.toSet());
        var byRole = new LinkedHashMap<String, List<PlannedAgent>>();
        plan.agents()
                .forEach(agent -> byRole.computeIfAbsent(agent.role(), _ -> new ArrayList<>())
                        .add(agent));
        byRole.forEach((role, agents) -> {
            PlannedAgent one = agents.getFirst();
            Set<String> robots =
                    agents.stream().flatMap(agent -> agent.robot().stream()).collect(Collectors.toSet());
            for (Parameter<?> parameter : one.type().parameters()) {
                if (parameter.kind() == Parameter.Kind.PLACES) {
                    add(new Given(
                            "'%s' of agent '%s'".formatted(parameter.name(), role),
                            written("agents", role, Format.PARAMETERS, parameter.name()),
                            robots.isEmpty() ? all : robots,
                            one.arguments().get(parameter.ofPlaces().orElseThrow()),
                            ARRIVED));
                }
            }
        });
        plan.things().forEach(things -> {
            depot(things, all);
            things(things, all);
        });
    }

    private void depot(PlannedThings things, Set<String> all) {
        things.depot()
                .ifPresent(depot -> add(new Given(
                        "The depot of things '%s'".formatted(things.name()),
                        written("things", things.name(), "depot"),
                        all,
                        depot.mapFromMiddles(),
                        depot.radius() + ARM)));
    }

    private void things(PlannedThings things, Set<String> all) {
        Location at = written("things", things.name(), "pose");
        String what = "'pose' of things '%s'".formatted(things.name());
        List<Point2d> places = places(things.each());
        if (things.reach().isPresent()) {
            Reach reach = things.reach().get();
            Set<String> robots = plan.robots().stream()
                    .filter(robot -> reach.counts(robot.spec().role()))
                    .map(robot -> robot.spec().id())
                    .collect(Collectors.toSet());
            add(new Given(what, at, robots, places, reach.within()));
        } else if (things.depot().isPresent()) {
            add(new Given(what, at, all, places, ARM));
        }
    }

    private static List<Point2d> places(List<PlannedThing> things) {
        return things.stream()
                .map(each -> each.thing().mapFromThing().position())
                .toList();
    }

    private void add(Given places) {
        if (!places.mapFromPlaces.isEmpty()) {
            given.add(places);
        }
    }

    private List<Problem> problems() {
        var starts = new LinkedHashMap<Kind, List<Optional<Point2d>>>();
        var kinds = new HashMap<String, Kind>();
        if (!given.isEmpty()) {
            plan.robots()
                    .forEach(robot -> kind(robot).ifPresent(kind -> {
                        kinds.put(robot.spec().id(), kind);
                        starts.computeIfAbsent(kind, _ -> new ArrayList<>())
                                .add(robot.spec().mapFromBase().map(Pose2d::position));
                    }));
        }
        var wrong = new LinkedHashMap<Given, SortedMap<Integer, String>>(); // by the kind that was asked first
        starts.forEach((kind, from) -> {
            List<Given> asked = given.stream()
                    .filter(places -> places.robots.stream().anyMatch(robot -> kind.equals(kinds.get(robot))))
                    .toList();
            List<SortedMap<Integer, String>> reported = ask(kind, from, asked);
            for (int i = 0; i < asked.size(); i++) {
                SortedMap<Integer, String> now = reported.get(i);
                wrong.merge(asked.get(i), now, (before, _) -> {
                    before.keySet().retainAll(now.keySet());
                    return before;
                });
            }
        });
        return wrong.entrySet().stream()
                .flatMap(entry -> problem(entry.getKey(), entry.getValue()).stream())
                .toList();
    }

    private static Optional<Kind> kind(PlannedRobot robot) {
        return robot.drivers().stream()
                .filter(made -> Navigator.class.isAssignableFrom(made.driver().makes()))
                .findFirst()
                .map(made -> kind(made, robot));
    }

    private static Kind kind(PlannedDevice navigator, PlannedRobot robot) {
        return new Kind(
                navigator.driver(), navigator.options().asMap(), robot.spec().model());
    }

    /// For each of those asked about what is wrong, by index. All at once, since that takes no longer than one.
    private List<SortedMap<Integer, String>> ask(Kind kind, List<Optional<Point2d>> starts, List<Given> asked) {
        var places = new ArrayList<Point2d>();
        var within = new ArrayList<Double>();
        for (Given some : asked) {
            places.addAll(some.mapFromPlaces);
            within.addAll(Collections.nCopies(some.mapFromPlaces.size(), some.within));
        }
        boolean isKnown = starts.stream().allMatch(Optional::isPresent);
        List<Point2d> from =
                isKnown ? starts.stream().map(Optional::orElseThrow).toList() : List.of();
        SortedMap<Integer, String> all = kind.driver.misplaced(
                new DeviceDriver.Places(plan.map(), kind.model, from, places, within),
                Arguments.of(kind.driver.parameters(), kind.options));
        var reported = new ArrayList<SortedMap<Integer, String>>();
        int first = 0;
        for (Given some : asked) {
            var own = new TreeMap<Integer, String>();
            for (int i = 0; i < some.mapFromPlaces.size(); i++) {
                String why = all.get(first + i);
                if (why != null) {
                    own.put(i, why);
                }
            }
            reported.add(own);
            first += some.mapFromPlaces.size();
        }
        return reported;
    }

    private static Optional<Problem> problem(Given places, SortedMap<Integer, String> wrong) {
        if (wrong.isEmpty()) {
            return Optional.empty();
        }
        String more = wrong.size() <= TOLD ? "" : " Nor to %d others.".formatted(wrong.size() - TOLD);
        String reported = wrong.values().stream().limit(TOLD).collect(Collectors.joining(" "));
        return Optional.of(new Problem(
                places.at,
                "%s: no robot gets to %d of %d. %s%s"
                        .formatted(places.what, wrong.size(), places.mapFromPlaces.size(), reported, more),
                ""));
    }

    /// Where a setting is written, or the argument that stands for it.
    private Location written(String... path) {
        Value.Mapping overlay = plan.scenario().overlay(plan.configuration());
        return find(overlay, path)
                .or(() -> find(plan.scenario().settings(), path))
                .map(value -> value instanceof Value.Scalar(Location at, String text) && text.startsWith("$")
                        ? argument(text.substring(1), overlay).orElse(at)
                        : value.location())
                .orElse(plan.scenario().location());
    }

    private Optional<Location> argument(String name, Value.Mapping overlay) {
        return plan.options().arguments().containsKey(name)
                ? Optional.of(plan.options().locationOf(name))
                : find(overlay, Format.ARGUMENTS, name)
                        .or(() -> find(plan.scenario().settings(), Format.ARGUMENTS, name, "default"))
                        .map(Value::location);
    }

    private static Optional<Value> find(Value in, String... path) {
        Optional<Value> found = Optional.of(in);
        for (String key : path) {
            found = found.flatMap(value -> value instanceof Value.Mapping group ? group.find(key) : Optional.empty());
        }
        return found;
    }
}
