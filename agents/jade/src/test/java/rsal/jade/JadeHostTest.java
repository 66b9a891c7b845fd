package rsal.jade;

import rsal.agent.AgentHostProvider;
import rsal.testkit.contract.AgentHostContract;

class JadeHostTest extends AgentHostContract {
    @Override
    protected AgentHostProvider provider() {
        return new JadeHostProvider();
    }
}
