package rsal.player.bridge;

import java.util.Optional;
import rsal.data.Odometry;
import rsal.data.Twist2d;

/// How a client wants a base to move, until it wants something else.
interface ClientCommand {
    /// @return empty when there is nothing left to do
    Optional<Twist2d> now(Odometry odometry);
}
