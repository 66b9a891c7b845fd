package rsal.jadex;

import jadex.bridge.IExternalAccess;
import jadex.bridge.service.types.cms.CreationInfo;
import jadex.commons.future.FutureBarrier;
import jadex.commons.future.IFuture;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.agent.AgentHost;
import rsal.agent.platform.ThreadLane;
import rsal.time.Scheduler;

/// A Jadex platform with a micro agent for each agent, which does in steps what its agent does. What agents say stays
/// ours: Jadex's services stand some eight thousand calls a second, and a hundred robots that tell where they are need
/// ten times that; a conversation by services beside the rest by inboxes would not arrive in the order in which it was
/// said.
final class JadexHost implements AgentHost {
    private final Scheduler run;
    private final IExternalAccess platform;
    private final Map<String, JadexMicroAgent> bodies = new HashMap<>(); // of those that run, by name
    private final List<IFuture<Map<String, Object>>> leaving = new ArrayList<>(); // and not yet gone
    private final Map<String, Integer> lives = new HashMap<>(); // how often there was one of that name, by Jadex's
    private Consumer<String> onKilled = _ -> {};

    JadexHost(Scheduler run, IExternalAccess platform) {
        this.run = run;
        this.platform = platform;
    }

    @Override
    public Scheduler lane(String name) {
        var body = new JadexMicroAgent(name, killed -> run.execute(() -> killed(killed)));
        bodies.put(name, body);
        platform.createComponent(new CreationInfo().setPojo(body).setName(componentName(name)))
                .catchEx(e -> run.exclusively(() -> notMade(body, e)));
        return new ThreadLane(run, body);
    }

    /// One that was ended while Jadex still made it is not missed: that has come in between.
    private void notMade(JadexMicroAgent body, Exception why) {
        if (body.equals(bodies.get(body.name()))) {
            throw new IllegalStateException("Jadex could not make agent '%s'.".formatted(body.name()), why);
        }
    }

    /// Unique, also while one that was called the same still goes, and without what Jadex reads as an address.
    private String componentName(String agent) {
        String plain = agent.replaceAll("[^A-Za-z0-9_-]", "_");
        int life = lives.merge(plain, 1, Integer::sum);
        return life == 1 ? plain : plain + "_" + life;
    }

    /// Jadex has ended it by itself.
    private void killed(JadexMicroAgent body) {
        if (bodies.remove(body.name(), body)) {
            onKilled.accept(body.name());
        }
    }

    @Override
    public void onKilled(Consumer<String> listener) {
        onKilled = listener;
    }

    @Override
    public void end(String name) {
        Optional.ofNullable(bodies.remove(name)).ifPresent(body -> leaving.add(body.end()));
        leaving.removeIf(IFuture::isDone);
    }

    /// The platform ends by its own threads, after its agents: else it leaves timers behind that wait for them.
    @Override
    public void close() {
        var all = new FutureBarrier<Map<String, Object>>();
        leaving.forEach(all::addFuture);
        all.waitForIgnoreFailures(_ -> {}).then(_ -> platform.killComponent());
    }
}
