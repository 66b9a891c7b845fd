package rsal.server;

import java.io.File;
import java.io.UncheckedIOException;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
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

/// The scenarios that the page offers: those that were named when it began, no others. A file is read anew each time,
/// so
/// that what was written meanwhile counts. May be used from any thread.
final class Shelf {
    private static final Logger LOG = LoggerFactory.getLogger(Shelf.class);
    private static final int PICTURE = 640; // longest side [px]

    private final Set<String> ids;
    private final Map<String, Drawn> pictures = new HashMap<>(); // by id

    /// @param written when its file was, in ms since 1970; 0 of what comes with the program
    /// @param png empty when it can't be drawn
    private record Drawn(long written, byte[] png) {}

    /// @param ids as for [Scenario#load]
    Shelf(List<String> ids) {
        this.ids = Collections.unmodifiableSet(new LinkedHashSet<>(ids));
    }

    /// @throws Refusal when it is not there
    /// @throws InvalidSettings with its mistakes
    Scenario load(String id) {
        if (!ids.contains(id)) {
            throw unknown(id);
        }
        return Scenario.load(id);
    }

    private static Refusal unknown(String id) {
        return new Refusal(404, "There is no scenario (%s) to be chosen here.".formatted(Refusal.shortened(id)));
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

    /// A PNG of how it begins when nothing is chosen. Made once for each state of its file, one at a time, as it takes
    /// no
    /// token to ask for it.
    ///
    /// @throws Refusal when there is none
    synchronized byte[] picture(String id) {
        if (!ids.contains(id)) {
            throw unknown(id);
        }
        long written = new File(id).lastModified();
        Drawn known = pictures.get(id);
        if (known == null || known.written != written) {
            known = new Drawn(written, draw(id));
            pictures.put(id, known);
        }
        if (known.png.length == 0) {
            throw new Refusal(404, "(%s) has no picture.".formatted(Refusal.shortened(id)));
        }
        return known.png;
    }

    private static byte[] draw(String id) {
        try {
            return WorldPicture.of(Scenario.load(id).plan(RunOptions.NONE), PICTURE);
        } catch (InvalidSettings _) {
            return new byte[0]; // whoever wants to run it is told why that can't be
        } catch (UncheckedIOException e) {
            LOG.warn("Pictures of scenarios can't be drawn here. {}", e.getMessage());
            return new byte[0];
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
