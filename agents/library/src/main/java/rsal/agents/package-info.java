/// The agents that come with the project: navigators, hunters, wall followers, prey and viewers. Each is put
/// together from a few parts, as one reports its pose, another drives where people want it.
@NullMarked
package rsal.agents;

import org.jspecify.annotations.NullMarked;
