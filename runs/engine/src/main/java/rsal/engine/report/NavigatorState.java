package rsal.engine.report;

import java.util.Optional;
import rsal.data.Pose2d;

/// What a navigator is about.
///
/// @param mapFromGoal the goal under way
/// @param remaining length of the way that it intends to take [m]; 0 while it has none
/// @param paused whether it stands still meanwhile
public record NavigatorState(Optional<Pose2d> mapFromGoal, double remaining, boolean paused) {}
