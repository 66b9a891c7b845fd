package own;

import java.util.Map;
import org.junit.jupiter.api.Nested;
import rsal.agent.AgentHostProvider;
import rsal.testkit.contract.AgentHostContract;

class ThreadsTest {
    @Nested
    class WithoutMail extends AgentHostContract {
        @Override
        protected AgentHostProvider provider() {
            return new Threads();
        }
    }

    @Nested
    class WithMail extends AgentHostContract {
        @Override
        protected AgentHostProvider provider() {
            return new Threads();
        }

        @Override
        protected Map<String, Object> settings() {
            return Map.of("mail", true);
        }
    }
}
