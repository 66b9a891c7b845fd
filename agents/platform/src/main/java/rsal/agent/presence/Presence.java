package rsal.agent.presence;

import rsal.agent.AgentContext;
import rsal.agent.message.Hello;
import rsal.agent.message.Hello.Kind;
import rsal.robot.Robot;

/// Being there: says so at the start and the end, and when somebody asks.
public final class Presence {
    private Presence() {}

    /// Says hello, and from now on answers all that ask.
    public static void begin(AgentContext self) {
        self.subscribe(Hello.TOPIC, message -> {
            if (message.content().kind() == Kind.PING) {
                self.send(message.sender(), Hello.TOPIC, hello(self, Kind.PONG, message.sender()));
            }
        });
        self.publish(Hello.TOPIC, hello(self, Kind.HELLO, ""));
    }

    /// Says bye.
    public static void end(AgentContext self) {
        self.publish(Hello.TOPIC, hello(self, Kind.BYE, ""));
    }

    private static Hello hello(AgentContext self, Kind kind, String to) {
        return new Hello(self.robot().map(Robot::id).orElse(""), kind, to);
    }
}
