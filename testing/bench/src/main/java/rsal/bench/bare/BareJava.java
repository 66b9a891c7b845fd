package rsal.bench.bare;

import java.util.Collections;
import java.util.List;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import rsal.bare.BareContracts;
import rsal.bare.BareSystem;
import rsal.bare.Life;
import rsal.data.Pose2d;

/// What a Java programmer writes who has no multi-agent system, beside our host `plain`: one thread, and a task of it
/// for each message that one hears.
public final class BareJava implements BareSystem {
    @Override
    public String key() {
        return "plain";
    }

    @Override
    public Platform start() {
        ScheduledExecutorService thread = Executors.newSingleThreadScheduledExecutor();
        return new Platform() {
            private List<Teller> agents = List.of(); // of the thread, once it has begun

            @Override
            public void start(int count, Life life) {
                thread.execute(() -> {
                    agents =
                            Stream.generate(() -> new Teller(life)).limit(count).toList();
                    agents.forEach(this::begin);
                });
            }

            private void begin(Teller agent) {
                long period = agent.life.period().toNanos();
                if (period > 0) {
                    var _ = thread.scheduleAtFixedRate(() -> publish(agent), period, period, TimeUnit.NANOSECONDS);
                }
                agent.life.begun().run();
            }

            private void publish(Teller speaker) {
                for (Teller agent : agents) {
                    if (agent != speaker) {
                        thread.execute(() -> agent.hear(POSE));
                    }
                }
            }

            @Override
            public void say(int times) {
                thread.execute(() -> {
                    for (int i = 0; i < times; i++) {
                        agents.forEach(this::publish);
                    }
                });
            }

            @Override
            public void contract(int bidders, Runnable ended) {
                BareContracts.begin(thread, Collections.nCopies(bidders, thread), ended);
            }

            @Override
            public void close() {
                thread.shutdownNow();
            }
        };
    }

    private static final class Teller {
        private final Life life;

        @SuppressWarnings("UnusedVariable") // to keep it is what each has to do with a message
        private Pose2d other = POSE;

        Teller(Life life) {
            this.life = life;
        }

        void hear(Pose2d pose) {
            other = pose;
            life.heard().run();
        }
    }
}
