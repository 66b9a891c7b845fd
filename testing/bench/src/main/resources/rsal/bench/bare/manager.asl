// Has all others bid for tasks, one contract net after the other.

moment(0).  // How long it waits before the next [ms].
count(0).   // Nets that have ended.

all_bid(Id) :- bidders(All) & .length(All, N) & .count(propose(Id, _)[source(_)], N).

!begin.
+!begin
   <- .my_name(Me);
      .all_names(All);
      .delete(Me, All, Bidders);
      +bidders(Bidders);
      !!call(1).

+!call(Id) : bidders(Bidders)
   <- +calling(Id);
      .send(Bidders, tell, cfp(Id, task)).

@award[atomic]
+propose(Id, _) : calling(Id) & all_bid(Id) & bidders(Bidders)
   <- -calling(Id);
      .findall(offer(Cost, Who), propose(Id, Cost)[source(Who)], Offers);
      .abolish(propose(Id, _));
      .min(Offers, offer(_, Winner));
      .send(Winner, tell, accept_proposal(Id));
      .delete(Winner, Bidders, Losers);
      .send(Losers, tell, reject_proposal(Id)).

@done[atomic]
+done(Id) : count(N)
   <- .abolish(done(Id));
      -+count(N + 1);
      !!next(Id + 1).

+!next(Id) : moment(0)
   <- !call(Id).
+!next(Id) : moment(Time)
   <- .wait(Time);
      !call(Id).
