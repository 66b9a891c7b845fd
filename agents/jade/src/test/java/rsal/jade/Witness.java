package rsal.jade;

import static org.assertj.core.api.Assertions.assertThat;

import jade.content.AgentAction;
import jade.content.ContentElement;
import jade.content.lang.sl.SLCodec;
import jade.content.onto.basic.Action;
import jade.content.onto.basic.Done;
import jade.core.AID;
import jade.core.Agent;
import jade.core.ServiceException;
import jade.core.behaviours.CyclicBehaviour;
import jade.core.behaviours.OneShotBehaviour;
import jade.core.messaging.TopicManagementHelper;
import jade.domain.FIPANames;
import jade.domain.JADEAgentManagement.JADEManagementOntology;
import jade.domain.JADEAgentManagement.SniffOn;
import jade.domain.introspection.IntrospectionOntology;
import jade.domain.introspection.Occurred;
import jade.domain.introspection.SentMessage;
import jade.lang.acl.ACLCodec;
import jade.lang.acl.ACLMessage;
import jade.lang.acl.MessageTemplate;
import jade.lang.acl.StringACLCodec;
import java.io.StringReader;
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
        getContentManager().registerLanguage(new SLCodec(), FIPANames.ContentLanguage.FIPA_SL0);
        getContentManager().registerOntology(JADEManagementOntology.getInstance());
        getContentManager().registerOntology(IntrospectionOntology.getInstance());
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

    /// Asks the management system, as JADE's windows do. Does not wait for its answer.
    void asksTheSystem(AgentAction action) {
        does(() -> {
            var request = new ACLMessage(ACLMessage.REQUEST);
            request.addReceiver(getAMS());
            request.setLanguage(FIPANames.ContentLanguage.FIPA_SL0);
            request.setOntology(JADEManagementOntology.NAME);
            request.setProtocol(FIPANames.InteractionProtocol.FIPA_REQUEST);
            getContentManager().fillContent(request, new Action(getAMS(), action));
            send(request);
            return true;
        });
    }

    /// From now on hears what these say, too, as JADE's window of that does.
    void sniffs(String... agents) {
        var sniff = new SniffOn();
        sniff.setSniffer(getAID());
        for (String agent : agents) {
            sniff.addSniffedAgents(getAID(agent));
        }
        asksTheSystem(sniff);
        for (int i = 0; i < agents.length; i++) {
            assertThat(what(hears())).isInstanceOf(Done.class); // one of them is watched
        }
    }

    /// The next that is said by one whom it sniffs.
    ACLMessage overhears() {
        while (true) {
            if (what(hears()) instanceof Occurred occurred
                    && occurred.getWhat().getWhat() instanceof SentMessage sent) {
                return parsed(sent.getMessage().getPayload());
            }
        }
    }

    private ContentElement what(ACLMessage message) {
        return does(() -> getContentManager().extractContent(message));
    }

    /// As it stands in windows and files.
    private static ACLMessage parsed(String message) {
        try {
            return new StringACLCodec(new StringReader(message), null).decode();
        } catch (ACLCodec.CodecException e) {
            throw new AssertionError(message, e);
        }
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
