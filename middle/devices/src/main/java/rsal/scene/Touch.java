package rsal.scene;

/// What becomes of a robot that drives into something.
public enum Touch {
    /// It stops where it touches, wheels and all, until it drives elsewhere: as in Stage, and as most robots do.
    STALL,

    /// It slides along what it touches, without friction, as far as its way leads past it; its wheels slip, so that
    /// odometry counts more than it moves. Where nothing is left of its way it stalls.
    SLIDE
}
