package rsal.python;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.OutsideCode;
import rsal.device.Device;
import rsal.frame.FramePipe;
import rsal.frame.ToWords;
import rsal.robot.Robot;

/// A proxy of an agent that lives in a process of Python. What happens to it is sent there; what it asks for meanwhile
/// is done here, on its lane. Its own code runs nowhere else, so that radios, faults, recordings and the page see an
/// agent like any other.
final class PythonAgent implements Agent {
    private static final int LAST_WORDS = 200; // ms

    private final PythonType type;
    private final Map<String, Object> arguments;
    private @Nullable Life life;

    /// What it has once it has started.
    private record Life(
            AgentContext self,
            PythonWorker worker,
            int number,
            PythonRequests requests,
            CompletableFuture<Void> ended) {}

    /// @param arguments values of its parameters, by name
    PythonAgent(PythonType type, Map<String, Object> arguments) {
        this.type = type;
        this.arguments = arguments;
    }

    @Override
    public void start(AgentContext self) {
        PythonWorker worker = PythonWorker.enter(self.scheduler().run());
        var requests = new PythonRequests(self, this::deliver);
        var own = new Life(self, worker, worker.number(), requests, new CompletableFuture<>());
        life = own;
        self.atEnd(() -> end(own));
        self.outside(new OutsideCode() {
            @Override
            public Optional<String> place() {
                return worker.place();
            }

            @Override
            public boolean isDebugged() {
                return worker.isDebugged();
            }
        });
        send(own, 0, false, to -> begin(own, to));
    }

    private void begin(Life own, ToWords to) {
        AgentContext self = own.self;
        to.put("files", type.sources().texts())
                .put("path", type.sources().path())
                .put("class", type.className())
                .put("name", self.name())
                .put("role", self.role())
                .put("seed", own.requests.seed())
                .put("simulation", own.requests.simulation().isPresent())
                .put("robot", own.requests.robot().map(PythonAgent::described))
                .put("arguments", arguments);
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
    public void stop(AgentContext self) {
        Life own = life;
        if (own == null) {
            return;
        }
        if (own.worker.postman().isEmpty()) {
            own.worker.exchange(to -> head(own, to).put("stop", true), own.requests);
            return;
        }
        var said = new CompletableFuture<List<?>>();
        send(own, 0, false, to -> to.put("stop", true), new PythonWorker.Peer() {
            @Override
            public void perform(List<?> asked) {
                said.complete(asked);
            }

            @Override
            public @Nullable Object answer(List<?> asked) {
                throw new IllegalStateException("The agent is stopped and can't be asked any more.");
            }
        });
        try {
            own.requests.perform(said.get(LAST_WORDS, TimeUnit.MILLISECONDS));
        } catch (TimeoutException | ExecutionException _) {
            // the run does not wait for one that has more to say
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        }
    }

    private static void end(Life own) {
        own.ended.complete(null);
        own.worker
                .postman()
                .ifPresentOrElse(postman -> postman.forget(own.number), () -> own.worker.forget(own.number));
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
        if (own.worker.isBusy()) { // it follows from something that Python asks for just now
            own.self.scheduler().execute(() -> deliver(number, newest, value));
        } else {
            send(own, number, newest, to -> to.put("id", number).put("value", Optional.ofNullable(value)));
        }
    }

    private void send(Life own, int number, boolean newest, FramePipe.Content content) {
        if (own.worker.postman().isEmpty()) {
            own.worker.exchange(to -> content.write(head(own, to)), own.requests);
        } else {
            send(own, number, newest, content, new FarPeer(own));
        }
    }

    private static void send(Life own, int number, boolean newest, FramePipe.Content content, PythonWorker.Peer peer) {
        Runnable bring = () -> {
            if (own.ended.isDone()) {
                return;
            }
            try {
                own.worker.exchange(to -> content.write(head(own, to)), peer);
            } catch (RuntimeException e) {
                own.self.scheduler().execute(() -> {
                    throw e;
                });
            }
        };
        own.worker.postman().orElseThrow().post(own.number, new Postman.Letter(number, newest, bring));
    }

    private static ToWords head(Life own, ToWords to) {
        return to.put("agent", own.number)
                .put("time", ToWords.seconds(own.self.scheduler().instant()));
    }

    /// What Python asks for in real time, on the thread that waits for it: it is done on the agent's lane.
    private record FarPeer(Life own) implements PythonWorker.Peer {
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
