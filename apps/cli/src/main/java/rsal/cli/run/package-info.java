/// Commands that start a run or play a recording.
@NullMarked
package rsal.cli.run;

import org.jspecify.annotations.NullMarked;
