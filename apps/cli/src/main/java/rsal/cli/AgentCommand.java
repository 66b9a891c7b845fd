package rsal.cli;

import java.util.Locale;
import picocli.CommandLine.Command;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import tools.jackson.databind.JsonNode;

/// `rsal agent`
@Command(
        name = "agent",
        description = "Ask about agents of a run that has a page.",
        synopsisSubcommandLabel = "COMMAND",
        subcommands = AgentCommand.Mind.class)
final class AgentCommand extends Subcommand {
    @Override
    int run() {
        throw new ParameterException(spec.commandLine(), "Say what about them: 'rsal agent mind NAME'.");
    }

    /// `rsal agent mind`
    @Command(
            name = "mind",
            description = "Show what an agent believes, wants and talks about now. Looking changes nothing in the run.")
    static final class Mind extends PageCommand {
        @Parameters(paramLabel = "NAME", description = "The agent's, as the page lists it.")
        private String name = "";

        @Override
        int run() throws InterruptedException {
            JsonNode agent = ask("/api/agent?name=" + quoted(name));
            if (json) {
                printJson(agent);
            } else {
                out().print(text(agent));
                out().flush();
            }
            return Exit.SUCCESS;
        }

        private String text(JsonNode agent) {
            var text = new StringBuilder();
            JsonNode mind = agent.path("mind");
            if (mind.isMissingNode() || mind.isNull()) {
                text.append("(%s) shows no mind: it does not run, or has none.%n".formatted(name));
            } else {
                text.append("Believes\n");
                var beliefs = new Table("  ");
                mind.path("beliefs")
                        .forEach(belief -> beliefs.row(
                                belief.path("name").asString(),
                                belief.path("value").asString()));
                text.append(beliefs.isEmpty() ? "  nothing\n" : beliefs).append("Wants\n");
                var goals = new Table("  ");
                mind.path("goals").forEach(goal -> goals.row(goalRow(goal)));
                text.append(goals.isEmpty() ? "  nothing\n" : goals);
            }
            var talks = new Table("  ");
            agent.path("talks")
                    .forEach(talk -> talks.row(
                            String.format(
                                    Locale.ROOT, "%.1f s", talk.path("time").asDouble()),
                            talk.path("from").asString() + " → "
                                    + talk.path("to").asString(),
                            talk.path("act").asString(),
                            talk.path("words").asString()));
            if (!talks.isEmpty()) {
                text.append("Talks\n").append(talks);
            }
            return text.toString();
        }

        private static String[] goalRow(JsonNode goal) {
            String state =
                    goal.path("state").asString().toLowerCase(Locale.ROOT).replace('_', ' ');
            String failure = goal.path("failure").asString();
            return new String[] {
                goal.path("name").asString(), state, failure.isEmpty() ? "" : "failed: " + failure,
            };
        }
    }
}
