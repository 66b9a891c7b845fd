package rsal.bench.bare;

import jade.core.AID;
import jade.core.Agent;
import jade.core.ServiceException;
import jade.core.behaviours.CyclicBehaviour;
import jade.core.behaviours.OneShotBehaviour;
import jade.core.behaviours.TickerBehaviour;
import jade.core.messaging.TopicManagementHelper;
import jade.domain.FIPANames.InteractionProtocol;
import jade.lang.acl.ACLMessage;
import jade.proto.ContractNetInitiator;
import jade.proto.ContractNetResponder;
import java.util.List;
import java.util.Vector;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rsal.bare.BareSystem;
import rsal.bare.Life;
import rsal.jade.JadePlatform;

/// JADE's agents, which tell each other their poses by a topic, as one message to each of a hundred instead stands a
/// hundredth of that, and bid by JADE's own contract net.
public final class BareJade implements BareSystem {
    @Override
    public String key() {
        return "jade";
    }

    @Override
    public BareSystem.Platform start() {
        var platform = JadePlatform.startBare();
        var agents = new CopyOnWriteArrayList<Teller>();
        return new BareSystem.Platform() {
            @Override
            public void start(int count, Life life) {
                List<Teller> all =
                        Stream.generate(() -> new Teller(life)).limit(count).toList();
                agents.addAll(all);
                for (int i = 0; i < count; i++) {
                    platform.start("agent-" + i, all.get(i));
                }
            }

            @Override
            public void say(int times) {
                agents.forEach(agent -> agent.say(times));
            }

            @Override
            public void contract(int bidders, Runnable ended) {
                List<String> names =
                        IntStream.range(0, bidders).mapToObj(i -> "bidder-" + i).toList();
                var manager = new Manager(names.stream().map(platform::agent).toList(), ended);
                var missing = new AtomicInteger(bidders);
                names.forEach(name -> platform.start(name, new Bidder(() -> {
                    // what is said while agents start may be lost, and its net would not end
                    if (missing.decrementAndGet() == 0) {
                        platform.start("manager", manager);
                    }
                })));
            }

            @Override
            public void close() {
                platform.endSoon();
            }
        };
    }

    private static final class Teller extends Agent {
        private final transient Life life;
        private final ACLMessage pose = new ACLMessage(ACLMessage.INFORM);

        Teller(Life life) {
            this.life = life;
        }

        @Override
        protected void setup() {
            pose.addReceiver(listen());
            pose.setContent(POSE.toString());
            addBehaviour(new CyclicBehaviour() {
                @Override
                public void action() {
                    ACLMessage message = receive();
                    if (message == null) {
                        block();
                    } else if (!message.getSender().equals(getAID())) { // the topic brings one's own, too
                        life.heard().run();
                    }
                }
            });
            if (!life.period().isZero()) {
                addBehaviour(new TickerBehaviour(this, life.period().toMillis()) {
                    @Override
                    protected void onTick() {
                        send(pose);
                    }
                });
            }
            life.begun().run();
        }

        private AID listen() {
            try {
                var topics = (TopicManagementHelper) getHelper(TopicManagementHelper.SERVICE_NAME);
                AID topic = topics.createTopic("pose");
                topics.register(topic);
                return topic;
            } catch (ServiceException e) {
                throw new IllegalStateException("JADE has no topics.", e);
            }
        }

        void say(int times) {
            addBehaviour(new OneShotBehaviour() {
                @Override
                public void action() {
                    for (int i = 0; i < times; i++) {
                        send(pose);
                    }
                }
            });
        }
    }

    private static final class Manager extends Agent {
        private final List<AID> bidders;
        private final transient Runnable ended;

        Manager(List<AID> bidders, Runnable ended) {
            this.bidders = bidders;
            this.ended = ended;
        }

        @Override
        protected void setup() {
            addBehaviour(new Net(this));
        }

        private ACLMessage call() {
            var call = new ACLMessage(ACLMessage.CFP);
            call.setProtocol(InteractionProtocol.FIPA_CONTRACT_NET);
            call.setContent("task");
            bidders.forEach(call::addReceiver);
            return call;
        }
    }

    /// One, and then the next.
    private static final class Net extends ContractNetInitiator {
        private final transient Manager manager;

        Net(Manager manager) {
            super(manager, manager.call());
            this.manager = manager;
        }

        @Override
        @SuppressWarnings({"rawtypes", "unchecked", "JdkObsolete"}) // as JADE has it
        protected void handleAllResponses(Vector responses, Vector acceptances) {
            for (Object response : responses) {
                int answer = acceptances.isEmpty() ? ACLMessage.ACCEPT_PROPOSAL : ACLMessage.REJECT_PROPOSAL;
                acceptances.add(reply((ACLMessage) response, answer, ""));
            }
        }

        @Override
        protected void handleInform(ACLMessage inform) {
            manager.ended.run();
            manager.addBehaviour(new Net(manager));
        }
    }

    private static final class Bidder extends Agent {
        private final transient Runnable begun;

        Bidder(Runnable begun) {
            this.begun = begun;
        }

        @Override
        protected void setup() {
            addBehaviour(
                    new ContractNetResponder(
                            this, ContractNetResponder.createMessageTemplate(InteractionProtocol.FIPA_CONTRACT_NET)) {
                        @Override
                        protected ACLMessage handleCfp(ACLMessage call) {
                            return reply(call, ACLMessage.PROPOSE, "1.0");
                        }

                        @Override
                        protected ACLMessage handleAcceptProposal(
                                ACLMessage call, ACLMessage proposal, ACLMessage acceptance) {
                            return reply(acceptance, ACLMessage.INFORM, "done");
                        }
                    });
            begun.run();
        }
    }

    private static ACLMessage reply(ACLMessage message, int performative, String content) {
        ACLMessage reply = message.createReply();
        reply.setPerformative(performative);
        reply.setContent(content);
        return reply;
    }
}
