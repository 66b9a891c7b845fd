/// Pictures of worlds and of scenarios' beginnings, for people who choose among them.
@NullMarked
package rsal.scenario.picture;

import org.jspecify.annotations.NullMarked;
