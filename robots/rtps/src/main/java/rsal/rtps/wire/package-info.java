/// RTPS messages as bytes: submessages, GUIDs, locators, sets of numbers and parameter lists (DDSI-RTPS 2.5, chapters
/// 8.3 and 9.4).
@NullMarked
package rsal.rtps.wire;

import org.jspecify.annotations.NullMarked;
