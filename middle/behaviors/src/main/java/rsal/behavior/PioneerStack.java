package rsal.behavior;

import rsal.robot.RobotModel;

/// The behaviors of the thesis's Pioneers (ch. 3.6.2), with its numbers.
public final class PioneerStack {
    private static final double MAX_SPEED = 0.4; // m/s
    private static final double MAX_TURN_RATE = 1.0; // rad/s
    private static final double WALL_DISTANCE = 0.5; // m
    private static final double STOP_DISTANCE = 0.2; // m

    private PioneerStack() {}

    /// Follows the wall on its left: `follow-wall`, under the layers of [#safe].
    public static Subsumption followLeftWall(RobotModel model) {
        return safe(model, "follow-wall", new FollowLeftWall(model.footprint(), MAX_SPEED, WALL_DISTANCE));
    }

    /// Drives ahead as long as it can and turns away from what is in its way: `wander`, under the layers of [#safe].
    public static Subsumption wander(RobotModel model) {
        return safe(model, "wander", new Wander(model.footprint(), MAX_SPEED));
    }

    /// Any behavior made safe: `avoid-collision`, `escape`, `limit-turn-rate`, `limit-speed` above it.
    public static Subsumption safe(RobotModel model, String name, Behavior behavior) {
        var body = model.footprint();
        return new Subsumption()
                .layer(name, behavior)
                .layer("avoid-collision", new AvoidCollision(body))
                .layer("escape", new EscapeWhenStuck(body))
                .layer("limit-turn-rate", new LimitTurnRate(body, MAX_TURN_RATE))
                .layer("limit-speed", new LimitSpeed(body, MAX_SPEED, STOP_DISTANCE));
    }
}
