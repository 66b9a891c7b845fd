package rsal.server;

import java.io.UncheckedIOException;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import rsal.agent.AgentHostProvider;
import rsal.scenario.Providers;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.scenario.picture.WorldPicture;
import rsal.server.Messages.HostInfo;
import rsal.server.Messages.ScenarioInfo;
import rsal.server.Messages.Scenarios;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

/// The scenarios that the page offers: those that come with the program, and files that were named when it began, no
/// others. A file is read anew each time, so that what was written meanwhile counts. May be used from any thread.
final class Shelf {
    private static final int PICTURE = 640; // longest side [px]

    private final Set<String> ids = new LinkedHashSet<>(); // never changed later
    private final Map<String, byte[]> pictures = new ConcurrentHashMap<>(); // by id

    /// @param files of a person's own, as for [Scenario#load]
    Shelf(List<String> files) {
        ids.addAll(files);
        Scenario.builtIn().forEach(scenario -> ids.add(scenario.name()));
    }

    /// @throws Refusal when it is not there
    /// @throws InvalidSettings with its mistakes
    Scenario load(String id) {
        if (!ids.contains(id)) {
            throw new Refusal(
                    404, "There is no scenario (%s) here; there are %s.".formatted(Refusal.shortened(id), ids));
        }
        return Scenario.load(id);
    }

    Scenarios all() {
        return new Scenarios(ids.stream().map(this::info).toList(), hosts());
    }

    private ScenarioInfo info(String id) {
        try {
            Scenario scenario = load(id);
            return new ScenarioInfo(
                    id, scenario.title(), scenario.description(), Descriptions.configurations(scenario), "");
        } catch (InvalidSettings e) {
            Problem first = e.problems().getFirst();
            return new ScenarioInfo(id, id, "", List.of(), "%s: %s".formatted(first.location(), first.message()));
        }
    }

    /// A PNG of how it begins when nothing is chosen; made once.
    ///
    /// @throws Refusal when it can't be drawn
    byte[] picture(String id) {
        byte[] known = pictures.get(id);
        if (known != null) {
            return known;
        }
        try {
            byte[] drawn = WorldPicture.of(load(id).plan(RunOptions.NONE), PICTURE);
            pictures.put(id, drawn);
            return drawn;
        } catch (InvalidSettings e) {
            throw new Refusal(404, "(%s) can't be run, so it has no picture.".formatted(Refusal.shortened(id)));
        } catch (UncheckedIOException e) {
            throw new Refusal(404, "No pictures can be drawn here. %s".formatted(e.getMessage()));
        }
    }

    private static List<HostInfo> hosts() {
        return Providers.byKey(AgentHostProvider.class, AgentHostProvider::key).values().stream()
                .map(host -> new HostInfo(host.key(), host.description(), !host.followsSchedulerTime()))
                .toList();
    }

    static boolean livesInRealTime(String host) {
        return hosts().stream().anyMatch(known -> known.key().equals(host) && known.realTime());
    }
}
