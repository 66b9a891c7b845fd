/// What participants tell each other about themselves, their writers and readers (DDSI-RTPS 2.5, chapter 8.5 and 9.6).
@NullMarked
package rsal.rtps.discovery;

import org.jspecify.annotations.NullMarked;
