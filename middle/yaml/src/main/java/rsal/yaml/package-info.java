/// Reads YAML strictly, from disk, a folder or the class path, with the line and column of each value.
@NullMarked
package rsal.yaml;

import org.jspecify.annotations.NullMarked;
