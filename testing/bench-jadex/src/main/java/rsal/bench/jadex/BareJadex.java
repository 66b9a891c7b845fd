package rsal.bench.jadex;

import jadex.bridge.IExternalAccess;
import jadex.bridge.service.types.cms.CreationInfo;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rsal.bare.BareContracts;
import rsal.bare.BareSystem;
import rsal.bare.Life;
import rsal.jadex.JadexMicroAgent;
import rsal.jadex.LonelyPlatform;

/// Jadex's micro agents, which talk by an inbox of each that is read in steps: Jadex's services stand a tenth of that
/// when each tells all others its pose. Jadex has no contract net; by its services one is slower, too.
public final class BareJadex implements BareSystem {
    @Override
    public String key() {
        return "jadex";
    }

    @Override
    public Platform start() {
        IExternalAccess platform = LonelyPlatform.start();
        var agents = new CopyOnWriteArrayList<BareBody>();
        var bodies = new CopyOnWriteArrayList<JadexMicroAgent>(); // handed tasks
        return new Platform() {
            @Override
            public void start(int count, Life life) {
                List<BareBody> all = Stream.generate(() -> new BareBody(agents, life))
                        .limit(count)
                        .toList();
                agents.addAll(all);
                for (int i = 0; i < count; i++) {
                    create(all.get(i), "agent-" + i);
                }
            }

            @Override
            public void say(int times) {
                agents.forEach(agent -> agent.say(times));
            }

            @Override
            public void contract(int bidders, Runnable ended) {
                List<JadexMicroAgent> all = IntStream.range(0, bidders)
                        .mapToObj(i -> body("bidder-" + i))
                        .toList();
                BareContracts.begin(body("manager"), all, ended);
            }

            private JadexMicroAgent body(String name) {
                var body = new JadexMicroAgent(name, _ -> {});
                bodies.add(body);
                create(body, name);
                return body;
            }

            private void create(Object agent, String name) {
                platform.createComponent(new CreationInfo().setPojo(agent).setName(name))
                        .catchEx(e -> {
                            throw new IllegalStateException("Jadex could not make agent '%s'.".formatted(name), e);
                        });
            }

            @Override
            public void close() {
                bodies.forEach(JadexMicroAgent::end);
                platform.killComponent();
            }
        };
    }
}
