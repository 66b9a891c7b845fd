package rsal.jade;

import jade.core.AID;
import jade.core.Agent;
import jade.core.ServiceException;
import jade.core.behaviours.CyclicBehaviour;
import jade.core.behaviours.OneShotBehaviour;
import jade.core.behaviours.TickerBehaviour;
import jade.core.messaging.TopicManagementHelper;
import jade.lang.acl.ACLMessage;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import rsal.agent.bare.BareSystem;
import rsal.agent.bare.Life;

/// JADE's agents, which tell each other their poses by a topic: one message to each of a hundred instead stands a
/// hundredth of that.
public final class BareJade implements BareSystem {
    @Override
    public String key() {
        return "jade";
    }

    @Override
    public BareSystem.Platform start() {
        var platform = rsal.jade.Platform.start();
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
}
