package rsal.agents;

import rsal.agent.AgentContext;
import rsal.agent.message.Hello;
import rsal.agent.message.Hello.Kind;
import rsal.robot.Robot;

/// Being there: says so at the start and the end, and when somebody asks.
final class Presence {
    private Presence() {}

    static void begin(AgentContext self) {
        self.subscribe(Hello.TOPIC, message -> {
            if (message.content().kind() == Kind.PING) {
                say(self, Kind.PONG, message.sender());
            }
        });
        say(self, Kind.HELLO, "");
    }

    static void end(AgentContext self) {
        say(self, Kind.BYE, "");
    }

    private static void say(AgentContext self, Kind kind, String to) {
        self.publish(Hello.TOPIC, new Hello(self.robot().map(Robot::id).orElse(""), kind, to));
    }
}
