package rsal.cli.page;

import picocli.CommandLine.Command;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.Subcommand;
import tools.jackson.databind.JsonNode;

/// `rsal agent`
@Command(
        name = "agent",
        description = "Ask about agents of a run that has a page.",
        synopsisSubcommandLabel = "COMMAND",
        subcommands = AgentCommand.Mind.class)
public final class AgentCommand extends Subcommand {
    @Override
    protected int run() {
        throw new ParameterException(spec.commandLine(), "Name what to show: 'rsal agent mind NAME'.");
    }

    /// `rsal agent mind`
    @Command(
            name = "mind",
            description = "Show the state, beliefs, goals and conversations of an agent, and its newest received"
                    + " messages.%nThis changes nothing in the run.")
    static final class Mind extends PageCommand {
        @Parameters(paramLabel = "NAME", description = "Name of the agent, as the page lists it.")
        private String name = "";

        @Override
        protected int run() throws InterruptedException {
            JsonNode agent = ask("/api/agent?name=" + quoted(name));
            if (json) {
                printJson(agent);
            } else {
                out().print(ShownMind.text(name, agent));
                out().flush();
            }
            return Exit.SUCCESS;
        }
    }
}
