/// Commands on files of data: localization and mapping from logs of robots, conversion of worlds and models, export
/// of recordings.
@NullMarked
package rsal.cli.log;

import org.jspecify.annotations.NullMarked;
