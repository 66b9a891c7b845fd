/// A run from start to result: how it is started, executed, watched and told what to do. All other packages are
/// below this one, and each knows only those before it: report, event, arbitration, robot, metric, communication,
/// then world, agent and operator.
@NullMarked
package rsal.engine;

import org.jspecify.annotations.NullMarked;
