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
    static final Parameter<Integer> NOTES =
            Parameter.integer("notes", 250, 1, 10_000, "", "How many notes one agent may have on it.");
    static final Parameter<Integer> AUTHORS =
            Parameter.integer("authors", 1_000, 1, 10_000, "", "How many agents may have notes on it.");
    static final Parameter<Integer> WATCHES =
            Parameter.integer("watches", 1_000, 0, 10_000, "", "How many may be told what changes on it.");

    private static final int WATCHES_EACH = 16;

    public BlackboardMaster() {
        super(
                "blackboard",
                "Keeps a board of notes for the team, which others write, ask for and watch.",
                List.of(BOARD, NOTES, AUTHORS, WATCHES),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        var limits = new BoardKeeper.Limits(
                arguments.get(AUTHORS), arguments.get(NOTES), arguments.get(WATCHES), WATCHES_EACH);
        new BoardKeeper(self, arguments.get(BOARD), limits).begin();
    }
}
