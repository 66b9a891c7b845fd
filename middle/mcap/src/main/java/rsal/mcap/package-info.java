/// Files of messages with their times, as the specification of MCAP has them (mcap.dev/spec, version 0): written as
/// they come, read by time and topic, and read as far as they go when they are cut off or damaged.
@NullMarked
package rsal.mcap;

import org.jspecify.annotations.NullMarked;
