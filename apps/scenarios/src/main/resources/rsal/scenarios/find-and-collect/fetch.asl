// Has collectors fetch what explorers have found, by contract net: who is nearest and free gets it.

patience(1).  // How long it waits for bids [s].
again(3).     // After what time it calls again for what nobody could take on [s].

next(1).

distance(X1, Y1, X2, Y2, D) :- D = math.sqrt((X1 - X2) ** 2 + (Y1 - Y2) ** 2).
known(X, Y) :- thing(_, _, OtherX, OtherY) & distance(X, Y, OtherX, OtherY, D) & D < 0.6.
collected(X, Y) :- depot(_, DepotX, DepotY) & distance(X, Y, DepotX, DepotY, D) & D < 1.5.
carried(X, Y) :- at(_, RobotX, RobotY) & distance(X, Y, RobotX, RobotY, D) & D < 0.8.

!start.
+!start
   <- .df_register(fetch);
      state("nothing to fetch").

+heard(pose, _, pose_report(Robot, _, pose(X, Y, _)))
   <- -at(Robot, _, _);
      +at(Robot, X, Y).
+heard(depot, _, depot(Robot, point(X, Y), _))
   <- -depot(Robot, _, _);
      +depot(Robot, X, Y).

// Explorers say again what they still see: new is what lies in no depot and is on no robot.
@found[atomic]
+!found(Color, X, Y) : not known(X, Y) & not collected(X, Y) & not carried(X, Y) & next(Id)
   <- -+next(Id + 1);
      +thing(Id, Color, X, Y);
      !!allot(Id).
+!found(_, _, _).

+!allot(Id) : thing(Id, Color, X, Y) & patience(Seconds)
   <- .df_search(collect, Collectors);
      .send(Collectors, achieve, call(Id, Color, X, Y));
      .wait(Seconds * 1000);
      .findall(offer(Cost, Who), bid(Id, Cost)[source(Who)], Offers);
      .abolish(bid(Id, _));
      !award(Id, Offers).
+!allot(_).

+!award(Id, []) : again(Seconds)
   <- .wait(Seconds * 1000);
      !!allot(Id).
+!award(Id, Offers) : thing(Id, Color, X, Y)
   <- .min(Offers, offer(_, Winner));
      state("thing ", Id, " goes to ", Winner);
      .send(Winner, achieve, fetch(Id, Color, X, Y)).

+!refuse(Id)
   <- !!award(Id, []).
+!done(Id)
   <- .abolish(thing(Id, _, _, _)).
+!failed(Id) // when it still lies there, it will be found again
   <- .abolish(thing(Id, _, _, _)).
