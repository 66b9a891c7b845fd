/// A server that shows runs and recordings in a browser. Everything here happens on the server's threads and
/// sees runs only as immutable snapshots, so that watching neither changes a run nor slows it.
@NullMarked
package rsal.server;

import org.jspecify.annotations.NullMarked;
