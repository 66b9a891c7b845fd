package rsal.agent;

import java.util.concurrent.CompletionStage;

/// An agent whose code runs elsewhere, as in another process, and may need a while for its last words. It lives on for
/// a short time until they are there. Nothing waits for them on its lane.
public interface OutsideAgent extends Agent {
    /// In place of [Agent#stop]. On the agent's lane.
    ///
    /// @return completes on any thread, with what is still to be done on the agent's lane
    CompletionStage<Runnable> lastWords(AgentContext self);
}
