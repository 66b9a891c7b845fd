/// Agents on JADE: each has a JADE agent that lends it its thread, and what they say is carried as ACL messages.
@NullMarked
package rsal.jade;

import org.jspecify.annotations.NullMarked;
