package rsal.agents.team;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agent.board.BoardKeeper;
import rsal.agents.parts.AgentTypeBase;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Keeps a board of notes that a team shares. Needs no robot.
public final class BlackboardMaster extends AgentTypeBase {
    static final Parameter<String> BOARD =
            Parameter.text("board", "team", "Name of the board, by which agents find it.");
    static final Parameter<Integer> MAX_NOTES =
            Parameter.integer("maxNotes", 250, 1, 10_000, "", "Maximum number of notes of one agent.");
    static final Parameter<Integer> MAX_AUTHORS = Parameter.integer(
            "maxAuthors", 1_000, 1, 10_000, "", "Maximum number of agents that have notes on the board.");
    static final Parameter<Integer> MAX_SUBSCRIPTIONS =
            Parameter.integer("maxSubscriptions", 1_000, 0, 10_000, "", "Maximum number of subscriptions.");

    private static final int WATCHES_EACH = 16;

    public BlackboardMaster() {
        super(
                "blackboard",
                "Keeps a shared blackboard for a team: other agents write, query and watch its notes.",
                List.of(BOARD, MAX_NOTES, MAX_AUTHORS, MAX_SUBSCRIPTIONS),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        var limits = new BoardKeeper.Limits(
                arguments.get(MAX_AUTHORS), arguments.get(MAX_NOTES), arguments.get(MAX_SUBSCRIPTIONS), WATCHES_EACH);
        new BoardKeeper(self, arguments.get(BOARD), limits).begin();
    }
}
