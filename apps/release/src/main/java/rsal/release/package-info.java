/// Packs releases: for each [TargetSystem] an [Archive] with RSAL's jars, page and documentation, a
/// Java runtime for that system ([JavaRuntimes]), licences and a list of all parts ([Components]). The same inputs
/// give the same bytes.
@NullMarked
package rsal.release;

import org.jspecify.annotations.NullMarked;
