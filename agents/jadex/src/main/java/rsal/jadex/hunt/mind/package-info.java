/// Minds on Jadex's BDI kernel. Compiled for Java 10, so no records, switches and the like here, and nothing of RSAL
/// that is newer.
@NullMarked
package rsal.jadex.hunt.mind;

import org.jspecify.annotations.NullMarked;
