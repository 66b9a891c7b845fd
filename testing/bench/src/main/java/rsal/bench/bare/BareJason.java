package rsal.bench.bare;

import jason.JasonException;
import jason.NoValueException;
import jason.asSemantics.Agent;
import jason.asSyntax.Literal;
import jason.asSyntax.NumberTerm;
import jason.asSyntax.PredicateIndicator;
import jason.infra.local.LocalAgArch;
import jason.infra.local.RunLocalMAS;
import jason.mas2j.AgentParameters;
import jason.mas2j.MAS2JProject;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import rsal.bare.BareLanguage;
import rsal.jason.JasonDefaults;

/// Jason's own local infrastructure, as `jason team.mas2j --no-net` uses it: a virtual thread and a mailbox for each
/// agent, Jason's timers, the machine's clock. No window, file or port.
///
/// Jason never ends the (virtual) threads of its timers; they stay with the process, idle.
public final class BareJason implements BareLanguage {
    private static final Duration PATIENCE = Duration.ofSeconds(30);

    static {
        JasonDefaults.override();
    }

    @Override
    public String key() {
        return "jason";
    }

    @Override
    public String suffix() {
        return ".asl";
    }

    @Override
    public String text(Program program) {
        try (InputStream in = file(program).openStream()) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static URL file(Program program) {
        String name = program.name().toLowerCase(Locale.ROOT);
        return Objects.requireNonNull(BareJason.class.getResource(name + ".asl"), name);
    }

    @Override
    public Platform start() {
        return new Local();
    }

    private static final class Local implements Platform {
        private final RunLocalMAS system = new RunLocalMAS();
        private List<LocalAgArch> agents = List.of(); // once they have begun

        @Override
        public void start(Map<String, Program> programs) {
            var project = new MAS2JProject();
            project.setupDefault();
            programs.forEach((name, program) -> project.addAgent(agent(name, program)));
            system.setProject(project);
            try {
                system.create();
            } catch (JasonException e) {
                throw new IllegalStateException("Jason could not make the agents: " + e.getMessage(), e);
            }
            for (String name : programs.keySet()) {
                if (!system.getAgs().containsKey(name)) { // it has logged why
                    throw new IllegalStateException("Jason could not make agent '%s'.".formatted(name));
                }
            }
            agents = List.copyOf(system.getAgs().values());
            system.start();
        }

        private static AgentParameters agent(String name, Program program) {
            var agent = new AgentParameters();
            agent.name = name;
            try {
                agent.setSource(file(program).toURI());
            } catch (URISyntaxException e) {
                throw new IllegalStateException("Jason could not find program '%s'.".formatted(program), e);
            }
            return agent;
        }

        /// By the agent's own thread, as others may see a belief away while it is exchanged.
        @Override
        public long count(String agent) {
            var count = new CompletableFuture<Long>();
            var deliberation = system.getAg(agent).getTS();
            deliberation.runAtBeginOfNextCycle(() -> count.complete(count(deliberation.getAg())));
            try {
                return count.get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw new IllegalStateException("Agent '%s' was not waited for.".formatted(agent), e);
            } catch (ExecutionException | TimeoutException e) {
                throw new IllegalStateException("Agent '%s' does not report what it has counted.".formatted(agent), e);
            }
        }

        private static long count(Agent agent) {
            Iterator<Literal> counts = agent.getBB().getCandidateBeliefs(new PredicateIndicator(COUNT, 1));
            try {
                return (long) ((NumberTerm) counts.next().getTerm(0)).solve();
            } catch (NoValueException e) {
                throw new IllegalStateException("The count is not a number.", e);
            }
        }

        @Override
        public void close() {
            system.finish(0, false, 0); // on a thread of its own
            try {
                for (LocalAgArch agent : agents) {
                    if (!agent.getThread().join(PATIENCE)) {
                        throw new IllegalStateException("Agent '%s' does not end.".formatted(agent.getAgName()));
                    }
                }
            } catch (InterruptedException _) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
