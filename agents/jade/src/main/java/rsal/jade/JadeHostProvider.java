package rsal.jade;

import java.util.Arrays;
import java.util.Collection;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.agent.AgentHost;
import rsal.agent.AgentHostProvider;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.time.Scheduler;

/// Runs agents on a JADE platform inside this process: each on a thread of its own, what they say as ACL messages, what
/// they offer in the directory facilitator. Real time only. Opens no port; JADE's own windows open when asked for.
public final class JadeHostProvider implements AgentHostProvider {
    private static final Set<String> OWN = own();

    /// The management system, the directory facilitator and the windows: FIPA Agent Management Specification,
    /// SC00023, sections 4 and 5.
    private static Set<String> own() {
        return Stream.concat(
                        Stream.of("ams", "df"), Arrays.stream(Tool.values()).map(Tool::agent))
                .collect(Collectors.toUnmodifiableSet());
    }

    @Override
    public String key() {
        return "jade";
    }

    /// No: JADE's agents are threads that wait by the clock of the machine.
    @Override
    public String description() {
        return "Runs agents on JADE in real time: each has a thread, and messages are ACL messages that JADE's"
                + " windows show.";
    }

    @Override
    public boolean followsSchedulerTime() {
        return false;
    }

    @Override
    public List<Parameter<?>> parameters() {
        return Arrays.stream(Tool.values()).<Parameter<?>>map(Tool::parameter).toList();
    }

    /// JADE has agents of its own, and tells names apart without regard to upper and lower case.
    @Override
    public Optional<String> nameProblem(String name, Collection<String> others) {
        if (OWN.contains(name.toLowerCase(Locale.ROOT))) {
            return Optional.of("JADE has an agent '%s' of its own.".formatted(name.toLowerCase(Locale.ROOT)));
        }
        return others.stream()
                .filter(other -> other.equalsIgnoreCase(name) && !other.equals(name))
                .findFirst()
                .map(other -> "JADE can't distinguish '%s' and '%s': they differ only in upper and lower case."
                        .formatted(other, name));
    }

    /// @throws IllegalStateException when JADE can't start
    /// @throws java.io.UncheckedIOException when there is no display for its windows
    @Override
    public AgentHost create(Arguments settings, Scheduler scheduler) {
        var tools = EnumSet.noneOf(Tool.class);
        for (Tool tool : Tool.values()) {
            if (settings.get(tool.parameter())) {
                tools.add(tool);
            }
        }
        return JadeHost.start(scheduler, tools);
    }
}
