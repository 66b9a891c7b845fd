package rsal.scenario;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.fault.Fault;
import rsal.fault.FaultInjection;
import rsal.fault.SensorFaults;
import rsal.robot.RobotSpec;
import rsal.scenario.RunPlan.Mrs;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scenario.fault.FaultKind;
import rsal.scenario.fault.PlannedFault;
import rsal.scenario.fault.PlannedFault.OfMessages;
import rsal.scenario.fault.PlannedFault.OfRobot;
import rsal.scenario.fault.PlannedFault.Target;
import rsal.scenario.fault.Span;
import rsal.scenario.fault.Wildcard;
import rsal.settings.Arguments;
import rsal.settings.Location;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.settings.Value;
import rsal.system.RobotSystem;

/// Reads what goes wrong in a scenario: with whom, when and how.
final class FaultReader {
    private static final String ANY = "any";
    private static final String BASE = "base";
    private static final String OPERATOR = "operator"; // who speaks for people

    private final RobotNames names;
    private final List<PlannedRobot> robots;
    private final List<PlannedAgent> agents;
    private final boolean allAgents;
    private final Seeds seeds;
    private final Problems problems;
    private final List<Draft> drafts = new ArrayList<>();
    private final Map<String, Integer> streams = new HashMap<>(); // how often each was asked for

    private record Draft(Section section, PlannedFault fault) {}

    /// What was written for a name, and where.
    private record Word(String text, Location at) {
        boolean isAll() {
            return text.equals(Format.ALL) || text.equals(ANY);
        }
    }

    private record Named(PlannedRobot robot, String device, Class<? extends Device> type) {}

    /// @param robots of all roles, with what their agents need
    /// @param allAgents false when an error may have left some out
    FaultReader(
            RobotNames names,
            List<PlannedRobot> robots,
            List<PlannedAgent> agents,
            boolean allAgents,
            Seeds seeds,
            Problems problems) {
        this.names = names;
        this.robots = robots;
        this.agents = agents;
        this.allAgents = allAgents;
        this.seeds = seeds;
        this.problems = problems;
    }

    List<PlannedFault> read(Section root) {
        for (Section section : Format.groups(root, "faults")) {
            int before = problems.all().size();
            Optional<PlannedFault> fault = fault(section);
            if (problems.all().size() == before) {
                fault.ifPresent(f -> drafts.add(new Draft(section, f)));
            }
        }
        return drafts.stream().map(Draft::fault).toList();
    }

    /// Lets a robot system say which faults its robots can't have.
    void check(RobotSystem system, Mrs mrs) {
        var own = mrs.own(robots).stream().map(RobotSpec::id).toList();
        for (Draft draft : drafts) {
            Section section = draft.section;
            for (Target target : draft.fault.targets()) {
                if (target instanceof OfRobot broken && own.contains(broken.robot()) && !isSoftware(broken)) {
                    Optional<String> refusal = refusal(system, mrs, broken);
                    if (refusal.isPresent()) {
                        section.problem(
                                "kind",
                                "'%s' can't be '%s': %s".formatted(target.name(), draft.fault.kind(), refusal.get()),
                                "Name others in 'robots' or 'devices', or remove this fault.");
                        break;
                    }
                }
            }
        }
    }

    private static Optional<String> refusal(RobotSystem system, Mrs mrs, OfRobot broken) {
        Optional<FaultInjection> faults = system.faults();
        return faults.isEmpty()
                ? Optional.of("%s can't break robots on purpose.".formatted(mrs.name()))
                : faults.get().refusal(broken.robot(), broken.device(), broken.fault());
    }

    /// Made from other devices, which is no matter of the robot system.
    private boolean isSoftware(OfRobot broken) {
        return robots().filter(robot -> robot.spec().id().equals(broken.robot()))
                .anyMatch(robot -> robot.makes(broken.device()));
    }

    private Stream<PlannedRobot> robots() {
        return robots.stream();
    }

    private Optional<PlannedFault> fault(Section section) {
        Optional<FaultKind> kind =
                section.value(Format.FAULT_KIND).map(word -> Format.of(FaultKind.values(), FaultKind::word, word));
        double at = (Double) section.value(Format.AT).orElse(0.0);
        Optional<Double> every =
                section.has("every") ? section.value(Format.EVERY).map(Double.class::cast) : Optional.empty();
        Optional<Span> lasts = Format.span(section, "for", Format.LONGEST, 0.01);
        if (kind.isEmpty()) {
            return Optional.empty(); // what else there may be depends on it
        }
        Optional<Arguments> arguments = arguments(section, kind.get());
        Optional<Integer> pick = kind.get().of() == FaultKind.Of.MESSAGES ? Optional.empty() : pick(section);
        List<Target> targets = arguments.isEmpty() ? List.of() : targets(section, kind.get(), arguments.get());
        kind.get().of().keys().forEach(section::has); // known, also where they were not read
        kind.get().delay().ifPresent(_ -> section.has("delay"));
        section.done();
        return Optional.of(new PlannedFault(
                kind.get().word(),
                targets,
                pick,
                Span.duration(at),
                every.map(Span::duration),
                lasts,
                seeds.of(stream(kind.get(), targets))));
    }

