/// Java files of agents: read, compiled and loaded.
@NullMarked
package rsal.java;

import org.jspecify.annotations.NullMarked;
