/// What is installed and can be named in a scenario.
@NullMarked
package rsal.scenario.installed;

import org.jspecify.annotations.NullMarked;