    /// A name that depends on no other fault but those of the same kind and targets.
    private String stream(FaultKind kind, List<Target> targets) {
        String words = targets.stream().map(FaultReader::named).collect(Collectors.joining(","));
        String stream = "fault/" + kind.word() + "/" + words;
        return stream + "/" + streams.merge(stream, 1, Integer::sum);
    }

    private static String named(Target target) {
        return target instanceof OfMessages messages
                ? "%s %s %s".formatted(messages.topics(), sorted(messages.from()), sorted(messages.to()))
                : target.name();
    }

    private static String sorted(Optional<Set<String>> agents) {
        return agents.map(names -> new TreeSet<>(names).toString()).orElse(Format.ALL);
    }

    private static Optional<Arguments> arguments(Section section, FaultKind kind) {
        int before = section.problems().all().size();
        Map<String, Object> values = new LinkedHashMap<>(section.values(kind.parameters()));
        if (kind == FaultKind.BIASED || kind == FaultKind.NOISY) {
            if (values.values().stream().allMatch(value -> value.equals(0.0))) {
                section.problem(
                        section.location(),
                        "A '%s' sensor needs an error, 'range' or 'angle'.".formatted(kind.word()),
                        kind.parameters().getFirst().description());
            }
        }
        return section.problems().all().size() == before
                ? Optional.of(Arguments.of(kind.parameters(), values))
                : Optional.empty();
    }

    /// How many of them; one of any.
    private static Optional<Integer> pick(Section section) {
        if (section.has("pick")) {
            return section.value(Format.PICK).map(n -> Math.toIntExact((Long) n));
        }
        boolean any = words(section, "robots").stream().anyMatch(word -> word.text.equals(ANY));
        return any ? Optional.of(1) : Optional.empty();
    }

    private List<Target> targets(Section section, FaultKind kind, Arguments arguments) {
        return switch (kind.of()) {
            case SENSORS -> sensors(section, kind, (Fault.OfSensor) kind.fault(arguments));
            case BASES -> robots(section, kind.fault(arguments), BASE);
            case ROBOTS -> robots(section, kind.fault(arguments), "");
            case MESSAGES -> List.of(messages(section, kind, arguments.get(FaultKind.SHARE)));
        };
    }

    private List<Target> robots(Section section, Fault fault, String device) {
        var targets = new LinkedHashSet<Target>();
        required(section, "robots")
                .forEach(word -> called(section, word)
                        .forEach(robot -> targets.add(new OfRobot(robot.spec().id(), device, fault))));
        return List.copyOf(targets);
    }

    /// Robots of a role, of an id, or of a pattern.
    private List<PlannedRobot> called(Section section, Word word) {
        var found = robots().filter(robot ->
                        isCalled(word, robot.spec().role(), robot.spec().id()))
                .toList();
        if (found.isEmpty() && !names.mayLackSome()) {
            var known = new LinkedHashSet<String>();
            names.roles().forEach(role -> known.add(role.name()));
            robots().map(robot -> robot.spec().id())
                    .filter(id -> Suggestion.closest(word.text, List.of(id)).isPresent())
                    .forEach(known::add);
            section.problem(
                    word.at,
                    "'%s' must be a role of robots, the id of one, a pattern (r*) or all, not '%s'."
                            .formatted(section.path("robots"), word.text),
                    Suggestion.among(word.text, known));
        }
        return found;
    }

    private static boolean isCalled(Word word, String... names) {
        for (String name : names) {
            if (word.isAll() || Wildcard.matches(word.text, name)) {
                return true;
            }
        }
        return false;
    }

    private List<Target> sensors(Section section, FaultKind kind, Fault.OfSensor fault) {
        var targets = new LinkedHashSet<Target>();
        List<Word> robots = required(section, "robots");
        List<Word> devices = required(section, "devices");
        for (Word device : devices) {
            var found = new LinkedHashSet<Named>();
            var lacking = new ArrayList<Word>();
            for (Word robot : robots) {
                List<PlannedRobot> called = called(section, robot);
                var theirs = called.stream()
                        .flatMap(each -> devices(each).stream())
                        .filter(named -> isMeant(device, named, fault))
                        .toList();
                if (theirs.isEmpty() && !called.isEmpty()) {
                    lacking.add(robot);
                }
                found.addAll(theirs);
            }
            boolean named = lacking.stream().anyMatch(robot -> !robot.isAll() && !Wildcard.isPattern(robot.text));
            if (!lacking.isEmpty() && (named || found.isEmpty())) {
                lacks(section, lacking.getFirst(), device);
            } else {
                refuse(section, kind, device, found, fault);
            }
            found.forEach(each -> targets.add(new OfRobot(each.robot.spec().id(), each.device, fault)));
        }
        return List.copyOf(targets);
    }

