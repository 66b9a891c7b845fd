/// Agents that believe, want and intend, in plain Java: beliefs tell what an agent takes for true, goals what it wants
/// and how much, plans how a goal may be reached, and intentions what it is about to do. The most urgent goal that is
/// wanted gets the agent; one that was pursued waits and goes on later; a plan that fails makes room for the next.
///
/// ```java
/// var mind = new Mind(self);
/// Belief<Double> charge = mind.belief("charge", 1.0);
/// mind.goal("recharge").priority(() -> 10).when(() -> charge.get() < 0.2).until(() -> charge.get() > 0.9)
///     .plan("dock", doing -> dock(doing))
///     .plan("call for help", doing -> callForHelp(doing));
/// mind.goal("explore").priority(() -> 1).plan("wander", doing -> wander(doing));
/// mind.begin();
/// ```
///
/// Sources: A. S. Rao and M. P. Georgeff, "BDI agents: from theory to practice" (1995), for the cycle; A. Pokahr, L.
/// Braubach and W. Lamersdorf, "A goal deliberation strategy for BDI agent systems" (2005), for goals with contexts
/// that wait as options while others are pursued; A. S. Rao, "AgentSpeak(L)" (1996), for plans with contexts that are
/// tried one after the other. Other than there, one intention is pursued at a time, because there is one robot.
@NullMarked
package rsal.agent.bdi;

import org.jspecify.annotations.NullMarked;
