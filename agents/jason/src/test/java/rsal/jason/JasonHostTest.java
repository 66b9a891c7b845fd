package rsal.jason;

import rsal.agent.AgentHostProvider;
import rsal.testkit.contract.AgentHostContract;

class JasonHostTest extends AgentHostContract {
    @Override
    protected AgentHostProvider provider() {
        return new JasonProvider();
    }
}
