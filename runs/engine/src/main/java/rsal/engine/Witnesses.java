package rsal.engine;

import java.util.Optional;
import rsal.engine.report.RunObserver;
import rsal.system.RobotRecorder;

/// Who sees all of a run, and who records its robots, if anybody does.
record Witnesses(Optional<RunObserver> observer, Optional<RobotRecorder> recorder) {}
