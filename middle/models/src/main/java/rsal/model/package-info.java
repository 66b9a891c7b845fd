/// Robot models and parts, read from YAML files.
@NullMarked
package rsal.model;

import org.jspecify.annotations.NullMarked;
