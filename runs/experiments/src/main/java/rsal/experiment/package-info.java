/// Many runs of a scenario: the plan of an experiment, its runs, and their rows on disk.
@NullMarked
package rsal.experiment;

import org.jspecify.annotations.NullMarked;
