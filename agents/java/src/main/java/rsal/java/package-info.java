/// Java files of agents and plugins: read, compiled and loaded.
@NullMarked
package rsal.java;

import org.jspecify.annotations.NullMarked;
