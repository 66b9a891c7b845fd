/// What all commands share: options, exit codes, progress, output for people and for programs.
@NullMarked
package rsal.cli.terminal;

import org.jspecify.annotations.NullMarked;
