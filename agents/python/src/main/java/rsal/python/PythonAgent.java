package rsal.python;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.agent.OutsideAgent;
import rsal.agent.OutsideCode;
import rsal.device.Device;
import rsal.robot.Robot;
import rsal.time.Phase;

/// A proxy of an agent that lives in a process of Python. What happens to it is sent there; what it asks for meanwhile
/// is done here, on its lane. Its own code runs nowhere else, so that radios, faults, recordings and the page see an
/// agent like any other.
final class PythonAgent implements OutsideAgent {
    private final PythonType type;
    private final Map<String, Object> arguments;
    private @Nullable Life life;

    /// What it has once it has started.
    private record Life(
            AgentContext self,
            PythonWorker worker,
            int number,
            PythonRequests requests,
            Lateness lateness,
            CompletableFuture<Void> ended) {
        Instant now() {
            return self.scheduler().instant();
        }
    }

    /// @param arguments values of its parameters, by name
    PythonAgent(PythonType type, Map<String, Object> arguments) {
        this.type = type;
        this.arguments = arguments;
    }

    @Override
    public void start(AgentContext self) {
        PythonWorker worker = PythonWorker.enter(self.scheduler().run());
        var requests = new PythonRequests(self, this::deliver);
        int number = worker.number(self.name());
        var own =
                new Life(self, worker, number, requests, new Lateness(self, worker, number), new CompletableFuture<>());
        life = own;
        self.atEnd(() -> end(own));
        self.outside(new OutsideCode() {
            @Override
            public Optional<String> place() {
                return worker.place(number);
            }

            @Override
            public boolean isDebugged() {
                return worker.isDebugged();
            }

            @Override
            public void kill() {
                worker.kill();
            }
        });
        var words = Map.of("agent", number, "start", described(own));
        if (worker.postman().isEmpty()) {
            worker.turns().start(number, own.now(), words, requests);
        } else {
            post(own, 0, false, turns -> turns.start(number, own.now(), words, new FarPeer(own)));
        }
    }

    private Map<String, Object> described(Life own) {
        AgentContext self = own.self;
        var words = new LinkedHashMap<String, Object>();
        words.put("files", type.sources().texts());
        words.put("folder", type.sources().folder());
        words.put("module", type.sources().module());
        words.put("class", type.className());
        words.put("name", self.name());
        words.put("role", self.role());
        words.put("seed", own.requests.seed());
        words.put("simulation", own.requests.simulation().isPresent());
        words.put("robot", own.requests.robot().map(PythonAgent::described));
        words.put("arguments", arguments);
        return words;
    }

    private static Map<String, Object> described(Robot robot) {
        var words = new LinkedHashMap<String, Object>();
        words.put("id", robot.id());
        words.put("role", robot.role());
        words.put("model", robot.model().name());
        var devices = new ArrayList<Map<String, Object>>();
        for (int i = 0; i < robot.devices().size(); i++) {
            Device device = robot.devices().get(i);
            List<String> contracts = DeviceCalls.of(device);
            for (String contract : contracts.isEmpty() ? List.of("Device") : contracts) {
                devices.add(Map.of("index", i, "name", device.info().name(), "contract", contract));
            }
        }
        words.put("devices", devices);
        return words;
    }

    @Override
    public CompletionStage<Runnable> lastWords(AgentContext self) {
        Life own = life;
        life = null; // it hears of nothing that happens after that
        Runnable nothing = () -> {};
        if (own == null) {
            return CompletableFuture.completedFuture(nothing);
        }
        if (own.worker.postman().isEmpty()) {
            own.worker.turns().stop(own.number, own.now(), own.requests);
            return CompletableFuture.completedFuture(nothing);
        }
        var words = new LastWords(own.requests);
        var said = new CompletableFuture<Runnable>();
        post(own, 0, false, turns -> {
            try {
                turns.stop(own.number, own.now(), words);
                said.complete(words);
            } catch (RuntimeException e) {
                said.complete(() -> {
                    words.run();
                    throw e;
                });
            }
        });
        return said;
    }

    /// What Python asks for when its agent is stopped in real time.
    private static final class LastWords implements PythonTurns.Peer, Runnable {
        private final PythonRequests requests;
        private final List<Object> all = new ArrayList<>();

        LastWords(PythonRequests requests) {
            this.requests = requests;
        }

        @Override
        public void perform(List<?> asked) {
            all.addAll(asked);
        }

        @Override
        public @Nullable Object answer(List<?> asked) {
            throw new IllegalStateException("The agent is stopped and can't be asked any more.");
        }

        @Override
        public void run() {
            requests.perform(all);
        }
    }

    private static void end(Life own) {
        own.ended.complete(null);
        own.worker
                .postman()
                .ifPresentOrElse(
                        postman -> postman.forget(own.number, own.now()),
                        () -> own.worker.turns().end(own.number));
        own.worker.leave();
    }

    /// Something that Python listens to has happened. On the agent's lane.
    ///
    /// @param number under which it listens
    /// @param newest whether a later one counts instead, when the agent is slow in real time
    private void deliver(int number, boolean newest, @Nullable Object value) {
        Life own = life;
        if (own == null) {
            return;
        }
        var told = Optional.ofNullable(value);
        if (own.worker.postman().isPresent()) {
            post(own, number, newest, turns -> turns.hear(own.number, own.now(), number, told));
        } else if (own.worker.turns().gather(own.number, number, told)) {
            comeLater(own);
        }
    }

    /// After all that happens to the agents of the run in this phase of the instant.
    private static void comeLater(Life own) {
        own.self.scheduler().after(Duration.ZERO, Phase.THINK, () -> {
            if (!own.worker.turns().take(own.number, own.now())) {
                comeLater(own);
            }
        });
    }

    private static void post(Life own, int number, boolean newest, Consumer<PythonTurns> turn) {
        Instant posted = own.now();
        own.lateness.posted(posted);
        Consumer<Instant> bring = since -> {
            if (own.ended.isDone()) {
                return;
            }
            Instant now = own.now();
            own.lateness.brought(since, now);
            own.worker.begin(now);
            try {
                turn.accept(own.worker.turns());
            } catch (RuntimeException e) {
                own.self.scheduler().execute(() -> {
                    throw e;
                });
            } finally {
                own.worker.end();
            }
        };
        own.worker.postman().orElseThrow().post(own.number, new Postman.Letter(number, newest, posted, bring));
    }

    /// What Python asks for in real time, on the thread that waits for it: it is done on the agent's lane.
    private record FarPeer(Life own) implements PythonTurns.Peer {
        @Override
        public void perform(List<?> asked) {
            if (!asked.isEmpty()) {
                own.self.scheduler().execute(() -> own.requests.perform(asked));
            }
        }

        @Override
        public @Nullable Object answer(List<?> asked) {
            var answer = new CompletableFuture<@Nullable Object>();
            own.self.scheduler().execute(() -> {
                try {
                    answer.complete(own.requests.answer(asked));
                } catch (RuntimeException e) {
                    answer.completeExceptionally(e);
                }
            });
            var _ = own.ended.thenRun(() -> answer.cancel(false));
            try {
                return answer.join();
            } catch (CancellationException _) {
                throw new IllegalStateException("The agent has ended.");
            } catch (CompletionException e) {
                throw e.getCause() instanceof RuntimeException why ? why : e;
            }
        }
    }
}
