package rsal.metric;

import java.util.Optional;
import rsal.data.Pose2d;

/// A robot in a run.
///
/// @param mapFromBase where it truly is; of a real robot whose true pose nobody knows, where it believes to be.
///         Empty when neither is known.
/// @param isTrue whether this is its true pose
public record RobotState(String id, String role, Optional<Pose2d> mapFromBase, boolean isTrue) {}
