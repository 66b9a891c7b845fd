/// The host `jadex`: each agent is a micro agent of a Jadex platform in this process, which listens to nobody outside.
@NullMarked
package rsal.jadex;

import org.jspecify.annotations.NullMarked;
