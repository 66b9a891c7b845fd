package rsal.agents;

import java.util.Optional;
import rsal.device.Mapper;
import rsal.robot.Robot;

/// What a robot does by itself when nobody wants it elsewhere: mapping, if it has a device for that which was at it
/// when its agent came.
final class Exploring {
    private final Optional<Mapper> mapper;

    private Exploring(Optional<Mapper> mapper) {
        this.mapper = mapper;
    }

    static Exploring of(Robot robot) {
        return new Exploring(robot.find(Mapper.class).filter(device -> !device.paused()));
    }

    /// Whether there is anything that it does by itself.
    boolean isAtIt() {
        return mapper.isPresent();
    }

    /// Lets others drive the robot.
    void pause() {
        mapper.ifPresent(Mapper::pause);
    }

    void goOn() {
        mapper.ifPresent(Mapper::resume);
    }

    /// For people.
    String words() {
        return mapper.map(device -> device.isComplete() ? "all is mapped" : "exploring")
                .orElse("waiting for a victim");
    }
}
