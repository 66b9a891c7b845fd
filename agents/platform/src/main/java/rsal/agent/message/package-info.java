/// What agents of this project say to each other: one record a message, one [rsal.agent.Topic] a channel.
@NullMarked
package rsal.agent.message;

import org.jspecify.annotations.NullMarked;
