package rsal.server.scenario;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import rsal.agent.AgentHostProvider;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.scenario.installed.Providers;
import rsal.scenario.picture.WorldPicture;
import rsal.scenario.text.Folders;
import rsal.server.description.Descriptions;
import rsal.server.message.Messages.HostInfo;
import rsal.server.message.Messages.ScenarioInfo;
import rsal.server.message.Messages.ScenarioText;
import rsal.server.message.Messages.Scenarios;
import rsal.server.message.Refusal;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

/// The scenarios that the page offers: those that were named when it began, no others. A file is read again each
/// time, so that what was written meanwhile counts. May be used from any thread.
public final class ScenarioCatalog {
    private static final Logger LOG = LoggerFactory.getLogger(ScenarioCatalog.class);
    private static final int PICTURE = 640; // longest side [px]

    private final Set<String> ids;
    private final Map<String, Drawn> pictures = new HashMap<>(); // by id

    /// @param written when its file was, in ms since 1970; 0 of what comes with the program
    /// @param png empty when it can't be drawn
    private record Drawn(long written, byte[] png) {}

    /// @param written as of [Drawn], of each
    private record Listed(List<Long> written, Scenarios scenarios) {}

    private @Nullable Listed listed;

    /// @param ids as for [Scenario#load]
    public ScenarioCatalog(List<String> ids) {
        this.ids = Collections.unmodifiableSet(new LinkedHashSet<>(ids));
    }

    /// @throws Refusal when it is not there
    /// @throws InvalidSettings with its errors
    public Scenario load(String id) {
        return Scenario.load(known(id));
    }

    /// The one that a sweep's folder names, which tells no folders of this machine ([Folders]).
    ///
    /// @throws Refusal when it is not there
    public String idOf(String named) {
        return ids.stream()
                .filter(id -> id.equals(named) || Folders.without(id).equals(named))
                .findFirst()
                .orElseThrow(() -> unknown(named));
    }

    /// A scenario with another text than its own.
    ///
    /// @param id left out: the present one
    /// @throws Refusal when it is not there
    /// @throws InvalidSettings with its errors
    public Scenario edited(Optional<String> id, String text, Scenario present) {
        if (id.isEmpty()) {
            return present.edited(text);
        }
        return Scenario.edited(known(id.get()), text);
    }

    /// What a scenario says now, with all its errors.
    ///
    /// @throws Refusal when it is not there, or has none
    public ScenarioText text(String id) {
        try {
            String text = Scenario.written(known(id));
            return new ScenarioText(
                    id, Scenario.fileOf(id), text, Optional.of(text).filter(_ -> isFile(id)));
        } catch (InvalidSettings e) {
            throw new Refusal(404, e);
        }
    }

    /// What the present one says; to be saved as long as its file is here.
    ///
    /// @throws Refusal when it has no text
    public ScenarioText text(Scenario present) {
        if (present.isWorld()) {
            throw new Refusal(404, "'%s' is a world, not a scenario.".formatted(present.name()));
        }
        String file = present.location().file();
        String id = ids.stream().filter(one -> isOf(one, file)).findFirst().orElse("");
        return new ScenarioText(id, file, present.text(), isFile(id) ? written(id) : Optional.empty());
    }

    private static boolean isOf(String id, String file) {
        try {
            return !Scenario.isWorld(id) && Scenario.fileOf(id).equals(file);
        } catch (InvalidSettings _) { // it is gone
            return false;
        }
    }

    /// Empty when its file is gone.
    private static Optional<String> written(String id) {
        try {
            return Optional.of(Scenario.written(id));
        } catch (InvalidSettings _) {
            return Optional.empty();
        }
    }

    private boolean isFile(String id) {
        return ids.contains(id) && !Scenario.builtInNames().contains(id) && !Scenario.isWorld(id);
    }

    /// Writes a scenario's file again, whole or not at all.
    ///
    /// @param before what it must hold until then
    /// @throws Refusal when it is not there or no file, holds something else by now, or can't be written
    public synchronized void save(String id, String before, String text) {
        if (!isFile(known(id))) {
            throw new Refusal(
                    409,
                    "'%s' comes with the program, or is a world: it can't be saved here."
                            .formatted(Refusal.shortened(id)));
        }
        if (!text(id).text().equals(before)) {
            throw new Refusal(
                    409,
                    "File '%s' has changed since it was read. Maybe copy your text, and open it again."
                            .formatted(Refusal.shortened(id)));
        }
        try {
            replace(Path.of(Scenario.fileOf(id)).toRealPath(), text);
        } catch (IOException e) {
            LOG.warn("Scenario ({}) can't be saved.", id, e);
            throw new Refusal(409, "File '%s' can't be written: %s.".formatted(Refusal.shortened(id), e.getMessage()));
        }
    }

    private static void replace(Path file, String text) throws IOException {
        if (!Files.isWritable(file)) {
            throw new IOException("it is read-only");
        }
        Path whole = Files.createTempFile(file.resolveSibling(""), ".rsal-", ".yaml");
        try {
            Files.copy(file, whole, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.COPY_ATTRIBUTES);
            Files.writeString(whole, text); // as its owner's other files: with the same permissions
            Files.move(whole, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } finally {
            Files.deleteIfExists(whole);
        }
    }

    private String known(String id) {
        if (!ids.contains(id)) {
            throw unknown(id);
        }
        return id;
    }

    private static Refusal unknown(String id) {
        return new Refusal(404, "There is no scenario '%s' to be chosen here.".formatted(Refusal.shortened(id)));
    }

    /// Read once for each state of their files, one at a time, as it takes no token to ask for it.
    public synchronized Scenarios all() {
        List<Long> state = ids.stream().map(ScenarioCatalog::lastWritten).toList();
        Listed last = listed;
        if (last == null || !last.written.equals(state)) {
            last = new Listed(state, new Scenarios(ids.stream().map(this::info).toList(), hosts()));
            listed = last;
        }
        return last.scenarios;
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

    /// A PNG of how it begins when nothing is chosen. Made once for each state of its file, one at a time, as it
    /// takes no token to ask for it.
    ///
    /// @throws Refusal when there is none
    public synchronized byte[] picture(String id) {
        long written = lastWritten(known(id));
        Drawn known = pictures.get(id);
        if (known == null || known.written != written) {
            known = new Drawn(written, draw(id));
            pictures.put(id, known);
        }
        if (known.png.length == 0) {
            throw new Refusal(404, "'%s' has no picture.".formatted(Refusal.shortened(id)));
        }
        return known.png;
    }

    /// Of its file, as a folder is none the newer for what is written to a file in it.
    private static long lastWritten(String id) {
        try {
            return new File(Scenario.isWorld(id) ? id : Scenario.fileOf(id)).lastModified();
        } catch (InvalidSettings _) { // it is gone
            return 0;
        }
    }

    private static byte[] draw(String id) {
        try {
            return WorldPicture.of(Scenario.load(id).plan(RunOptions.NONE), PICTURE);
        } catch (InvalidSettings _) {
            return new byte[0]; // those that want to run it are told why that can't be
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
