package rsal.agents.exploration;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import rsal.agent.AgentContext;
import rsal.device.Mapper;
import rsal.robot.Robot;

/// What a robot does by itself when nobody wants it elsewhere: mapping, if it has a device for that which was at it
/// when its agent came.
public final class Exploring {
    private final AgentContext self;
    private final Optional<Mapper> mapper;
    private String said = "";

    private Exploring(AgentContext self, Optional<Mapper> mapper) {
        this.self = self;
        this.mapper = mapper;
    }

    public static Exploring of(AgentContext self, Robot robot) {
        return new Exploring(self, robot.find(Mapper.class).filter(device -> !device.paused()));
    }

    /// Says what it does from now on.
    ///
    /// @param free whether nobody wants the robot elsewhere
    public void begin(BooleanSupplier free) {
        say();
        mapper.ifPresent(device -> self.subscribe(device, _ -> {
            if (free.getAsBoolean() && !said.equals(words())) {
                say();
            }
        }));
    }

    public void say() {
        said = words();
        self.state(said);
    }

    private String words() {
        return mapper.map(device -> device.isComplete() ? "all is mapped" : "exploring")
                .orElse("waiting for a victim");
    }

    /// Whether there is nothing left that it would do, as far as is known now.
    public boolean isDone() {
        return mapper.map(Mapper::isComplete).orElse(true);
    }

    /// Lets others drive the robot.
    public void pause() {
        mapper.ifPresent(Mapper::pause);
    }

    public void goOn() {
        mapper.ifPresent(Mapper::resume);
    }
}
