package rsal.agent.team;

import java.util.List;
import java.util.Map;
import java.util.Set;
import rsal.settings.PluginChoice;

/// How the jobs of a call are auctioned among the members.
///
/// @param team name of the agent that calls
/// @param number of the call, from 1
/// @param allocation an [AllocationType]
/// @param members names of all that are called
/// @param barred numbers of jobs at which a member has failed lately, by its name
record AuctionTerms(
        String team, int number, PluginChoice allocation, List<String> members, Map<String, Set<Integer>> barred) {
    AuctionTerms {
        members = List.copyOf(members);
        barred = Map.copyOf(barred);
    }

    /// Costs without the jobs that a member may not do.
    Estimate allowed(String member, Estimate estimate) {
        Set<Integer> out = barred.getOrDefault(member, Set.of());
        return out.isEmpty() ? estimate : estimate.without(out);
    }
}
