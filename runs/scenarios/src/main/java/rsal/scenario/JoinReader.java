package rsal.scenario;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.scenario.installed.Catalog;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.settings.Value;

/// Reads which scenario joins one: `with: distribution:found`, or a group with its arguments, and which of the robots
/// here stand for its own.
final class JoinReader {
    static final String KEY = "with";

    private final Scenario host;
    private final Catalog catalog;
    private final Problems problems;

    JoinReader(Scenario host, Catalog catalog, Problems problems) {
        this.host = host;
        this.catalog = catalog;
        this.problems = problems;
    }

    /// @param root of the scenario that is joined
    /// @return empty when none joins it, or it can't be read
    Optional<Joined> read(Section root) {
        Optional<Value> with = root.find(KEY);
        if (with.isEmpty()) {
            return Optional.empty();
        }
        Optional<Value.Mapping> asGroup = asGroup(with.get());
        if (asGroup.isEmpty()) {
            root.expected(KEY, "a scenario, or a group with one", with.get());
            return Optional.empty();
        }
        var group = new Section(KEY, asGroup.get(), problems);
        String reference = group.text("scenario");
        Location at = group.locationOf("scenario");
        Section args = group.section(Format.ARGUMENTS);
        Section robots = group.section("robots");
        group.done();
        if (reference.isEmpty()) {
            return Optional.empty();
        }
        int colon = reference.lastIndexOf(':');
        String name = colon < 0 ? reference : reference.substring(0, colon);
        Optional<Scenario> other = scenario(name, at);
        return other.flatMap(found -> configuration(found, colon < 0 ? "" : reference.substring(colon + 1), at)
                .flatMap(chosen -> joined(found, chosen, !Scenario.isBuiltIn(name), at, args, robots)));
    }

    /// `distribution` is short for `{scenario: distribution}`.
    private static Optional<Value.Mapping> asGroup(Value with) {
        return switch (with) {
            case Value.Mapping group -> Optional.of(group);
            case Value.Scalar(Location at, String name)
            when !name.isEmpty() ->
                Optional.of(
                        new Value.Mapping(at, Map.of("scenario", new Value.Scalar(at, name)), Map.of("scenario", at)));
            default -> Optional.empty();
        };
    }

    private Optional<Scenario> scenario(String name, Location at) {
        try {
            if (Scenario.isBuiltIn(name)) {
                return Optional.of(Scenario.load(name));
            }
            if (name.endsWith(".yaml") || name.endsWith(".yml")) {
                return Optional.of(Scenario.beside(host, name, at));
            }
            problems.add(
                    at,
                    "There is no scenario '%s'.".formatted(name),
                    Suggestion.among(name, Scenario.builtInNames())
                            + " Name your own scenario by its file, which must be in the folder of this one.");
        } catch (InvalidSettings e) {
            problems.addAll(e);
        }
        return Optional.empty();
    }

    private Optional<Configuration> configuration(Scenario other, String name, Location at) {
        List<Configuration> all = other.configurations();
        Optional<Configuration> found = name.isEmpty()
                ? Optional.of(all.getFirst())
                : all.stream().filter(one -> one.name().equals(name)).findFirst();
        if (found.isEmpty()) {
            problems.add(
                    at,
                    "Scenario '%s' has no configuration '%s'.".formatted(other.name(), name),
                    Suggestion.among(name, all.stream().map(Configuration::name).toList()));
        }
        return found;
    }

    /// @param isBeside whether it lies in the folder of the one that it joins
    private Optional<Joined> joined(
            Scenario other, Configuration configuration, boolean isBeside, Location at, Section args, Section robots) {
        Value.Mapping merged = other.settings(configuration.name());
        Map<String, Value> agents = withoutRobot(merged);
        String name = other.name() + ":" + configuration.name();
        if (agents.isEmpty()) {
            problems.add(
                    at,
                    "Scenario '%s' has no agents without a robot, and nothing else of it comes along.".formatted(name),
                    "Add its agents here, for robots of this scenario.");
            return Optional.empty();
        }
        Map<String, Object> values = arguments(other, configuration, args);
        var placed = new LinkedHashMap<String, Map<String, String>>();
        var all = new Section(
                "agents",
                new Value.Mapping(other.settings().location(), agents, Map.of()),
                new Problems()); // they are read again, with their arguments
        agents.keySet()
                .forEach(agent ->
                        placed.put(agent, Joined.placed(all.section(agent).section(Format.PARAMETERS))));
        var stands = new LinkedHashMap<String, String>();
        var saidAt = new LinkedHashMap<String, Location>();
        for (String role : robots.names()) {
            String here = robots.text(role);
            if (!here.isEmpty()) {
                stands.put(role, here);
                saidAt.put(role, robots.locationOf(role));
            }
        }
        var world = new Section("", merged, new Problems()).section("world");
        String map = world.text(world.has("map") ? "map" : "file", "");
        return Optional.of(new Joined(
                at,
                name,
                other.files(),
                ArgumentReader.replace(all.mapping(), other.arguments(), values, problems),
                placed,
                args.names(),
                map,
                catalog.maps().contains(map) || isBeside,
                world.has("file")
                        ? Optional.empty()
                        : Optional.of(group(merged, "robots").entries().keySet()),
                stands,
                saidAt));
    }

    private static Map<String, Value> withoutRobot(Value.Mapping settings) {
        var agents = new LinkedHashMap<String, Value>();
        group(settings, "agents").entries().forEach((name, agent) -> {
            if (agent instanceof Value.Mapping own && own.find("robot").isEmpty()) {
                agents.put(name, own);
            }
        });
        return agents;
    }

    /// An empty one when it is not given, or no group.
    private static Value.Mapping group(Value.Mapping settings, String key) {
        return settings.find(key)
                .filter(Value.Mapping.class::isInstance)
                .map(Value.Mapping.class::cast)
                .orElseGet(() -> Value.Mapping.empty(settings.location()));
    }

    private Map<String, Object> arguments(Scenario other, Configuration configuration, Section args) {
        var values = new LinkedHashMap<String, Object>();
        other.arguments()
                .forEach(parameter -> parameter.fallback().ifPresent(value -> values.put(parameter.name(), value)));
        var section =
                new Section("configurations." + configuration.name(), other.overlay(configuration.name()), problems);
        values.putAll(ArgumentReader.overridden(other.arguments(), section.section(Format.ARGUMENTS)));
        values.putAll(ArgumentReader.overridden(other.arguments(), args));
        return values;
    }
}
