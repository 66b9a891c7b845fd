package rsal.jade;

import jade.core.AID;
import jade.core.Agent;
import jade.core.ServiceException;
import jade.core.behaviours.CyclicBehaviour;
import jade.core.behaviours.OneShotBehaviour;
import jade.core.messaging.TopicManagementHelper;
import jade.lang.acl.ACLMessage;
import jade.lang.acl.MessageTemplate;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/// An agent as any JADE programmer writes one.
final class Witness extends Agent {
    private static final MessageTemplate TALK = MessageTemplate.not(MessageTemplate.or(
            MessageTemplate.MatchSender(new AID("df", AID.ISLOCALNAME)),
            MessageTemplate.MatchOntology("JADE-Agent-Management")));

    private final transient List<String> topics;
    private final transient BlockingQueue<ACLMessage> heard = new LinkedBlockingQueue<>();
    private final transient CompletableFuture<Boolean> ready = new CompletableFuture<>();

    Witness(String... topics) {
        this.topics = List.of(topics);
    }

    @Override
    protected void setup() {
        try {
            var helper = (TopicManagementHelper) getHelper(TopicManagementHelper.SERVICE_NAME);
            for (String topic : topics) {
                helper.register(helper.createTopic(topic));
            }
        } catch (ServiceException e) {
            throw new AssertionError(e);
        }
        addBehaviour(new CyclicBehaviour() {
            @Override
            public void action() {
                ACLMessage message = receive(TALK);
                if (message == null) {
                    block();
                } else {
                    heard.add(message);
                }
            }
        });
        ready.complete(true);
    }

    /// Waits until it listens.
    Witness ready() {
        join(ready);
        return this;
    }

    /// The next that it hears.
    ACLMessage hears() {
        try {
            ACLMessage next = heard.poll(20, TimeUnit.SECONDS);
            if (next == null) {
                throw new AssertionError("It hears nothing.");
            }
            return next;
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    boolean hasHeardAll() {
        return heard.isEmpty();
    }

    /// Does something on its own thread, as JADE's calls that wait for an answer must be.
    <T> T does(Deed<T> deed) {
        var result = new CompletableFuture<T>();
        addBehaviour(new OneShotBehaviour() {
            @Override
            public void action() {
                try {
                    result.complete(deed.done());
                } catch (Exception e) {
                    result.completeExceptionally(e);
                }
            }
        });
        return join(result);
    }

    private static <T> T join(CompletableFuture<T> future) {
        try {
            return future.get(20, TimeUnit.SECONDS);
        } catch (InterruptedException | ExecutionException | TimeoutException e) {
            throw new AssertionError(e);
        }
    }

    interface Deed<T> {
        T done() throws Exception;
    }
}
