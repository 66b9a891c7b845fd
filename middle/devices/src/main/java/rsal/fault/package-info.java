/// What goes wrong with robots on purpose, so that it can be seen what their agents make of it: the faults, what a
/// sensor shows that has one, and who can bring them about.
@NullMarked
package rsal.fault;

import org.jspecify.annotations.NullMarked;
