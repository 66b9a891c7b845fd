/// Tries agents of people's own: [TestAgentCommand] with several seeds, [GradeCommand] those that students hand in.
/// Each run is a process of its own ([SeparateRun]): an agent that never returns, or takes all memory, ends its own
/// run only.
@NullMarked
package rsal.cli.grade;

import org.jspecify.annotations.NullMarked;
