package rsal.scenario;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.TreeMap;
import java.util.function.Function;
import rsal.agent.AgentHostProvider;
import rsal.agent.AgentType;
import rsal.map.Maps;
import rsal.robot.DeviceDriver;
import rsal.robot.RobotModels;
import rsal.robot.RobotSystemProvider;
import rsal.settings.Location;
import rsal.settings.Problems;
import rsal.settings.Suggestion;

/// What scenarios can name in this installation, by key, in the order of the keys.
record Catalog(
        Map<String, RobotSystemProvider> systems,
        Map<String, AgentHostProvider> hosts,
        Map<String, DeviceDriver> drivers,
        Map<String, AgentType> agents,
        List<String> models,
        List<String> parts,
        List<String> maps) {

    static Catalog installed() {
        return new Catalog(
                byKey(ServiceLoader.load(RobotSystemProvider.class), RobotSystemProvider::key),
                byKey(ServiceLoader.load(AgentHostProvider.class), AgentHostProvider::key),
                byKey(ServiceLoader.load(DeviceDriver.class), DeviceDriver::key),
                byKey(ServiceLoader.load(AgentType.class), AgentType::key),
                RobotModels.builtIn(),
                RobotModels.builtInParts(),
                Maps.builtIn());
    }

    /// One of those by key, or a problem that says which there are.
    ///
    /// @param what to call it in the message
    static <P> Optional<P> find(String what, Map<String, P> known, String key, Location at, Problems problems) {
        Optional<P> found = Optional.ofNullable(known.get(key));
        if (found.isEmpty()) {
            problems.add(at, "There is no %s (%s).".formatted(what, key), Suggestion.among(key, known.keySet()));
        }
        return found;
    }

    private static <P> Map<String, P> byKey(Iterable<P> providers, Function<P, String> key) {
        var byKey = new TreeMap<String, P>();
        providers.forEach(provider -> byKey.putIfAbsent(key.apply(provider), provider));
        return Collections.unmodifiableMap(byKey);
    }
}
