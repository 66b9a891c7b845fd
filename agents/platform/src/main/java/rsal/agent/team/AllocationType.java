package rsal.agent.team;

import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.settings.Plugin;
import rsal.settings.PluginChoice;
import rsal.settings.PluginKind;

/// A way to allocate the jobs of a team. Found by [java.util.ServiceLoader], or a Java file that a scenario names
/// (`allocation: Mine.java`).
///
/// Either the agent that has the jobs divides them, by [Rules], or the members do so among themselves in an
/// [Auction], each by its [Allocator].
public interface AllocationType extends Plugin {
    /// The parameter of an agent type that has jobs for a team.
    static Parameter<PluginChoice> parameter() {
        return Parameter.plugin(
                "allocation",
                "bids",
                PluginKind.of("allocation", AllocationType.class, ServiceLoader.load(AllocationType.class)),
                "decides which member of the team gets which job");
    }

    /// The rules of a team whose jobs are allocated in this way.
    ///
    /// @param usual as its agent has them otherwise
    default Rules rules(Rules usual) {
        return usual;
    }

    /// One member's part in an auction, or empty where the agent that has the jobs divides them. It is the same
    /// for all auctions whether there is one.
    ///
    /// @param arguments for [#parameters]
    default Optional<Allocator> create(Arguments arguments, Auction auction) {
        return Optional.empty();
    }

    /// Whether members divide the jobs among themselves.
    default boolean isAmongMembers() {
        return false;
    }

    /// What a member knows at the begin of an auction.
    ///
    /// @param self its name
    /// @param members names of all that were called, itself included, in the order of the alphabet
    /// @param estimate what the jobs would cost it
    record Auction(String self, List<String> members, Estimate estimate) {
        public Auction {
            members = members.stream().sorted().toList();
            if (!members.contains(self)) {
                throw new IllegalArgumentException("Member '%s' is not among '%s'.".formatted(self, members));
            }
        }

        /// How many jobs there are; they are numbered from 0.
        public int jobs() {
            return estimate.first().size();
        }
    }
}
