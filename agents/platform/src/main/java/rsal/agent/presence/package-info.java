/// Who is there, as far as agents can hear: those who are say so when they come, when they go and when somebody asks;
/// those that keep a roll notice who has fallen silent.
@NullMarked
package rsal.agent.presence;

import org.jspecify.annotations.NullMarked;
