package rsal.engine;

import java.util.Optional;
import rsal.engine.report.RunObserver;
import rsal.system.RobotRecorder;

/// Who observes a run, and who records its robots, if anybody does.
record RunMonitors(Optional<RunObserver> observer, Optional<RobotRecorder> recorder) {}
