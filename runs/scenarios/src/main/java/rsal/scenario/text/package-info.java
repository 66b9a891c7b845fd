/// Numbers and lists in words for people, and lines of CSV.
@NullMarked
package rsal.scenario.text;

import org.jspecify.annotations.NullMarked;
