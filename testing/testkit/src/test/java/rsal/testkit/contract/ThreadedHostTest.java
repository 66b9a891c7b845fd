package rsal.testkit.contract;

import org.junit.jupiter.api.Nested;
import rsal.agent.AgentHostProvider;

/// Keeps the contract itself, and what hosts with threads build on, as they should be.
class ThreadedHostTest {
    @Nested
    class OnThreads extends AgentHostContract {
        @Override
        protected AgentHostProvider provider() {
            return new ThreadedHost.Provider(false);
        }
    }

    @Nested
    class CarryingWhatIsSaid extends AgentHostContract {
        @Override
        protected AgentHostProvider provider() {
            return new ThreadedHost.Provider(true);
        }
    }
}
