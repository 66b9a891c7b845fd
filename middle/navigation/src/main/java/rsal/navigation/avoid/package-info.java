/// What all local planners share: what they see, what they may do, what they answer to, and who has the last word.
@NullMarked
package rsal.navigation.avoid;

import org.jspecify.annotations.NullMarked;
