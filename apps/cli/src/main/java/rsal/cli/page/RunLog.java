package rsal.cli.page;

import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.slf4j.event.Level;
import org.slf4j.spi.LoggingEventBuilder;
import rsal.cli.terminal.Logging;
import rsal.engine.LiveRun;
import rsal.engine.report.RunEvent;
import rsal.scenario.RunPlan.PlannedAgent;

/// Tells the log what happens in a run: its events, each with the run, the simulated time and the robot or agent that
/// it is about. Warnings are what an operator should look at. Messages of agents are logged by level `debug` only.
final class RunLog {
    private static final Logger LOG = LoggerFactory.getLogger(Logging.EVENTS);
    private static final Set<String> WARNINGS =
            Set.of("collision", "fault", "health", "uncaught", "unhandled", "unreached");
    private static final String MESSAGE = "message";

    private final LiveRun run;
    private final String name;
    private final Set<String> robots;
    private final Map<String, String> robotsOfAgents;
    private long last;

    private RunLog(LiveRun run) {
        this.run = run;
        name = "%s:%s#%d"
                .formatted(
                        run.plan().scenario().name(),
                        run.plan().configuration(),
                        run.plan().seed());
        robots = run.plan().robots().stream().map(robot -> robot.spec().id()).collect(Collectors.toSet());
        robotsOfAgents = run.plan().agents().stream()
                .filter(agent -> agent.robot().isPresent())
                .collect(Collectors.toMap(
                        PlannedAgent::name, agent -> agent.robot().orElseThrow()));
    }

    /// Until the run ends.
    static void follow(LiveRun run) {
        if (LOG.isWarnEnabled()) {
            var log = new RunLog(run);
            run.onEvents(log::print);
            run.result().whenComplete((_, _) -> log.print());
        }
    }

    /// On threads of the run and of who asks, one at a time.
    private synchronized void print() {
        for (RunEvent event : run.events(last)) {
            last = event.sequence();
            print(event);
        }
    }

    private void print(RunEvent event) {
        LoggingEventBuilder entry = LOG.atLevel(level(event.kind()))
                .addKeyValue("run", name)
                .addKeyValue("simulatedSeconds", event.time().toNanos() / 1e9)
                .addKeyValue("kind", event.kind());
        String subject = event.subject();
        int slash = subject.indexOf('/');
        if (robots.contains(subject)) {
            entry = entry.addKeyValue("robot", subject);
        } else if (slash >= 0 && robots.contains(subject.substring(0, slash))) {
            entry = entry.addKeyValue("robot", subject.substring(0, slash))
                    .addKeyValue("device", subject.substring(slash + 1));
        } else if (!subject.isEmpty()) {
            entry = entry.addKeyValue("agent", subject);
            if (robotsOfAgents.containsKey(subject)) {
                entry = entry.addKeyValue("robot", robotsOfAgents.get(subject));
            }
        }
        entry.log(event.text());
    }

    private static Level level(String kind) {
        if (WARNINGS.contains(kind)) {
            return Level.WARN;
        }
        return kind.equals(MESSAGE) ? Level.DEBUG : Level.INFO;
    }
}
