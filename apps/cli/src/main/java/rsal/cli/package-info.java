/// One class per command, and what they share: exit codes, output for people and for programs.
@NullMarked
package rsal.cli;

import org.jspecify.annotations.NullMarked;
