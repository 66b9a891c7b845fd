/// The agent contract: an agent is started with a context, through which it has a name, a robot, time,
/// randomness, topics, a directory of the others and a blackboard. Everything of one agent happens on its lane;
/// on the plain host all lanes are the run's thread.
@NullMarked
package rsal.agent;

import org.jspecify.annotations.NullMarked;
