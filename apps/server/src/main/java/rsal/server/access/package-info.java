/// Who may reach a server from elsewhere, and what they may do there: a [Role] for each token, and where it is
/// [Listening].
@NullMarked
package rsal.server.access;

import org.jspecify.annotations.NullMarked;
