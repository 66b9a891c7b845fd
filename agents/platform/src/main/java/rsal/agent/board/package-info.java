/// Notes that a team shares: a master keeps them ([rsal.agent.board.BoardKeeper]), the others write, ask and watch by
/// conversations with it ([rsal.agent.board.TeamBoard]), so that loss, delay, range and silence of communication apply.
///
/// Each note belongs to the agent that wrote it, which alone can replace or erase it; so two that write under one
/// name do not disturb each other, and one that floods the board fills its own room only. Each fades when its time
/// is up, for the master and for all who have heard of it, whether they can hear each other or not.
///
/// The author of a note keeps it, too, and writes it again when another master takes over: what is lost with a master
/// is what agents wrote that have ended. Until there is one, notes wait with their authors, and those who watch go on
/// with what they have heard.
@NullMarked
package rsal.agent.board;

import org.jspecify.annotations.NullMarked;
