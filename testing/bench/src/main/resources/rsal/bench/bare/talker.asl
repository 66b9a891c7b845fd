// Tells all others its pose, and again whenever it has been told as many as there are others.

moment(0).  // How long it waits before it does so again [ms].
count(0).

!begin.
@begin[atomic] // before it hears anything
+!begin
   <- .all_names(All);
      .length(All, N);
      +others(N - 1);
      !!tell.

+!tell
   <- .broadcast(signal, pose(0, 0, 0)).

@last[atomic]
+pose(_, _, _)[source(_)] : count(N) & others(M) & (N + 1) mod M == 0
   <- -+count(N + 1);
      !!again.
@heard[atomic]
+pose(_, _, _)[source(_)] : count(N)
   <- -+count(N + 1).

+!again : moment(0)
   <- !tell.
+!again : moment(Time)
   <- .wait(Time);
      !tell.
