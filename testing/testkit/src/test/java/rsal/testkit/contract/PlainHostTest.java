package rsal.testkit.contract;

import java.util.ServiceLoader;
import rsal.agent.AgentHostProvider;

class PlainHostTest extends RepeatableHostContract {
    @Override
    protected AgentHostProvider provider() {
        return ServiceLoader.load(AgentHostProvider.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(host -> host.key().equals("plain"))
                .findFirst()
                .orElseThrow();
    }
}