    private void lacks(Section section, Word robot, Word device) {
        if (!names.mayLackSome()) {
            var known = new LinkedHashSet<String>();
            robots().filter(each ->
                            isCalled(robot, each.spec().role(), each.spec().id()))
                    .forEach(each -> devices(each).forEach(named -> known.add(named.device)));
            section.problem(
                    device.at,
                    "Robots called '%s' have no sensor '%s'.".formatted(robot.text, device.text),
                    Suggestion.among(device.text, known));
        }
    }

    private static void refuse(
            Section section, FaultKind kind, Word device, Collection<Named> found, Fault.OfSensor fault) {
        for (Named each : found) {
            Optional<String> why = SensorFaults.refusal(each.type, fault);
            if (why.isPresent()) {
                section.problem(
                        device.at,
                        "Device '%s/%s' can't be %s like this."
                                .formatted(each.robot.spec().id(), each.device, kind.word()),
                        why.get());
                return;
            }
        }
    }

    /// By name or by type. All and patterns mean only what can have the fault.
    private static boolean isMeant(Word word, Named named, Fault.OfSensor fault) {
        if (word.isAll() || Wildcard.isPattern(word.text)) {
            return isCalled(word, named.device)
                    && SensorFaults.refusal(named.type, fault).isEmpty();
        }
        return isCalled(word, named.device) || types(named.type).contains(word.text);
    }

    /// Names of a type and of what it is besides: LaserScanner, Sensor, RangeSensor, Device.
    private static Set<String> types(Class<?> type) {
        var names = new LinkedHashSet<String>();
        names.add(type.getSimpleName());
        for (Class<?> more : type.getInterfaces()) {
            names.addAll(types(more));
        }
        return names;
    }

    private static List<Named> devices(PlannedRobot robot) {
        var devices = new ArrayList<Named>();
        devices.add(new Named(robot, BASE, DriveBase.class));
        robot.spec().model().sensors().forEach((name, part) -> devices.add(new Named(robot, name, part.makes())));
        robot.drivers()
                .forEach(device -> devices.add(
                        new Named(robot, device.name(), device.driver().makes())));
        return devices;
    }

    private OfMessages messages(Section section, FaultKind kind, double share) {
        List<String> topics = words(section, "topics").stream()
                .filter(word -> !word.isAll())
                .map(Word::text)
                .toList();
        Optional<Span> delay = kind.delay()
                .flatMap(fallback -> section.has("delay")
                        ? Format.span(section, "delay", Format.LONGEST_DELAY, 0)
                        : Optional.of(Span.of(fallback, fallback)));
        return new OfMessages(
                topics,
                agents(section, "from"),
                agents(section, "to"),
                share,
                kind.mishap(delay.orElse(Span.of(0, 0))));
    }

    /// Agents by their own name or role, or by id or role of their robot; empty for all.
    private Optional<Set<String>> agents(Section section, String key) {
        List<Word> words = words(section, key);
        if (words.isEmpty() || words.stream().anyMatch(Word::isAll)) {
            return Optional.empty();
        }
        var names = new LinkedHashSet<String>();
        for (Word word : words) {
            var found = agents.stream()
                    .filter(agent -> isCalled(word, called(agent)))
                    .toList();
            boolean operator = isCalled(word, OPERATOR);
            if (found.isEmpty() && !operator && allAgents) {
                var known = agents.stream()
                        .flatMap(agent -> List.of(called(agent)).stream())
                        .collect(Collectors.toCollection(LinkedHashSet::new));
                section.problem(
                        word.at,
                        "'%s' must be an agent, a robot that has one, the role of either, a pattern (f*) or all, not '%s'."
                                .formatted(section.path(key), word.text),
                        Suggestion.among(word.text, known));
            }
            if (operator) {
                names.add(OPERATOR);
            }
            found.forEach(agent -> names.add(agent.name()));
        }
        return Optional.of(names);
    }

    private String[] called(PlannedAgent agent) {
        var names = new LinkedHashSet<>(List.of(agent.role(), agent.name()));
        robots().filter(robot -> agent.robot().filter(robot.spec().id()::equals).isPresent())
                .forEach(robot ->
                        names.addAll(List.of(robot.spec().role(), robot.spec().id())));
        return names.toArray(String[]::new);
    }

    private static List<Word> required(Section section, String key) {
        if (!section.has(key)) {
            section.problem(
                    section.location(),
                    "'%s' is missing: a name or a list of names.".formatted(section.path(key)),
                    "Maybe '%s: all'?".formatted(key));
        }
        return words(section, key);
    }

    /// One name, or a list of them.
    private static List<Word> words(Section section, String key) {
        Optional<Value> value = section.find(key);
        if (value.isEmpty()) {
            return List.of();
        }
        var words = new ArrayList<Word>();
        for (Value item : value.get() instanceof Value.Sequence several ? several.items() : List.of(value.get())) {
            if (item instanceof Value.Scalar(Location at, String text) && !text.isEmpty()) {
                words.add(new Word(text, at));
            } else {
                section.expected(key, "a name or a list of names", item);
            }
        }
        return words;
    }
}
