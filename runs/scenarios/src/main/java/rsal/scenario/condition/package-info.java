/// What can be asked of a run: conditions that end it and expressions that measure it, in a small closed grammar.
/// Texts become trees of records; nothing in them can run code.
@NullMarked
package rsal.scenario.condition;

import org.jspecify.annotations.NullMarked;
