package rsal.jade;

import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import rsal.agent.Agent;
import rsal.agent.platform.AgentPlatform;
import rsal.testkit.contract.HostRun;

/// Agents of ours on JADE, and JADE agents of the test among them.
final class JadeRun implements AutoCloseable {
    private JadeHost host; // of the run
    private final HostRun run = HostRun.inRealTime(time -> host = JadeHost.start(time, Set.of()));

    AgentPlatform platform() {
        return run.platform();
    }

    void start(String name, Agent agent) {
        run.start(name, agent);
    }

    /// A JADE agent that listens to some topics.
    Witness witness(String name, String... topics) {
        var witness = new Witness(topics);
        host.platform().start(name, witness);
        witness.waitUntilStarted();
        return witness;
    }

    void act(Runnable deed) {
        run.act(deed);
    }

    <T> T ask(Supplier<T> question) {
        return run.ask(question);
    }

    void until(String what, BooleanSupplier done) {
        run.until(what, done);
    }

    @Override
    public void close() {
        run.close();
    }
}
