package rsal.jade;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.util.Date;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.agent.Message;
import rsal.agent.protocol.Act;

/// A message of ours as JADE carries it. Its tools see an ACL message with the words that people see; who it is for
/// gets the content itself, which never leaves this process.
///
/// Copies, which JADE makes, are of the same message.
final class Utterance extends ACLMessage {
    static final String ONTOLOGY = "rsal";
    /// Parameter that names the topic of what is said to one.
    static final String TOPIC = "X-topic";

    private final transient @Nullable Consumer<String> arrival; // null after a way through a file or a socket of JADE's

    private Utterance(int performative, Consumer<String> arrival) {
        super(performative);
        this.arrival = arrival;
    }

    /// @param receiver that agent, or that topic
    /// @param arrival to be told whom it has reached
    static Utterance of(Message<?> message, AID receiver, Consumer<String> arrival) {
        var utterance = new Utterance(performative(message.content()), arrival);
        utterance.addReceiver(receiver);
        utterance.setOntology(ONTOLOGY);
        utterance.addUserDefinedParameter(IGNORE_FAILURE, "true"); // who is not there does not hear it
        if (!message.isForAll()) {
            utterance.addUserDefinedParameter(TOPIC, message.topic().name());
        }
        if (message.content() instanceof Act act) {
            utterance.setProtocol(act.protocol());
            utterance.setConversationId(act.conversation());
            act.replyBy().ifPresent(limit -> utterance.setReplyByDate(Date.from(limit)));
            utterance.setContent(act.content().toString());
        } else {
            utterance.setContent(String.valueOf(message.content()));
        }
        return utterance;
    }

    private static int performative(Object content) {
        return content instanceof Act act
                ? switch (act.performative()) {
                    case ACCEPT_PROPOSAL -> ACCEPT_PROPOSAL;
                    case AGREE -> AGREE;
                    case CANCEL -> CANCEL;
                    case CFP -> CFP;
                    case FAILURE -> FAILURE;
                    case INFORM -> INFORM;
                    case NOT_UNDERSTOOD -> NOT_UNDERSTOOD;
                    case PROPOSE -> PROPOSE;
                    case REFUSE -> REFUSE;
                    case REJECT_PROPOSAL -> REJECT_PROPOSAL;
                    case REQUEST -> REQUEST;
                    case SUBSCRIBE -> SUBSCRIBE;
                }
                : INFORM;
    }

    /// It has reached this agent.
    void arrive(String agent) {
        if (arrival != null) {
            arrival.accept(agent);
        }
    }
}
