/// What travels as JSON between page and server, and refusals.
@NullMarked
package rsal.server.message;

import org.jspecify.annotations.NullMarked;
