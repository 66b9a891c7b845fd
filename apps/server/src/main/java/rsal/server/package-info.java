/// One run at a time, seen by any number of browsers on this machine. Everything here happens on the server's
/// threads and sees the run only as immutable snapshots, so that watching neither changes a run nor slows it.
@NullMarked
package rsal.server;

import org.jspecify.annotations.NullMarked;
