package rsal.jason;

import rsal.agent.AgentHostProvider;
import rsal.testkit.contract.RepeatableHostContract;

class JasonHostTest extends RepeatableHostContract {
    @Override
    protected AgentHostProvider provider() {
        return new JasonHostProvider();
    }
}
