package rsal.cli;

import java.util.Locale;
import java.util.stream.Collectors;
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
            description =
                    "Show what an agent does, believes, wants and talks about now, and what has reached it lately.%nLooking changes nothing in the run.")
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
            boolean hasMind = !mind.isMissingNode() && !mind.isNull();
            String state = agent.path("state").asString("");
            section(text, "Does", state.isEmpty() ? "" : "  %s%n".formatted(state));
            section(text, "Believes", beliefs(hasMind ? mind.path("beliefs") : agent.path("shown")));
            if (hasMind) {
                section(text, "Wants", goals(mind.path("goals")));
            }
            section(text, "History", history(agent.path("history")));
            section(text, "Talks", talks(agent.path("talks")));
            section(text, "Mailbox", mail(agent.path("mail")));
            if (!hasMind) {
                text.append(
                        agent.path("status").asString("").equals("RUNNING")
                                ? "(%s) tells no goals; what it does and believes is what it shows.%n".formatted(name)
                                : "(%s) does not run.%n".formatted(name));
            }
            return text.toString();
        }

        private static void section(StringBuilder text, String title, String lines) {
            if (!lines.isEmpty()) {
                text.append(title).append('\n').append(lines);
            }
        }

        private static String beliefs(JsonNode beliefs) {
            var lines = new Table("  ");
            beliefs.forEach(belief -> lines.row(
                    belief.path("name").asString(), belief.path("value").asString()));
            return lines.toString();
        }

        /// Each with what is done for it, the ways that it has, and why the last one failed.
        private static String goals(JsonNode goals) {
            var lines = new Table("  ");
            goals.forEach(goal -> {
                lines.row(
                        goal.path("state").asString().toLowerCase(Locale.ROOT).replace('_', ' '),
                        "%s (%s)"
                                .formatted(
                                        goal.path("name").asString(),
                                        goal.path("urgency").asString()));
                also(lines, "does: ", joined(goal.path("steps"), " > "));
                also(lines, "ways: ", joined(goal.path("plans"), ", "));
                also(lines, "failed: ", goal.path("failure").asString());
            });
            return lines.toString();
        }

        private static void also(Table lines, String title, String words) {
            if (!words.isEmpty()) {
                lines.row("", "  " + title + words);
            }
        }

        private static String joined(JsonNode words, String between) {
            return words.valueStream().map(JsonNode::asString).collect(Collectors.joining(between));
        }

        private static String history(JsonNode history) {
            var lines = new Table("  ");
            history.forEach(change -> lines.row(
                    seconds(change),
                    change.path("kind").asString().toLowerCase(Locale.ROOT),
                    change.path("name").asString(),
                    change.path("words").asString()));
            return lines.toString();
        }

        private static String talks(JsonNode talks) {
            var lines = new Table("  ");
            talks.forEach(talk -> lines.row(
                    seconds(talk),
                    talk.path("from").asString() + " → " + talk.path("to").asString(),
                    talk.path("act").asString(),
                    talk.path("words").asString()));
            return lines.toString();
        }

        private static String mail(JsonNode mail) {
            var lines = new Table("  ");
            mail.forEach(one -> lines.row(
                    seconds(one),
                    one.path("from").asString() + (one.path("forAll").asBoolean() ? " → all" : ""),
                    one.path("topic").asString(),
                    one.path("words").asString()));
            return lines.toString();
        }

        private static String seconds(JsonNode said) {
            return String.format(Locale.ROOT, "%.1f s", said.path("time").asDouble());
        }
    }
}
