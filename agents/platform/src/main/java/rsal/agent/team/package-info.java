/// A team that is given work as a whole: jobs are allotted by contract net to the members that can do them at
/// the least cost, watched, and given to others when a member fails, falls silent or is not fit for them any
/// more. Members that come late or are back join at the next call.
///
/// One agent keeps the books ([rsal.agent.team.Team]); each member has a [rsal.agent.team.Worker] with the
/// skills that its robot's devices allow.
///
/// Sources: R. G. Smith, "The Contract Net Protocol" (1980), for calls and bids; B. P. Gerkey and M. J.
/// Matarić, "A formal analysis and taxonomy of task allocation in multi-robot systems" (2004), for the kinds of
/// allotment (single robots, single tasks, at once or in routes). In the contract net a bid tells what each job would
/// cost, also after each other, so that one round is enough to divide all jobs ([rsal.agent.team.JobRoutes]).
///
/// Other ways to allocate are plugins ([rsal.agent.team.AllocationType]): sequential single-item auctions and the
/// consensus-based bundle algorithm, in which the members divide the jobs among themselves by messages
/// ([rsal.agent.team.AuctionRoom]). The agent with the jobs still awards them, so that each is done once.
@NullMarked
package rsal.agent.team;

import org.jspecify.annotations.NullMarked;
