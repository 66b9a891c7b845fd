package rsal.jadex;

import jadex.bridge.IExternalAccess;
import jadex.bridge.service.types.cms.CreationInfo;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import rsal.agent.bare.BareSystem;
import rsal.agent.bare.Life;

/// Jadex's micro agents, which tell each other their poses by an inbox of each that is read in steps: Jadex's services
/// stand a tenth of that.
public final class BareJadex implements BareSystem {
    @Override
    public String key() {
        return "jadex";
    }

    @Override
    public Platform start() {
        IExternalAccess platform = LonelyPlatform.start();
        var agents = new CopyOnWriteArrayList<BareBody>();
        return new Platform() {
            @Override
            public void start(int count, Life life) {
                List<BareBody> all = Stream.generate(() -> new BareBody(agents, life))
                        .limit(count)
                        .toList();
                agents.addAll(all);
                for (int i = 0; i < count; i++) {
                    platform.createComponent(
                                    new CreationInfo().setPojo(all.get(i)).setName("agent-" + i))
                            .catchEx(e -> {
                                throw new IllegalStateException("Jadex could not make an agent.", e);
                            });
                }
            }

            @Override
            public void say(int times) {
                agents.forEach(agent -> agent.say(times));
            }

            @Override
            public void close() {
                platform.killComponent();
            }
        };
    }
}
