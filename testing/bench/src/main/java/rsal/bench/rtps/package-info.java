/// How well ROS 2's protocol does on this machine: participants of one process that find each other over the
/// loopback network, lose datagrams, leave and come back.
@NullMarked
package rsal.bench.rtps;

import org.jspecify.annotations.NullMarked;
