/// Reads worlds of the Stage simulator: [WorldFile] knows how they are written, [StageWorld] what they mean.
/// Nothing here moves. Lengths are in m, angles in rad, energies in J, powers in W, whatever units a file uses.
@NullMarked
package rsal.stage;

import org.jspecify.annotations.NullMarked;
