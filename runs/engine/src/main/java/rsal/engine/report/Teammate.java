package rsal.engine.report;

import java.util.Optional;
import rsal.data.Solid;
import rsal.robot.RobotSpec;

/// A robot that is or was part of a run.
///
/// @param body as people see it, each piece in its color; empty when nobody knows more than its model does
public record Teammate(RobotSpec spec, Optional<Solid> body) {}
